#include "mariotte/report/figure/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include "mariotte/report/figure/palette.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::report {
namespace {

constexpr int command_not_found = 127;
constexpr std::string_view set_output = "set output folder.";
constexpr int text_height = 13;  // in pixels of a sheet

// In the child: gnuplot's words go to stderr, since stdout belongs to the result. Scripts are UTF-8 in any
// locale.
[[noreturn]] void become_gnuplot(const std::filesystem::path& folder, const std::string& setting) {
  std::signal(SIGPIPE, SIG_DFL);
  ::setenv("LC_ALL", "C.UTF-8", 1);
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

/// Pixels of images keep their edges in browsers, which would blur them.
void keep_pixels(const std::filesystem::path& svg) {
  std::ifstream file(svg);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  constexpr std::string_view image = "<image ";
  for (auto at = text.find(image); at != text.npos; at = text.find(image, at + 1))
    text.insert(at + image.size(), "style='image-rendering:pixelated' ");
  std::ofstream(svg) << text;
}

/// It ends as a file of its kind does: on a full disk gnuplot leaves pieces, and says nothing.
bool is_whole(const std::filesystem::path& figure) {
  constexpr std::array endings = {std::pair{".png", "IEND"}, std::pair{".svg", "</svg>"},
                                  std::pair{".pdf", "%%EOF"}};
  std::string tail(12, ' ');
  std::ifstream file(figure, std::ios::binary);
  file.seekg(-static_cast<std::streamoff>(tail.size()), std::ios::end);
  file.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  return std::all_of(endings.begin(), endings.end(), [&](const auto& kind) {
    return figure.extension() != kind.first || tail.find(kind.second) != tail.npos;
  });
}

bool move_figures(const std::filesystem::path& from, const std::filesystem::path& to,
                  const std::vector<std::string>& figures) {
  std::error_code problem;
  for (const auto& name : figures) {
    if (name.ends_with(".svg")) keep_pixels(from / name);
    if (!is_whole(from / name)) return false;
    std::filesystem::rename(from / name, to / name, problem);
    if (problem) return false;
  }
  return true;
}

}  // namespace

std::string script_head() {
  return R"(# Run with gnuplot in this folder.
if (!exists('folder')) folder = ''
set encoding utf8
set datafile separator comma
set minussign
set format '%h'
set border 3 lc rgb '#555555'
set tics nomirror out
set clip two
set grid lc rgb '#e6e6e6' lw 0.5
set key outside right top reverse Left samplen 3
)" + palette_settings();
}

// Inside single quotes a quote is doubled.
std::string quoted(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 2) text.insert(at, 1, '\'');
  return "'" + text + "'";
}

// All three have one layout: lengths in pixels of the screen, in finer ones, and in centimetres of a
// journal's column, whose text is then 7 points high.
std::string on_all_terminals(const std::string& name, const std::string& plot, const Sheet& sheet) {
  constexpr double finer = 2.4, centimetres = 8.6 / 450, points = 7.0 / 13;
  const auto terminal = [&](const std::string& options, const char* ending) {
    return fmt::format("set terminal {}\n{}{}\n{}", options, set_output, quoted(name + ending), plot);
  };
  return terminal(fmt::format("pngcairo size {:.0f},{:.0f} font 'sans,{:.1f}' linewidth {}",
                              finer * sheet.width, finer * sheet.height, 0.75 * finer * text_height, finer),
                  ".png") +
         terminal(fmt::format("svg size {},{} dynamic font 'sans,{}' background 'white'", sheet.width,
                              sheet.height, text_height),
                  ".svg") +
         terminal(fmt::format("pdfcairo size {:.2f}cm,{:.2f}cm font 'sans,{:.1f}' linewidth 0.7",
                              centimetres * sheet.width, centimetres * sheet.height, points * text_height),
                  ".pdf") +
         "unset output\n";
}

std::vector<std::string> files_of_figure(const std::string& name) {
  return {name + ".pdf", name + ".png", name + ".svg"};
}

std::vector<std::string> figures_of_script(const std::filesystem::path& script) {
  std::vector<std::string> names;
  std::ifstream file(script);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(set_output) || !line.ends_with('\'')) continue;
    const auto name = line.substr(set_output.size() + 1, line.size() - set_output.size() - 2);
    if (name.find('/') == name.npos) names.push_back(name);
  }
  return names;
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
