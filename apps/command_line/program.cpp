#include "command_line/program.hpp"

#include <csignal>

#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/core/nearest.hpp"

namespace mariotte::command {
namespace {

/// What the command line got to before it failed.
const CLI::App& innermost(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : innermost(*parsed.back());
}

/// The first word that means nothing, and what it is like; empty if there is none.
std::string unknown_word(const CLI::App& app) {
  const auto& at = innermost(app);
  std::vector<std::string> known;
  for (const auto* command : at.get_subcommands([](const CLI::App*) { return true; }))
    known.push_back(command->get_name());
  for (const auto* option : at.get_options())
    for (const auto& name : option->get_lnames()) known.push_back("--" + name);
  const std::vector<std::string_view> names(known.begin(), known.end());
  for (const auto& word : at.remaining()) {
    const std::string kind = word.starts_with("-") ? "option" : "command";
    if (const auto similar = suggestion(word, names); !similar.empty())
      return "unknown " + kind + " '" + word + "'" + similar;
  }
  return "";
}

Fault fault_of(const CLI::ParseError& problem) {
  if (dynamic_cast<const CLI::ExtrasError*>(&problem)) return fault::unknown_argument;
  return dynamic_cast<const CLI::RequiredError*>(&problem) ? fault::missing_argument : fault::bad_argument;
}

std::string is_not_empty(const std::string& text) {
  return text.empty() ? "an empty value names nothing" : "";
}

/// A shell variable that is not set makes `--out ""`, which is not the same as no --out.
void refuse_empty_values(CLI::App& app) {
  for (auto* option : app.get_options())
    if (option->get_items_expected_max() > 0) option->check(is_not_empty, "");
  for (auto* command : app.get_subcommands([](CLI::App*) { return true; })) refuse_empty_values(*command);
}

/// False if all that was asked for is printed.
bool parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return true;
  } catch (const CLI::CallForHelp&) {
    print(app.help());
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& problem) {
    const auto misspelt = unknown_word(app);
    if (!misspelt.empty()) throw UsageError(misspelt + " (see --help)", fault::unknown_argument);
    throw UsageError(std::string(problem.what()) + " (see --help)", fault_of(problem));
  }
  return false;
}

}  // namespace

int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& action) noexcept {
  // A closed pipe and a file at its size limit are errors to report, not reasons to die silently.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return guarded([&] {
    speak_as(app.get_name());
    refuse_empty_values(app);
    return parse(app, argc, argv) ? action() : ExitCode::ok;
  });
}

}  // namespace mariotte::command
