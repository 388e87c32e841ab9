#include "picture.hpp"

#include <fmt/format.h>

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

/// A line of its own colour and dashes; or one of a family, in the colours of a map.
std::string look(const Curve& curve, std::size_t position) {
  constexpr double brightest = 0.88;  // of the map; what is brighter is pale on white
  const auto* dashes = curve.style == Style::dashed ? " dt (12,4)" : " dt solid";
  if (!curve.colour) return fmt::format("lt {}{}", position + 1, curve.style == Style::dashed ? dashes : "");
  return fmt::format("lt 1 lc palette fraction {:.3f}{}", brightest * *curve.colour, dashes);
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
    plot += fmt::format("{} 'plot.csv' index {} using 1:2 with {} {} {}", i > 0 ? "," : "", i,
                        kind(picture.curves[i].style), look(picture.curves[i], i), title(picture.curves[i]));
  return text + report::on_all_terminals(name, plot + "\n", report::wide);
}

}  // namespace mariotte::paper_figures
