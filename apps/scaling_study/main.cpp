// What a long row costs, ball by ball, beside methods that integrate every ball at every step.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "command_line/exit_code.hpp"
#include "command_line/program.hpp"
#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "mariotte/report/page/files.hpp"
#include "study.hpp"

namespace mariotte::scaling_study {
namespace {

struct CommandLine {
  Settings settings{.accuracies = {1e-8, 1e-12}};
  std::string csv;
  bool quick = false;
  bool force = false;
};

constexpr const char* notes = R"(
Errors are those of the velocities at both ends of the row, which are known in extended precision. Times are
CPU time; memory is what a process of its own takes above what it started with, the row itself included.
Once the wave is steady it is moved on; the second half of the table is with every ball followed (--flow
taylor), as in rows whose balls are not equal. Rivals are told when the impact ends and follow no events; the
last columns are their time over ours at an error no larger than theirs, both ways. Their lengths double
until the next would take longer than --patience.

Examples:
  scaling_study --quick
  scaling_study --accuracy 1e-10 --longest 1e5 --patience 10
  scaling_study --csv scaling.csv

Exit codes: 0 ok, 2 usage, 4 failure, 6 file error.
)";

command::OptionList declare(CommandLine& line) {
  return {{"--accuracy",
           &line.settings.accuracies,
           "Wanted error of the final velocities / incident speed; may be repeated",
           {.check = command::is_accuracy, .shows_default = true}},
          {"--longest",
           &line.settings.longest,
           "Balls of the longest row",
           {.check = command::Range{100, 1e7}, .shows_default = true}},
          {"--patience",
           &line.settings.patience,
           "Longest time of a rival's run [s]; 0 for none",
           {.check = command::NotNegative{}, .shows_default = true}},
          {"--csv", &line.csv, "Write every point into this file", {.value = "FILE"}},
          {"--quick", &line.quick, "Up to 10000 balls, rivals up to a second"},
          {"--force", &line.force, "Overwrite the file"}};
}

void tell(const Point& point) {
  std::fprintf(stderr, "%s, %zu balls: %.3g s\n", point.method.c_str(), point.balls, point.found.seconds);
}

int act(CommandLine& line) {
  if (!line.csv.empty() && !line.force && std::filesystem::exists(line.csv))
    throw report::FileError("cannot write " + line.csv + ": it exists already (--force overwrites)",
                            fault::exists);
  if (line.quick) line.settings.longest = 1e4, line.settings.patience = 1;
  auto points = study_own(line.settings, tell);
  command::print(table(points));
  for (const auto& method : own_methods)
    for (const double accuracy : line.settings.accuracies)
      command::print(fmt::format("{}, at {:.0e}: time grows like n^{:.2f}\n", method, accuracy,
                                 growth_exponent(points, method, accuracy)));
  if (line.settings.patience > 0) {
    const auto rivals = study_rivals(line.settings, tell);
    command::print("\n" + rival_table(rivals));
    points.insert(points.end(), rivals.begin(), rivals.end());
  }
  if (!line.csv.empty()) report::write_file(line.csv, csv(points));
  return command::ExitCode::ok;
}

}  // namespace
}  // namespace mariotte::scaling_study

int main(int argc, char** argv) {
  using namespace mariotte;
  scaling_study::CommandLine line;
  return command::run_program(
      {.name = "scaling_study",
       .about = "Time, memory and error of a wave through a row of balls against its length.",
       .footer = scaling_study::notes,
       .options = scaling_study::declare(line),
       .act = [&] { return scaling_study::act(line); }},
      argc, argv);
}
