#include "picture.hpp"

#include <fmt/format.h>

#include "mariotte/report/figure/gnuplot.hpp"

namespace mariotte::paper_figures {
namespace {

const char* drawn(Style style) {
  switch (style) {
    case Style::line:
      return "lines lw 2";
    case Style::dashed:
      return "lines lw 2 dt 2";
    case Style::points:
      return "points pt 7 ps 0.8";
    case Style::line_and_points:
      return "linespoints lw 2 pt 7 ps 0.8";
  }
  return "lines";
}

std::string colour(const Curve& curve, std::size_t position) {
  return curve.colour ? fmt::format("lc palette fraction {:.3f}", *curve.colour)
                      : fmt::format("lc {}", position + 1);
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
  std::string text = report::script_head;
  text += fmt::format("set title {} noenhanced\nset xlabel '{}'\nset ylabel '{}'\n{}",
                      report::quoted(picture.title), picture.x_label, picture.y_label, picture.commands);
  text += "unset colorbox\nset cbrange [0:1]\n";
  std::string plot = "plot";
  for (std::size_t i = 0; i < picture.curves.size(); ++i)
    plot +=
        fmt::format("{} 'plot.csv' index {} using 1:2 with {} {} {}", i > 0 ? "," : "", i,
                    drawn(picture.curves[i].style), colour(picture.curves[i], i), title(picture.curves[i]));
  return text + report::on_both_terminals(name, plot + "\n");
}

}  // namespace mariotte::paper_figures
