#include "plots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/palette.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::work_precision {
namespace {

constexpr double least_error = 1e-17;  // shown for smaller ones: the axis is logarithmic

/// One method on one problem: neighbours among the rows.
struct Curve {
  const Row& first;
  std::size_t block;  ///< of plot.csv, from 0
};

bool same_curve(const Row& a, const Row& b) {
  return a.problem == b.problem && a.method == b.method;
}

std::vector<Curve> curves(const std::vector<Row>& rows) {
  std::vector<Curve> list;
  for (const auto& row : rows)
    if (list.empty() || !same_curve(list.back().first, row)) list.push_back({row, list.size()});
  return list;
}

std::string data(const std::vector<Row>& rows) {
  std::string text =
      "# error of the final velocities, CPU time per impact [s]; a block per problem and method";
  const Row* before = nullptr;
  for (const auto& row : rows) {
    if (before == nullptr || !same_curve(*before, row))
      text += fmt::format("{}# {} {}\n", before ? "\n\n" : "\n", row.problem, row.method);
    text += fmt::format("{:.4g},{:.4g}\n", std::max(row.error, least_error), row.seconds);
    before = &row;
  }
  return text;
}

/// `auto` stands out in black; a family shares its dashes, and a method has its colour and mark in every
/// figure.
std::string style(const Row& row, const std::vector<std::string>& methods) {
  using report::line_colours, report::line_marks;
  if (row.method == "auto") return "with linespoints lw 4 pt 7 dt 1 lc rgb 'black'";
  const auto at = std::find(methods.begin(), methods.end(), row.method) - methods.begin();
  return fmt::format("with linespoints lw 2 pt {} dt {} lc rgb '{}'", line_marks[at % line_marks.size()],
                     1 + static_cast<int>(row.family), line_colours[1 + at % (line_colours.size() - 1)]);
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const auto& method : methods()) names.push_back(method.name);
  return names;
}

std::string figure(const std::string& problem, const std::vector<Row>& rows) {
  std::string plot;
  const auto names = method_names();
  for (const auto& [first, block] : curves(rows))
    if (first.problem == problem)
      plot += fmt::format("{} 'plot.csv' index {} {} title '{}'", plot.empty() ? "plot" : ", \\\n    ", block,
                          style(first, names), first.method);
  return fmt::format("\nset title '{}'\n", problem) +
         report::on_all_terminals(problem, plot + "\n", report::wide);
}

std::vector<std::string> problems(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const auto& [first, block] : curves(rows))
    if (names.empty() || names.back() != first.problem) names.push_back(first.problem);
  return names;
}

std::string script(const std::vector<Row>& rows) {
  std::string text = report::script_head();
  text += "set logscale xy\nset key font ',11' spacing 0.9\n";
  text +=
      "set format '10^{%T}'\nset xlabel 'largest error of the final velocities'\nset xrange [*:*] reverse\n";
  text += "set ylabel 'CPU time per impact [s]'\n";
  for (const auto& problem : problems(rows)) text += figure(problem, rows);
  return text;
}

std::vector<std::string> figures(const std::vector<std::string>& problems) {
  std::vector<std::string> names;
  for (const auto& problem : problems)
    for (const auto& name : report::files_of_figure(problem)) names.push_back(name);
  return names;
}

}  // namespace

void prepare_plots(const std::filesystem::path& folder, const std::vector<std::string>& problems,
                   bool force) {
  auto names = figures(problems);
  names.insert(names.end(), {"plot.csv", "plot.gp"});
  report::prepare_folder(folder, names, force);
}

std::string write_plots(const std::filesystem::path& folder, const std::vector<Row>& rows) {
  if (rows.empty()) return "no method solved anything";
  report::write_file(folder / "plot.csv", data(rows));
  report::write_file(folder / "plot.gp", script(rows));
  return report::draw(folder, figures(problems(rows)));
}

}  // namespace mariotte::work_precision
