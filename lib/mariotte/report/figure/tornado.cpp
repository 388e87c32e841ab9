#include "mariotte/report/figure/tornado.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/curve_labels.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/palette.hpp"
#include "mariotte/report/figure/ticks.hpp"
#include "mariotte/report/figure/title.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr const char* figure = "tornado";
constexpr std::size_t most_bars = 8, most_panels = 12;
constexpr double told_from_zero = 1e-9;  // the errors of runs are below
constexpr const char* what_is_shown = "% of the outcome per % of the parameter";
constexpr std::size_t letters_of_wide = 88;       ///< in a title of both columns
constexpr int head_height = 74, bar_height = 20;  ///< of a panel, in pixels of the screen

struct Panel {
  std::string name;
  std::vector<RelativeSlope> bars;
};

struct Word {
  std::string_view name, words, symbol;
};

const Word* find(std::span<const Word> words, std::string_view name) {
  const auto found =
      std::find_if(words.begin(), words.end(), [&](const Word& one) { return one.name == name; });
  return found == words.end() ? nullptr : &*found;
}

/// Of `[bodies]`: "body 1: final velocity v_x" of bodies[0].velocity[0].
std::optional<std::string> words_for_part(const impact::OutcomeSlopes& outcome) {
  constexpr std::array<Word, 7> words{{{"velocity", "final velocity", "v"},
                                       {"spin", "final spin", "ω"},
                                       {"normal_impulse", "normal impulse", "p_n"},
                                       {"tangential_impulse", "tangential impulse", "p_t"},
                                       {"losses.friction", "loss by friction", "D"},
                                       {"losses.rescale", "loss by unloading", "D"},
                                       {"losses.damper", "loss by the damper", "D"}}};
  const auto open = outcome.name.find('['), close = outcome.name.find("].");
  if (open == std::string::npos || close == std::string::npos) return {};
  const auto rest = std::string_view(outcome.name).substr(close + 2);
  const auto* found = find(words, rest);
  if (!found) return {};
  const auto number = std::stol(outcome.name.substr(open + 1, close - open - 1)) + 1;
  auto symbol = std::string(found->symbol);
  if (outcome.index) {
    const char axis = "xyz"[*outcome.index];
    symbol = symbol.ends_with("_t") ? fmt::format("p_{{t,{}}}", axis) : fmt::format("{}_{}", symbol, axis);
  }
  return fmt::format("{} {}: {} {}", outcome.name.starts_with("bodies[") ? "body" : "contact", number,
                     found->words, symbol);
}

std::string words_for(const impact::OutcomeSlopes& outcome) {
  if (const auto words = words_for_part(outcome)) return *words;
  constexpr std::array<Word, 14> words{{{"velocity", "final velocity", "v"},
                                        {"impulse", "impulse", "p"},
                                        {"icr", "impulse correlation ratio", "α"},
                                        {"time", "final time", "t"},
                                        {"dissipated", "dissipated energy", "D"},
                                        {"normal_velocity", "final velocity", "v_1"},
                                        {"v2", "final velocity", "v_2"},
                                        {"v3", "final velocity", "v_3"},
                                        {"w1", "final spin", "ω_1"},
                                        {"w2", "final spin", "ω_2"},
                                        {"w3", "final spin", "ω_3"},
                                        {"e_n", "tip restitution", "e_n"},
                                        {"e_nm", "centre restitution", "e_{nm}"},
                                        {"contact_time", "contact time", "t"}}};
  const auto* found = find(words, outcome.name);
  if (!found)
    return plain(outcome.index ? fmt::format("{}[{}]", outcome.name, *outcome.index) : outcome.name);
  if (!outcome.index) return fmt::format("{} {}", found->words, found->symbol);
  return fmt::format("{} {}_{{{}}}", found->words, found->symbol, *outcome.index + 1);
}

std::vector<Panel> panels(const impact::Sensitivity& slopes) {
  std::vector<Panel> list;
  for (const auto& outcome : slopes.outcome) {
    auto bars = relative_slopes(slopes, outcome);
    if (bars.empty() || list.size() == most_panels) continue;
    bars.resize(std::min(bars.size(), most_bars));
    list.push_back({words_for(outcome), std::move(bars)});
  }
  return list;
}

/// Few ticks, whose numbers are long, but two at least.
double step_of_ticks(double least, double most) {
  double step = tick_step(most - least, 3);
  while (std::floor(most / step) - std::ceil(least / step) < 1) step /= 2;
  return step;
}

/// Bars from the top, with the names of their parameters, and room on both sides of zero. A long title goes
/// on to the left, over the names.
std::string commands(const Panel& panel, std::size_t number, std::size_t places) {
  std::string tics;
  double least = 0, most = 0;
  for (std::size_t i = 0; i < panel.bars.size(); ++i) {
    tics += fmt::format("{}{} -{}", i ? ", " : "", quoted(name_of_input(panel.bars[i].parameter)), i + 1);
    least = std::min(least, panel.bars[i].value);
    most = std::max(most, panel.bars[i].value);
  }
  const double length = most - least, room = 0.08 * length;
  return fmt::format(
      "set label 1 {} at graph 1, graph 1 right offset 0,0.7 textcolor rgb '#000000'\nset xtics {:.4g}\nset "
      "ytics ({})\nset xrange [{:.4g}:{:.4g}]\nset yrange "
      "[-{}.6:-0.4]\n"
      "plot 'bars.csv' every ::1 using (($1=={} && $3<0) ? $3/2 : NaN):(-$2):($3):(0):(-$2-0.34):(-$2+0.34) "
      "with boxxyerror lc rgb '{}' notitle, \\\n"
      "  '' every ::1 using (($1=={} && $3>0) ? $3/2 : NaN):(-$2):(0):($3):(-$2-0.34):(-$2+0.34) "
      "with boxxyerror lc rgb '{}' notitle\n",
      quoted(panel.name), step_of_ticks(least - room, most + room), tics, least - room, most + room, places,
      number, line_colours[2], number, line_colours[1]);
}

/// Of the longest name of a bar, so that all panels are alike.
std::size_t letters_of_names(const std::vector<Panel>& list) {
  std::size_t most = 19;
  for (const auto& panel : list)
    for (const auto& bar : panel.bars) most = std::max(most, letters(name_of_input(bar.parameter)));
  return most;
}

/// A narrow figure says below its axis what it shows.
std::string heading(const Title& title, std::size_t rows, std::size_t columns) {
  const auto layout =
      fmt::format("set multiplot layout {},{} title {} noenhanced\n", rows, columns, title.text);
  return columns > 1 ? layout : layout + "set xlabel " + quoted(what_is_shown) + "\n";
}

}  // namespace

std::vector<RelativeSlope> relative_slopes(const impact::Sensitivity& slopes,
                                           const impact::OutcomeSlopes& outcome) {
  std::vector<RelativeSlope> bars;
  if (!outcome.value || *outcome.value == 0) return bars;
  double longest = 0;
  for (std::size_t c = 0; c < slopes.parameter.size(); ++c) {
    const auto& slope = outcome.slope[c];
    const double relative = slope.value_or(0) * slopes.parameter[c].value / *outcome.value;
    bars.push_back({slopes.parameter[c].name, relative});
    longest = std::max(longest, std::abs(relative));
  }
  std::erase_if(bars, [&](const RelativeSlope& bar) {
    return !(std::abs(bar.value) > std::max(1e-6 * longest, told_from_zero));
  });
  std::stable_sort(bars.begin(), bars.end(), [](const RelativeSlope& a, const RelativeSlope& b) {
    return std::abs(a.value) > std::abs(b.value);
  });
  return bars;
}

std::string tornado_csv(const impact::Sensitivity& slopes) {
  std::string text = "panel,place,slope [% per %],parameter\n";
  const auto list = panels(slopes);
  for (std::size_t k = 0; k < list.size(); ++k)
    for (std::size_t i = 0; i < list[k].bars.size(); ++i)
      text += fmt::format("{},{},{},{}\n", k + 1, i + 1, exact(list[k].bars[i].value),
                          cell(list[k].bars[i].parameter));
  return text;
}

std::string tornado_script(const impact::Sensitivity& slopes, const std::string& title) {
  const auto list = panels(slopes);
  if (list.empty()) return "";
  std::size_t most = 0;
  for (const auto& panel : list) most = std::max(most, panel.bars.size());
  const std::size_t columns = list.size() > 1 ? 2 : 1, rows = (list.size() + columns - 1) / columns;
  const auto name = title.empty() ? "Sensitivity" : title;
  const auto head = columns > 1 ? wrapped(name + ": " + what_is_shown, letters_of_wide) : wrapped(name);
  std::string plot = heading(head, rows, columns);
  for (std::size_t k = 0; k < list.size(); ++k) plot += commands(list[k], k + 1, most);
  const auto height = static_cast<int>(rows) * (head_height + bar_height * static_cast<int>(most)) +
                      (columns > 1 ? 30 : 50) + head.more_height;
  return script_head() +
         fmt::format(
             "set style fill solid noborder\nset xzeroaxis\nset arrow from 0, graph 0 to 0, graph 1 "
             "nohead lc rgb '#555555'\nunset key\nset grid xtics noytics\nset xtics nomirror\n"
             "set lmargin {}\nset rmargin 3\nset tmargin 2.5\nset border 1\nset ytics scale 0\n",
             letters_of_names(list)) +
         on_all_terminals(figure, plot + "unset multiplot\n",
                          {columns > 1 ? wide.width : one_column.width, height});
}

std::vector<std::string> tornado_figures() {
  return files_of_figure(figure);
}

}  // namespace mariotte::report
