#include "measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "mariotte/core/error.hpp"

namespace mariotte::work_precision {
namespace {

constexpr int loosest = -3, tightest = -15;  // decades of the tolerances
constexpr double fewest_steps = 8;           // per unit of time
constexpr double most_steps_per_time = 1 << 28;
constexpr double useless = 1;  // an error of the size of the velocities, or of a method that is unstable

std::vector<double> ladder(const Method& method, const Effort& effort) {
  std::vector<double> settings;
  if (method.family == Family::fixed_step)
    for (double rate = fewest_steps; rate < most_steps_per_time; rate *= 1 << effort.doublings)
      settings.push_back(rate);
  else
    for (int decade = tightest; decade <= loosest; ++decade)
      if (decade % effort.decades == 0) settings.insert(settings.begin(), std::pow(10.0, decade));
  return settings;
}

double error(const Answer& answer, const Case& one) {
  long double largest = 0;
  for (std::size_t i = 0; i < one.velocity.size(); ++i) {
    const long double difference = std::abs(answer.velocity[i] - one.velocity[i]);
    if (!(difference <= largest)) largest = std::isnan(difference) ? infinity : difference;
  }
  return static_cast<double>(largest);
}

/// The first pass: errors, counts and, by the way, a warm-up. Empty if a map takes too long.
std::optional<Row> examine(const Problem& problem, const Solve& solve, double longest, double& seconds) {
  Row row{};
  const double start = measuring::cpu_seconds();
  for (const auto& one : problem.cases) {
    const Answer& answer = solve(one);
    row.errors.push_back(error(answer, one));
    row.rhs += static_cast<double>(answer.rhs);
    row.steps += static_cast<double>(answer.steps);
    row.events += static_cast<double>(answer.events);
    row.told_periods = !answer.periods.empty() && !one.periods.empty();
    row.wrong_periods += row.told_periods && answer.periods != one.periods;
    seconds = measuring::cpu_seconds() - start;
    if (seconds > longest && &one != &problem.cases.back()) return std::nullopt;
  }
  row.error = *std::max_element(row.errors.begin(), row.errors.end());
  return row;
}

std::optional<Row> point(const Problem& problem, const Solve& solve, const measuring::Patience& patience) {
  double first = 0;
  auto row = examine(problem, solve, patience.longest, first);
  if (!row) return row;
  const auto pass = [&] {
    for (const auto& one : problem.cases) solve(one);
  };
  const auto cases = static_cast<double>(problem.cases.size());
  row->seconds = measuring::least_seconds(pass, first, patience) / cases;
  row->rhs /= cases;
  row->steps /= cases;
  row->events /= cases;
  return row;
}

/// One rung of the ladder; empty if it is the end of it. A method that gives up has no bound on its error and
/// may be luckier on the next rung.
std::optional<Row> rung(const Problem& problem, const Method& method, double setting,
                        const measuring::Patience& patience) {
  try {
    const Solve solve = method.prepare(problem, setting);
    if (!solve) return std::nullopt;
    auto row = point(problem, solve, patience);
    if (!row) return row;
    row->problem = problem.name;
    row->method = method.name;
    row->family = method.family;
    row->tolerance = method.family == Family::fixed_step ? 1 / setting : setting;
    return row;
  } catch (const Error& reason) {
    fmt::print(stderr, "{} by {} gives up at {:g}: {}\n", problem.name, method.name, setting, reason.what());
    Row row{};
    row.error = infinity;
    return row;
  }
}

}  // namespace

Effort full_effort() {
  return {.patience = {.batch = 4e-3, .batches = 9, .longest = 4},
          .decades = 1,
          .doublings = 1,
          .map_stride = 1,
          .map_patience = {.batch = 0.2, .batches = 3, .longest = 8}};
}

Effort quick_effort() {
  return {.patience = {.batch = 1e-3, .batches = 5, .longest = 0.1},
          .decades = 2,
          .doublings = 2,
          .map_stride = 7,
          .map_patience = {.batch = 0.01, .batches = 2, .longest = 0.6}};
}

std::vector<Row> measure(const Problem& problem, const Method& method, const Effort& effort) {
  const auto& patience = problem.cases.size() > 1 ? effort.map_patience : effort.patience;
  const int growth = method.family == Family::fixed_step ? 1 << effort.doublings : 1;
  std::vector<Row> points;
  for (const double setting : ladder(method, effort)) {
    auto row = rung(problem, method, setting, patience);
    if (!row) break;
    const double pass = row->seconds * static_cast<double>(problem.cases.size());
    if (row->error < useless) points.push_back(std::move(*row));
    if (growth * pass > patience.longest) break;
  }
  return points;
}

std::string csv(const std::vector<Row>& rows) {
  std::string text = "problem,method,tolerance,error,seconds,rhs,steps,events\n";
  for (const auto& row : rows)
    text += fmt::format("{},{},{:g},{:.4g},{:.4g},{:.6g},{:.6g},{:.6g}\n", row.problem, row.method,
                        row.tolerance, row.error, row.seconds, row.rhs, row.steps, row.events);
  return text;
}

}  // namespace mariotte::work_precision
