#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "mariotte/report/files.hpp"
#include "mariotte/report/plot.hpp"

namespace mariotte::report {
namespace {

constexpr int command_not_found = 127;

// In the child: gnuplot's words go to stderr, since stdout belongs to the result.
[[noreturn]] void become_gnuplot(const std::filesystem::path& folder, const std::string& setting) {
  std::signal(SIGPIPE, SIG_DFL);
  if (::chdir(folder.c_str()) == 0 && ::dup2(STDERR_FILENO, STDOUT_FILENO) >= 0)
    ::execlp("gnuplot", "gnuplot", "-e", setting.c_str(), "plot.gp", nullptr);
  ::_exit(errno == ENOENT ? command_not_found : 1);
}

// Exit code of gnuplot, or of a shell that had not found it.
int run_gnuplot(const std::filesystem::path& folder, const std::string& setting) {
  const pid_t child = ::fork();
  if (child == 0) become_gnuplot(folder, setting);
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return child > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

bool move_figures(const std::filesystem::path& from, const std::filesystem::path& to,
                  const std::vector<std::string>& figures) {
  std::error_code problem;
  for (const auto& name : figures) {
    std::filesystem::rename(from / name, to / name, problem);
    if (problem) return false;
  }
  return true;
}

}  // namespace

std::string draw(const std::filesystem::path& folder, const std::vector<std::string>& figures) {
  const std::string temporary = fmt::format(".figures.{}.tmp", ::getpid());
  std::error_code problem;
  std::filesystem::create_directory(folder / temporary, problem);
  const int code = problem ? 1 : run_gnuplot(folder, fmt::format("folder='{}/'", temporary));
  const bool drawn = code == 0 && move_figures(folder / temporary, folder, figures);
  std::filesystem::remove_all(folder / temporary, problem);
  if (code == command_not_found) return "gnuplot is not installed";
  return drawn ? "" : "gnuplot failed";
}

}  // namespace mariotte::report
