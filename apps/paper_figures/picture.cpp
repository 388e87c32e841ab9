#include "picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mariotte/report/figure/gnuplot.hpp"

namespace mariotte::paper_figures {
namespace {

const char* kind(Style style) {
  switch (style) {
    case Style::line:
    case Style::dashed:
      return "lines";
    case Style::points:
      return "points";
    case Style::line_and_points:
      return "linespoints";
  }
  return "lines";
}

/// Curves before this one that differ from it in colour, of a family; those of one colour share their marks.
std::size_t position_in_family(const std::vector<Curve>& curves, std::size_t position) {
  std::set<double> colours;
  for (std::size_t i = 0; i < position; ++i)
    if (curves[i].colour && curves[i].colour != curves[position].colour) colours.insert(*curves[i].colour);
  return colours.size();
}

/// A line of its own colour and dashes.
std::string own(const Curve& curve, std::size_t position) {
  const auto* more = curve.style == Style::dashed   ? " dt (12,4)"
                     : curve.style == Style::points ? " ps 1.4"
                                                    : "";
  return fmt::format("{} lt {}{}", kind(curve.style), position + 1, more);
}

/// A line of a family, in the colours of a map and with marks here and there.
std::string of_family(const Curve& curve, std::size_t position) {
  constexpr double brightest = 0.88;  // of the map; what is brighter is pale on white
  constexpr std::size_t marks = 8;
  return fmt::format("linespoints lt {} pi {} ps 1.4 lc palette fraction {:.3f} dt {}", position + 1,
                     std::max<std::size_t>(1, curve.x.size() / marks), brightest * *curve.colour,
                     curve.style == Style::dashed ? "(12,4)" : "solid");
}

std::string look(const std::vector<Curve>& curves, std::size_t position) {
  const auto& curve = curves[position];
  return curve.colour ? of_family(curve, position_in_family(curves, position)) : own(curve, position);
}

std::string title(const Curve& curve) {
  return curve.name.empty() ? "notitle" : "title " + report::quoted(curve.name);
}

}  // namespace

std::string plot_data(const Picture& picture) {
  std::string text = fmt::format("# {}, {}; a block per curve\n", picture.x_label, picture.y_label);
  for (const auto& curve : picture.curves) {
    text += fmt::format("# {}\n", curve.name);
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      text += fmt::format("{:.17g},{:.17g}\n", curve.x[i], curve.y[i]);
    text += "\n\n";
  }
  return text;
}

std::string plot_script(const Picture& picture, const std::string& name) {
  std::string text = report::script_head();
  text += fmt::format("set title {} noenhanced\nset xlabel '{}'\nset ylabel '{}'\n{}",
                      report::quoted(picture.title), picture.x_label, picture.y_label, picture.commands);
  text += "unset colorbox\nset cbrange [0:1]\n";
  std::string plot = "plot";
  for (std::size_t i = 0; i < picture.curves.size(); ++i)
    plot += fmt::format("{} 'plot.csv' index {} using 1:2 with {} {}", i > 0 ? "," : "", i,
                        look(picture.curves, i), title(picture.curves[i]));
  return text + report::on_all_terminals(name, plot + "\n", report::wide);
}

}  // namespace mariotte::paper_figures
