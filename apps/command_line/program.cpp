#include "command_line/program.hpp"

#include <csignal>

#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"

namespace mariotte::command {
namespace {

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
    throw UsageError(std::string(problem.what()) + " (see --help)");
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
    return parse(app, argc, argv) ? action() : ExitCode::ok;
  });
}

}  // namespace mariotte::command
