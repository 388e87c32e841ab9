#include <csignal>

#include "command.hpp"
#include "exit_code.hpp"
#include "mariotte/report/provenance.hpp"
#include "terminal.hpp"

namespace mariotte::command {
namespace {

constexpr const char* examples = R"(Examples:
  mariotte demo                                  five steel balls, no file needed
  mariotte run cradle.toml                       a table of the impact
  mariotte run cradle.toml --out results         also files and figures
  mariotte run cradle.toml --json > cradle.json  the same for scripts
  mariotte run --help                            all about one command

Exit codes: 0 ok, 1 check failed, 2 usage, 3 scene error, 4 solver failure, 5 a limit was reached,
6 file error, 130 or 143 interrupted.
)";

int parse(CLI::App& app, int argc, char** argv, const int& code) {
  try {
    app.parse(argc, argv);
    return code;
  } catch (const CLI::CallForHelp&) {
    print(app.help());
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& problem) {
    throw UsageError(std::string(problem.what()) + " (see --help)");
  }
  return ExitCode::ok;
}

int act(int argc, char** argv) {
  CLI::App app("Stiff, event-driven impacts: what balls in a chain do when they meet.", "mariotte");
  app.footer(examples);
  app.set_version_flag("--version", "mariotte " + report::provenance().version);
  app.require_subcommand(1);
  int code = ExitCode::ok;
  add_run(app, code);
  add_check(app, code);
  add_demo(app, code);
  add_study(app, code);
  add_version(app, code);
  return parse(app, argc, argv, code);
}

}  // namespace

int command_line(int argc, char** argv) noexcept {
  // A closed pipe and a file at its size limit are errors to report, not reasons to die silently.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return guarded([&] { return act(argc, argv); });
}

}  // namespace mariotte::command
