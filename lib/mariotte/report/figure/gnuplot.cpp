#include "mariotte/report/figure/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>

#include "mariotte/report/page/files.hpp"

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

std::string time_axis(const Display& time, double start, double end) {
  return fmt::format("set xlabel 'time [{}]'\nset xrange [{:.8g}:{:.8g}]\ntime_factor = {:g}\n", time.unit,
                     time.factor * start, time.factor * end, time.factor);
}

const char* const script_head = R"(# Run with gnuplot in this folder.
if (!exists('folder')) folder = ''
set encoding utf8
set datafile separator comma
set border 3 lc rgb '#555555'
set tics nomirror out
set grid lt 1 lc rgb '#e6e6e6' lw 1
set key outside right top reverse Left samplen 2
set palette defined (0 '#30123b', 1 '#4171d6', 2 '#1fb5b0', 3 '#5fb94a', 4 '#e0a11b', 5 '#c4391d')
set linetype 1 lc rgb '#30123b'
set linetype 2 lc rgb '#4171d6'
set linetype 3 lc rgb '#1fb5b0'
set linetype 4 lc rgb '#5fb94a'
set linetype 5 lc rgb '#e0a11b'
set linetype 6 lc rgb '#c4391d'
set linetype 7 lc rgb '#8c564b'
set linetype 8 lc rgb '#7f7f7f'
)";

// Inside single quotes a quote is doubled.
std::string quoted(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 2) text.insert(at, 1, '\'');
  return "'" + text + "'";
}

std::string on_both_terminals(const std::string& name, const std::string& plot) {
  return fmt::format("set terminal pngcairo size 1200,750 font 'sans,14'\nset output folder.'{}.png'\n{}",
                     name, plot) +
         fmt::format(
             "set terminal svg size 800,500 dynamic font 'sans,13' background 'white'\n"
             "set output folder.'{}.svg'\n{}",
             name, plot);
}

std::vector<std::string> files_of_figure(const std::string& name) {
  return {name + ".png", name + ".svg"};
}

std::string gnuplot_version() {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen("gnuplot --version 2>/dev/null", "r"), ::pclose);
  std::array<char, 100> line{};
  if (!pipe || !std::fgets(line.data(), line.size(), pipe.get())) return "";
  const std::string text = line.data();
  return text.substr(text.find(' ') + 1, text.find('\n') - text.find(' ') - 1);
}

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
