// How cost and results depend on stiffness: tables, CSV, figures, and what they prove.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "command_line/exit_code.hpp"
#include "command_line/program.hpp"
#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "mariotte/report/page/files.hpp"
#include "output.hpp"

namespace mariotte::stiffness_study {
namespace {

using command::print;

struct CommandLine {
  Settings settings;
  std::vector<std::string> studies;
  std::string csv;
  std::string plots;
};

std::string is_study(const std::string& text) {
  std::string known;
  for (const auto& study : studies()) {
    if (study.name == text) return "";
    known += (known.empty() ? "" : ", ") + study.name;
  }
  return "unknown study '" + text + "' (one of: " + known + ")";
}

constexpr const char* notes = R"(
Every run gets raw SI numbers. Errors are those of final velocities relative to the incident speed; times are
CPU time, the least of repeated batches. "-" marks flows that had become too slow.

Examples:
  stiffness_study --quick
  stiffness_study --csv study.csv --plots figures
  stiffness_study --study ratio --flow modal --accuracy 1e-12
  stiffness_study --study crossover

Exit codes: 0 ok, 1 a theorem failed, 2 usage, 4 solver failure, 6 file error.
)";

command::OptionList declare(CommandLine& line) {
  return {{"--study",
           &line.studies,
           "stiffness, ratio, damping, scaling, conclusions, crossover, network or packing; may be repeated "
           "(default: all but the last three)",
           {.check = is_study, .takes_one = true}},
          {"--flow", &line.settings.flow, "Only this flow", {.check = command::is_flow}},
          {"--accuracy",
           &line.settings.accuracy,
           "Wanted error of the final velocities / incident speed",
           {.check = command::is_accuracy, .shows_default = true}},
          {"--csv", &line.csv, "Write every run into this file", {.value = "FILE"}},
          {"--plots", &line.plots, "Write figures, their data and script into this folder", {.value = "DIR"}},
          {"--quick", &line.settings.quick, "Few values, rough times: seconds instead of minutes"}};
}

bool wanted(const CommandLine& line, const Study& study) {
  if (line.studies.empty()) return study.by_default;
  return std::find(line.studies.begin(), line.studies.end(), study.name) != line.studies.end();
}

Findings run(const CommandLine& line) {
  Findings all;
  for (const auto& study : studies()) {
    if (!wanted(line, study)) continue;
    auto found = study.run(line.settings);
    print(fmt::format("{}══ {}\n{}", all.rows.empty() ? "" : "\n", study.title, table(found.rows)));
    add(all.rows, std::move(found.rows));
    for (auto& one : found.statements)
      all.statements.push_back({one.kind, study.name + ": " + one.text, one.holds});
    all.figures.insert(all.figures.end(), found.figures.begin(), found.figures.end());
  }
  return all;
}

int act(const CommandLine& line) {
  const auto findings = run(line);
  print("\n══ What was found\n" + text(findings.statements));
  if (!line.csv.empty()) report::write_file(line.csv, csv(findings.rows));
  if (!line.plots.empty())
    if (const auto why = draw(line.plots, findings.figures); !why.empty())
      command::warning("no figures: " + why);
  const bool holds =
      std::all_of(findings.statements.begin(), findings.statements.end(),
                  [](const Statement& one) { return one.kind != Statement::Kind::theorem || one.holds; });
  return holds ? command::ExitCode::ok : command::ExitCode::check_failed;
}

}  // namespace
}  // namespace mariotte::stiffness_study

int main(int argc, char** argv) {
  using namespace mariotte;
  stiffness_study::CommandLine line;
  return command::run_program(
      {.name = "stiffness_study",
       .about = "How cost and results of impacts depend on stiffness, stiffness ratio and damping.",
       .footer = stiffness_study::notes,
       .options = stiffness_study::declare(line),
       .act = [&] { return stiffness_study::act(line); }},
      argc, argv);
}
