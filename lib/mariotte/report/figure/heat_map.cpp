#include "mariotte/report/figure/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/core/types.hpp"
#include "mariotte/report/figure/event_marks.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_cells = 250;  // along each axis, about a pixel of the screen
constexpr double colour_bar = 108;       // pixels, with its numbers and name
constexpr double width_of_digit = 8;     // more of that
constexpr int least_digits = 5;
constexpr double four_decades = 1e-4;

/// How many balls share a cell.
std::size_t stride(const HeatMap& map) {
  return (map.value.front().size() + most_cells - 1) / most_cells;
}

double greater(double a, double b) {
  return std::abs(b) > std::abs(a) ? b : a;
}

void pool(const std::vector<double>& row, std::size_t stride, std::vector<double>& cells) {
  for (std::size_t i = 0; i < row.size(); ++i) cells[i / stride] = greater(cells[i / stride], row[i]);
}

/// The row at an instant between two samples.
std::vector<double> row_at(const HeatMap& map, double time) {
  const auto next = std::lower_bound(map.time.begin(), map.time.end(), time) - map.time.begin();
  const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(next), 1, map.time.size() - 1);
  const double part = (time - map.time[i - 1]) / (map.time[i] - map.time[i - 1]);
  auto row = map.value[i - 1];
  for (std::size_t k = 0; k < row.size(); ++k) row[k] += part * (map.value[i][k] - row[k]);
  return row;
}

double cell_length(const Window& window) {
  return (window.end - window.start) / static_cast<double>(most_cells);
}

/// What the colours stand for [SI].
struct Colours {
  double least = infinity, most = -infinity;
  bool logarithmic = false;  ///< of magnitudes

  void show(const std::vector<double>& row) {
    for (const double value : row) {
      least = std::min(least, logarithmic ? std::abs(value) : value);
      most = std::max(most, logarithmic ? std::abs(value) : value);
    }
  }
};

/// Of all that the windows show.
Colours range(const HeatMap& map, const TimeAxis& axis, bool logarithmic) {
  Colours all{.logarithmic = logarithmic};
  for (const auto& window : axis.windows) {
    all.show(row_at(map, window.start));
    all.show(row_at(map, window.end));
    for (std::size_t i = 0; i < map.time.size(); ++i)
      if (map.time[i] > window.start && map.time[i] < window.end) all.show(map.value[i]);
  }
  return all;
}

/// Four decades at most; in less than one, even colours, which begin at zero unless all is far from it.
Colours colours(const HeatMap& map, const TimeAxis& axis) {
  if (map.logarithmic) {
    auto all = range(map, axis, true);
    all.least = std::max(all.least, four_decades * all.most);
    if (all.most >= 10 * all.least && all.most > 0) return all;
  }
  auto all = range(map, axis, false);
  const double height = all.most - all.least;
  if (all.least > 0 && all.least < height) all.least = 0;
  if (all.most < 0 && -all.most < height) all.most = 0;
  const double size = std::max(std::abs(all.least), std::abs(all.most));
  if (height <= 1e-9 * size) all.most += size > 0 ? 0.001 * size : 1;
  return all;
}

/// That colours can be told by: more of values that hardly differ.
int digits(const Colours& shown) {
  const double size = std::max(std::abs(shown.least), std::abs(shown.most)),
               height = shown.most - shown.least;
  return std::clamp(4 + static_cast<int>(std::ceil(std::log10(size / height))), least_digits, 14);
}

std::string block(const HeatMap& map, const Window& window, int digits) {
  const auto width = stride(map);
  std::string text;
  for (std::size_t j = 0; j < most_cells; ++j) {
    const double from = window.start + static_cast<double>(j) * cell_length(window);
    const double to = from + cell_length(window);
    std::vector<double> cells((map.value.front().size() + width - 1) / width, 0);
    pool(row_at(map, 0.5 * (from + to)), width, cells);
    auto i =
        static_cast<std::size_t>(std::lower_bound(map.time.begin(), map.time.end(), from) - map.time.begin());
    for (; i < map.time.size() && map.time[i] < to; ++i) pool(map.value[i], width, cells);
    for (std::size_t k = 0; k < cells.size(); ++k) append_rounded(cells[k], digits, text += k > 0 ? "," : "");
    text += "\n";
  }
  return text + "\n\n";
}

/// Numbers that are not those of the places have a tick each, as far as there is room.
std::string number_ticks(const HeatMap& map) {
  constexpr std::size_t most_ticks = 16;
  if (map.number.empty()) return "set ytics autofreq\n";
  const auto step = (map.number.size() + most_ticks - 1) / most_ticks;
  std::string text;
  for (std::size_t i = 0; i < map.number.size(); i += step)
    text += fmt::format("{}\"{}\" {}", i > 0 ? ", " : "", map.number[i], i + 1);
  return "set ytics (" + text + ")\n";
}

}  // namespace

std::string heat_map_data(const HeatMap& map, const TimeAxis& axis) {
  std::string text;
  const int shown = digits(colours(map, axis));
  for (const auto& window : axis.windows) text += block(map, window, shown);
  return text;
}

std::string script(const HeatMap& map, const TimeAxis& axis, std::size_t first_block) {
  const auto shown = colours(map, axis);
  const auto display = display_for(std::vector{shown.least, shown.most}, map.unit);
  const auto height = static_cast<double>(stride(map));
  const auto bar = shown.logarithmic ? fmt::format("|{}|", map.quantity) : map.quantity;
  auto block = first_block;
  const auto all = panels(axis.windows, colour_bar + width_of_digit * (digits(shown) - least_digits));
  const auto inside = [&, count = map.value.front().size()](const Panel& panel) {
    const double length = cell_length(panel.window);
    const auto value = shown.logarithmic ? fmt::format("(abs($3)>{0:g}?{1:g}*abs($3):{1:g}*{0:g})",
                                                       shown.least, display.factor)
                                         : fmt::format("({:g}*$3)", display.factor);
    return fmt::format("set yrange [0.5:{}]\n{}{}{}", static_cast<double>(count) + 0.5,
                       panel.is_first ? vertical_name(map.along) + number_ticks(map) : "",
                       panel.is_last ? "set colorbox\n" : "unset colorbox\n",
                       event_ticks(axis.events, axis.display, panel.window,
                                   (panel.right - panel.left) * one_column.width)) +
           fmt::format(
               "plot 'plot.csv' index {} matrix using ({:.9g}+{:.9g}*$2):({}+{}*$1):{} with image notitle\n",
               block + static_cast<std::size_t>(&panel - all.data()),
               axis.display.factor * (panel.window.start + 0.5 * length), axis.display.factor * length,
               0.5 * (1 + height), height, value);
  };
  return fmt::format("\n{}set cbrange [{:.{}g}:{:.{}g}]\nset cblabel '{} [{}]' offset 1.2,0\nunset grid\n",
                     shown.logarithmic ? "set logscale cb\nset format cb '10^{%T}'\n" : "",
                     display.factor * shown.least, 1 + digits(shown), display.factor * shown.most,
                     1 + digits(shown), bar, display.unit) +
         on_panels(map.file, map.title, axis, all, inside) +
         "unset logscale\nset format cb '%h'\nunset colorbox\nset ytics autofreq\nset grid\n";
}

}  // namespace mariotte::report
