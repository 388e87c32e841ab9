#include "ratios.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mariotte::work_precision {
namespace {

constexpr double targets[] = {1e-6, 1e-8, 1e-10, 1e-12, 1e-14};
constexpr double none = std::numeric_limits<double>::infinity();

/// The least run time among those rows that reach the error; `none` if there is no such row.
template <class Counts>
double cheapest(const std::vector<Row>& rows, const std::string& problem, double target,
                const Counts& counts) {
  double least = none;
  for (const auto& row : rows)
    if (row.problem == problem && row.error <= target && counts(row)) least = std::min(least, row.seconds);
  return least;
}

std::string time(double seconds) {
  if (seconds == none) return "-";
  if (seconds < 1e-3) return fmt::format("{:.3g} µs", 1e6 * seconds);
  return seconds < 1 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

std::string ratio(double seconds, double ours) {
  return seconds == none || ours == none ? "-" : fmt::format("{:.3g}", seconds / ours);
}

std::string line(const std::vector<Row>& rows, const std::string& problem, double target) {
  const auto of = [&](Family family) {
    return cheapest(rows, problem, target, [&](const Row& row) { return row.family == family; });
  };
  const double ours = cheapest(rows, problem, target, [](const Row& row) { return row.method == "auto"; });
  std::string text = fmt::format("{:<10} {:>7g} {:>10}", problem, target, time(ours));
  for (const auto family : {Family::sundials, Family::odeint, Family::fixed_step})
    text += fmt::format(" {:>10} {:>8}", time(of(family)), ratio(of(family), ours));
  return text + "\n";
}

std::vector<std::string> problems(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows)
    if (std::find(names.begin(), names.end(), row.problem) == names.end()) names.push_back(row.problem);
  return names;
}

}  // namespace

std::string ratios(const std::vector<Row>& rows) {
  std::string text =
      "Cheapest CPU time per impact that reaches an error, and its ratio to that of auto\n(a ratio above 1: "
      "auto is that much faster)\n\n";
  text += fmt::format("{:<10} {:>7} {:>10} {:>10} {:>8} {:>10} {:>8} {:>10} {:>8}\n", "problem", "error",
                      "auto", "SUNDIALS", "ratio", "odeint", "ratio", "fixed step", "ratio");
  for (const auto& problem : problems(rows))
    for (const double target : targets) text += line(rows, problem, target);
  return text;
}

std::string map_accuracy(const std::vector<Row>& rows) {
  std::string text;
  for (const auto& row : rows) {
    if (row.method != "auto" || row.errors.size() < 2) continue;
    const auto within = std::count_if(row.errors.begin(), row.errors.end(),
                                      [&](double error) { return error <= row.tolerance; });
    text += fmt::format("{:>8g} {:>11.2f} % {:>21.3g} {:>16}\n", row.tolerance,
                        100.0 * static_cast<double>(within) / static_cast<double>(row.errors.size()),
                        row.error / row.tolerance,
                        row.told_periods ? std::to_string(row.wrong_periods) : "not told");
  }
  if (text.empty()) return text;
  return "What auto keeps of the accuracy it is asked for, over the map\n\n" +
         fmt::format("{:>8} {:>13} {:>21} {:>16}\n", "accuracy", "within it", "worst error/accuracy",
                     "wrong periods") +
         text;
}

}  // namespace mariotte::work_precision
