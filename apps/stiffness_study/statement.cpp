#include "statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mariotte::stiffness_study {
namespace {

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return infinity;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double difference(const std::vector<std::optional<double>>& a, const std::vector<std::optional<double>>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].has_value() != b[i].has_value()) return infinity;
    if (a[i]) largest = std::max(largest, std::abs(*a[i] - *b[i]));
  }
  return largest;
}

double last(const std::vector<double>& instants) {
  return instants.empty() ? 1 : instants.back();
}

void compare(Spread& spread, const Run& first, const Run& run) {
  spread.velocity = std::max(spread.velocity, difference(first.velocity, run.velocity));
  spread.icr = std::max(spread.icr, difference(first.icr, run.icr));
  spread.instants =
      std::max(spread.instants, difference(first.instants, run.instants) / last(first.instants));
  for (std::size_t i = 0; i + 1 < run.velocity.size(); ++i)
    spread.slowest = std::min(spread.slowest, std::abs(run.velocity[i + 1] - run.velocity[i]));
  spread.least_steps = std::min(spread.least_steps, run.steps);
  spread.most_steps = std::max(spread.most_steps, run.steps);
}

/// Times of two flows at one value.
struct Pair {
  double value, a, b;
};

std::vector<Pair> pairs(const Rows& rows, const std::string& a, const std::string& b) {
  std::vector<Pair> found;
  for (const auto& one : rows)
    for (const auto& other : rows)
      if (one.flow == a && other.flow == b && one.value == other.value && one.run.seconds > 0 &&
          other.run.seconds > 0)
        found.push_back({one.value, one.run.seconds, other.run.seconds});
  return found;
}

}  // namespace

Spread spread(const Rows& rows) {
  Spread spread;
  for (const auto& flow : names(rows, &Row::flow)) {
    const Run* first = nullptr;
    for (const auto& row : rows) {
      if (row.flow != flow || row.run.ending == "-") continue;
      if (!row.run.separated()) {
        ++spread.unfinished;
        continue;
      }
      if (!first) first = &row.run;
      if (++spread.runs == 1) spread.least_steps = spread.most_steps = row.run.steps;
      compare(spread, *first, row.run);
    }
  }
  return spread;
}

double allowed(double accuracy) {
  return std::max(10 * accuracy, 1e-12);
}

Statement invariance(const std::string& claim, const Rows& over_stiffness, const Rows& over_everything) {
  const auto stiffness = spread(over_stiffness), all = spread(over_everything);
  const double bound = allowed(over_everything.front().accuracy), late = bound / all.slowest;
  const bool holds = stiffness.runs > 0 && all.unfinished == 0 && all.velocity <= bound && all.icr <= bound &&
                     stiffness.instants <= bound && all.instants <= late;
  return {
      Statement::Kind::theorem,
      fmt::format(
          "{}: ICRs agree within {:.1e}, velocities within {:.1e} (allowed {:.0e}), instants in t/T within "
          "{:.1e} over k (allowed {:.0e}) and {:.1e} over all (allowed {:.0e}); {} runs, {} unfinished",
          claim, all.icr, all.velocity, bound, stiffness.instants, bound, all.instants, late, all.runs,
          all.unfinished),
      holds};
}

std::vector<std::string> names(const Rows& rows, std::string Row::*name) {
  std::vector<std::string> list;
  for (const auto& row : rows)
    if (std::find(list.begin(), list.end(), row.*name) == list.end()) list.push_back(row.*name);
  return list;
}

std::string range(const Rows& rows) {
  if (rows.empty()) return "nothing";
  const auto [least, most] = std::minmax_element(
      rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.value < b.value; });
  return fmt::format("{:g} … {:g}", least->value, most->value);
}

Statement steps_statement(const Rows& rows, const std::string& quantity) {
  std::vector<std::string> counts;
  bool constant = true;
  for (const auto& flow : names(rows, &Row::flow)) {
    const auto found = spread(select(rows, [&](const Row& row) { return row.flow == flow; }));
    if (found.runs == 0) continue;
    const bool same = found.least_steps == found.most_steps;
    constant = constant && same;
    counts.push_back(same ? fmt::format("{} {}", flow, found.least_steps)
                          : fmt::format("{} {} … {}", flow, found.least_steps, found.most_steps));
  }
  if (counts.empty())
    return {Statement::Kind::observation, rows.front().series + ": every flow took too long"};
  return {Statement::Kind::observation,
          fmt::format("{}: steps constant over {} = {}: {} ({})", rows.front().series, quantity, range(rows),
                      constant ? "yes" : "no", fmt::join(counts, ", "))};
}

Statement times_statement(const Rows& rows, const std::string& quantity) {
  std::vector<std::string> times;
  for (const auto& flow : names(rows, &Row::flow)) {
    double least = infinity, most = 0;
    const Row* last = nullptr;
    for (const auto& row : rows) {
      if (row.flow != flow || !row.run.separated()) continue;
      least = std::min(least, row.run.seconds);
      most = std::max(most, row.run.seconds);
      last = &row;
    }
    if (last)
      times.push_back(fmt::format("{} {:.3g} ({:.3g} … {:.3g} µs up to {:g})", flow, most / least,
                                  1e6 * least, 1e6 * most, last->value));
  }
  return {Statement::Kind::observation,
          fmt::format("{}: run times over {} = {} within a factor: {}", rows.front().series, quantity,
                      range(rows), fmt::join(times, ", "))};
}

std::vector<Statement> error_statements(const Rows& rows) {
  std::vector<Statement> statements;
  for (const auto& flow : names(rows, &Row::flow)) {
    const Row* worst = nullptr;
    for (const auto& row : rows)
      if (row.flow == flow && row.error >= (worst ? worst->error : 0)) worst = &row;
    if (!worst) continue;
    statements.push_back(
        {Statement::Kind::observation,
         fmt::format("{}: largest error of a velocity {:.1e}, {} the accuracy of {:.0e} ({}, {} "
                     "at {:g}; reference {})",
                     flow, worst->error, worst->error <= worst->accuracy ? "within" : "above",
                     worst->accuracy, worst->series, worst->family, worst->value, worst->reference)});
  }
  return statements;
}

Statement comparison(const Rows& rows, const std::string& a, const std::string& b) {
  std::vector<std::string> ratios, crossings;
  const auto both = pairs(rows, a, b);
  for (std::size_t i = 0; i < both.size(); ++i) {
    const auto& [value, time, other] = both[i];
    ratios.push_back(fmt::format("{:.2g} at {:.3g}", time / other, value));
    if (i == 0) continue;
    const double before = std::log(both[i - 1].a / both[i - 1].b), after = std::log(time / other);
    if (before * after < 0)
      crossings.push_back(fmt::format(
          "{:.2g}", both[i - 1].value * std::pow(value / both[i - 1].value, before / (before - after))));
  }
  return {Statement::Kind::observation,
          fmt::format("{}: {} and {} cost the same at {} = {}; time ratio {}", rows.front().series, a, b,
                      rows.front().family,
                      crossings.empty() ? "(nowhere)" : fmt::format("{}", fmt::join(crossings, ", ")),
                      fmt::join(ratios, ", "))};
}

}  // namespace mariotte::stiffness_study
