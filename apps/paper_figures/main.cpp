// The figures of the papers, computed again and compared with what is known about them.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "command_line/exit_code.hpp"
#include "command_line/program.hpp"
#include "command_line/terminal.hpp"
#include "figure.hpp"
#include "mariotte/report/page/files.hpp"
#include "output.hpp"

namespace mariotte::paper_figures {
namespace {

struct CommandLine {
  std::vector<std::string> names;
  std::string out = "figures";
  bool force = false;
};

std::string is_figure(const std::string& text) {
  if (text == "all") return "";
  std::string known = "all";
  for (const auto& figure : figures()) {
    if (figure.name == text) return "";
    known += ", " + figure.name;
  }
  return fmt::format("unknown figure '{}' (one of: {})", text, known);
}

std::string notes() {
  std::string text = "\nFigures:\n";
  std::size_t width = 0;
  for (const auto& figure : figures()) width = std::max(width, figure.name.size());
  for (const auto& figure : figures())
    text += fmt::format("  {:<{}}  {}\n", figure.name, width, figure.title);
  return text + R"(
A folder per figure holds its data, script, pictures and checks.

Examples:
  mariotte reproduce acary-2b
  mariotte reproduce all --out figures --force

Exit codes: 0 ok, 1 a check failed, 2 usage, 4 solver failure, 6 file error.
)";
}

command::OptionList declare(CommandLine& line) {
  return {{"figure", &line.names, "Figures to make, or all", {.check = is_figure, .required = true}},
          {"--out",
           &line.out,
           "Folder that receives a folder per figure",
           {.value = "DIR", .shows_default = true}},
          {"--force", &line.force, "Overwrite figures of an earlier run"}};
}

std::vector<Figure> wanted(const std::vector<std::string>& names) {
  const std::set<std::string> asked(names.begin(), names.end());
  std::vector<Figure> list;
  for (const auto& figure : figures())
    if (asked.contains("all") || asked.contains(figure.name)) list.push_back(figure);
  return list;
}

int act(const CommandLine& line) {
  const auto list = wanted(line.names);
  const std::filesystem::path out = line.out;
  for (const auto& figure : list) report::prepare_folder(out / figure.name, file_names(figure), line.force);
  std::size_t failed = 0, checks = 0;
  std::string no_picture;
  for (const auto& figure : list) {
    const auto result = figure.make();
    checks += result.checks.size();
    failed += static_cast<std::size_t>(std::count_if(result.checks.begin(), result.checks.end(),
                                                     [](const Check& one) { return !holds(one); }));
    command::print((list.size() == 1 ? details : summary)(figure, result) + "\n");
    if (const auto why = write(out / figure.name, figure, result); !why.empty()) no_picture = why;
  }
  command::print(
      fmt::format("{} of {} checks pass; figures are in {}\n", checks - failed, checks, out.string()));
  if (!no_picture.empty()) command::warning("no pictures: " + no_picture + "; data and scripts are there");
  return failed == 0 ? command::ExitCode::ok : command::ExitCode::check_failed;
}

}  // namespace
}  // namespace mariotte::paper_figures

int main(int argc, char** argv) {
  using namespace mariotte;
  paper_figures::CommandLine line;
  return command::run_program(
      {.name = "paper_figures",
       .about = "The figures of the papers, computed again, with their numbers checked.",
       .footer = paper_figures::notes(),
       .options = paper_figures::declare(line),
       .act = [&] { return paper_figures::act(line); }},
      argc, argv);
}
