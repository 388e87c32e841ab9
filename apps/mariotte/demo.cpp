#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "example.hpp"
#include "mariotte/report/text.hpp"
#include "run_notes.hpp"

namespace mariotte::command {
namespace {

struct Demo {
  std::string name = "newton_cradle_5";
  bool list = false;
};

std::string list() {
  std::string text;
  const auto names = example_names();
  const auto longer = [](const auto& a, const auto& b) { return a.size() < b.size(); };
  const auto width = std::max_element(names.begin(), names.end(), longer)->size();
  for (const auto& name : names)
    text += fmt::format("{:<{}}  {}\n", name, width, scene::parse(example(name).scene, name).title);
  return text;
}

int demo(const Demo& options) {
  if (options.list) {
    print(list());
    return ExitCode::ok;
  }
  const auto scene = scene::parse(example(options.name).scene, options.name);
  const auto impact = scene::simulate(scene);
  print(report::table_text(impact, scene));
  return tell_run(impact, scene, false);
}

}  // namespace

Command demo_command() {
  auto options = std::make_shared<Demo>();
  return {.name = "demo",
          .about = "Run an example, built in: Newton's cradle of five steel balls, or another",
          .footer = "Examples:\n  mariotte demo\n  mariotte demo --list\n  mariotte demo y_chain\n",
          .options = {{"NAME", &options->name, "Another example", {.choices = example_names()}},
                      {"--list", &options->list, "List the examples"}},
          .act = [options] { return demo(*options); }};
}

}  // namespace mariotte::command
