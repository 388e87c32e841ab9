#include "mariotte/report/figure/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/heat_map.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

using Rows = std::vector<std::vector<double>>;

constexpr double negligible_height = 1e-4;  // of the height of a figure

std::size_t columns_of(const Rows& rows) {
  return rows.empty() ? 0 : rows.front().size();
}

double greatest(const Rows& rows) {
  double most = 0;
  for (const auto& row : rows)
    for (const double value : row) most = std::max(most, std::abs(value));
  return most;
}

std::vector<double> column_of(const Rows& rows, std::size_t column) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[column]);
  return values;
}

/// One curve; points that differ too little from the last one kept are left out.
std::string block(const std::vector<double>& time, const std::vector<double>& value, std::size_t number,
                  double resolution) {
  std::string text;
  double kept = 0;
  const auto differs = [&](std::size_t i) { return std::abs(value[i] - kept) > resolution; };
  for (std::size_t i = 0; i < time.size(); ++i) {
    const bool at_end = i == 0 || i + 1 == time.size();
    if (!at_end && !differs(i) && !differs(i + 1)) continue;
    kept = value[i];
    text += fmt::format("{},{},{}\n", number, rounded(time[i], 9), rounded(kept, 9));
  }
  return text + "\n\n";
}

/// Appends the data and the script of one figure; `block` counts the blocks of plot.csv.
class Writer {
 public:
  Writer(const std::vector<double>& time, const std::string& title, const scene::Figure& figure,
         RunPlot& plot)
      : time_(time), title_(title), figure_(figure), plot_(plot) {}

  void add(const Series& series) {
    const auto count = columns_of(series.rows);
    plot_.data += fmt::format("# {} [{}]\n", series.quantity, series.unit.empty() ? "SI" : series.unit);
    if (count == 0) return;
    plot_.figures.push_back(series.file);
    count > most_curves ? add_map(series) : add_curves(series, count);
  }

 private:
  void add_curves(const Series& series, std::size_t count) {
    TimeFigure figure{series.file, title_, series.quantity, series.unit, series.names, time_, {}};
    for (std::size_t k = 0; k < count; ++k) {
      auto value = column_of(series.rows, k);
      plot_.data += block(time_, value, k + 1, negligible_height * greatest(series.rows));
      figure.curves.push_back(
          {series.name[k], fmt::format("'plot.csv' index {}", block_++), 2, 3, std::move(value)});
    }
    plot_.script += script(figure, plot_.axis);
  }

  void add_map(const Series& series) {
    const HeatMap map{series.file, title_,      series.along,  series.quantity,    series.unit,
                      time_,       series.rows, series.number, figure_.logarithmic};
    plot_.data += heat_map_data(map, plot_.axis);
    plot_.script += script(map, plot_.axis, block_);
    block_ += plot_.axis.windows.size();
  }

  const std::vector<double>& time_;
  const std::string& title_;
  const scene::Figure& figure_;
  RunPlot& plot_;
  std::size_t block_ = 0;
};

std::vector<std::string> numbered(const char* format, std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(fmt::format(fmt::runtime(format), i + 1));
  return names;
}

/// Speeds of balls that move in `dimension` directions.
Rows speeds(const Rows& velocity, std::size_t dimension) {
  Rows rows;
  for (const auto& row : velocity) {
    std::vector<double> speed(row.size() / dimension);
    for (std::size_t i = 0; i < row.size(); ++i)
      speed[i / dimension] = std::hypot(speed[i / dimension], row[i]);
    rows.push_back(std::move(speed));
  }
  return rows;
}

/// The place of a ball or contact among the lines of a series.
std::size_t place_of(Index number, const std::vector<Index>& numbers) {
  if (numbers.empty()) return static_cast<std::size_t>(number) - 1;
  return static_cast<std::size_t>(std::find(numbers.begin(), numbers.end(), number) - numbers.begin());
}

/// Leaves these balls or contacts alone, of `width` columns each, or all where it has none of them.
void choose(const std::vector<Index>& chosen, std::size_t width, Series& series) {
  std::vector<std::size_t> columns;
  std::vector<Index> numbers;
  for (const Index number : chosen) {
    const auto first = width * place_of(number, series.number);
    if (first + width > series.name.size()) continue;
    numbers.push_back(number);
    for (std::size_t k = 0; k < width; ++k) columns.push_back(first + k);
  }
  if (columns.empty()) return;
  const auto pick = [&](auto& all) {
    auto every = std::exchange(all, {});
    for (const auto column : columns) all.push_back(std::move(every[column]));
  };
  for (auto& row : series.rows) pick(row);
  pick(series.name);
  series.number = std::move(numbers);
}

Series velocities(const impact::Trace& trace, const CurveNames& names, const std::vector<Index>& chosen) {
  const auto count = columns_of(trace.velocity);
  Series series{"velocities",  "velocity v",     "ball i",      trace.velocity_unit,
                Names::at_end, names.velocities, trace.velocity};
  if (series.name.empty()) series.name = numbered((trace.moving + " {}").c_str(), count);
  const auto dimension = static_cast<std::size_t>(names.dimension);
  const bool are_few = (chosen.empty() ? count : chosen.size() * dimension) <= most_curves;
  if (dimension > 1 && !are_few) {
    series.quantity = "speed v";
    series.name = numbered("ball {}", count / dimension);
    series.rows = speeds(trace.velocity, dimension);
  }
  choose(chosen, are_few ? dimension : 1, series);
  return series;
}

Series forces(const impact::Trace& trace, const CurveNames& names, const std::vector<Index>& chosen) {
  Series series{
      "forces",       "contact force f",
      "contact j",    "N",
      Names::at_peak, names.contacts.empty() ? numbered("f_{{{}}}", columns_of(trace.force)) : names.contacts,
      trace.force,    names.numbers};
  choose(chosen, 1, series);
  return series;
}

}  // namespace

RunPlot plot(const impact::ContactImpact& impact, const std::string& title, const CurveNames& names,
             const scene::Figure& figure, const std::vector<Series>& more) {
  const auto& trace = impact.trace;
  RunPlot plot{
      .data = "", .script = script_head(), .axis = time_axis(action_of(trace), impact.events, figure)};
  Writer writer(trace.time, title, figure, plot);
  writer.add(velocities(trace, names, figure.balls));
  writer.add(forces(trace, names, figure.contacts));
  for (const auto& series : more) writer.add(series);
  return plot;
}

}  // namespace mariotte::report
