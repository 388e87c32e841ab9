#include "mariotte/study/fit/fit_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mariotte/core/error.hpp"
#include "mariotte/study/fit/uncertainty.hpp"

namespace mariotte::study {
namespace {

using Values = std::vector<double>;

// Differences have some six digits; keys whose effects differ by less cannot be told apart.
constexpr double slope_tolerance = 1e-5;
/// Smaller slopes, over what was measured, may be rounding of runs alone.
constexpr double rounding_of_slopes = 1e-7;

/// Smallest value / start that is not taken for zero, where nothing depends on it any more.
constexpr double nothing = 1e-3;
/// Standard error / value from which a value is hardly known, and the search tries elsewhere.
constexpr double loose = 3;
/// Ratio of sums of squares above which they differ by what searches leave.
constexpr double alike = 1 - 1e-6;
/// Tolerance of a search, and of one that only says whether it leads elsewhere.
constexpr double fine = 1e-10, rough = 1e-3;
constexpr std::size_t least_searches = 4, most_searches = 8;

/// The slopes by key j.
std::span<const double> column(const Values& columns, std::size_t rows, std::size_t j) {
  return std::span(columns).subspan(j * rows, rows);
}

/// Keys but for those that the search has followed down until nothing depends on them any more, beside what
/// depends on another key, or beside the measured values, whose size is given.
std::vector<std::size_t> held(const Values& columns, const Values& x, double measured) {
  const auto rows = columns.size() / x.size();
  const auto size = [&](std::size_t j) {
    const auto c = column(columns, rows, j);
    return std::sqrt(std::inner_product(c.begin(), c.end(), c.begin(), 0.0));
  };
  double largest = x.size() == 1 ? measured : 0;
  for (std::size_t j = 0; j < x.size(); ++j) largest = std::max(largest, size(j));
  std::vector<std::size_t> keys;
  for (std::size_t j = 0; j < x.size(); ++j)
    if (x[j] - 1 >= std::log(nothing) || size(j) > slope_tolerance * largest) keys.push_back(j);
  return keys;
}

/// How well a minimum is known.
void assess(const FitProblem& problem, Found& found) {
  const auto keys = found.minimum.x.size();
  found.held = held(found.columns, found.minimum.x, problem.measured_size());
  const auto columns = found.held_columns();
  found.directions = undetermined(columns, std::ssize(found.held), slope_tolerance,
                                  rounding_of_slopes * problem.measured_size());
  if (found.degrees_of_freedom < 1 || !found.directions.empty()) return;
  const auto errors = uncertainty(columns, std::ssize(found.held)).standard_error;
  const double scatter = std::sqrt(found.squares / static_cast<double>(found.degrees_of_freedom));
  found.relative_error.assign(keys, infinity);
  for (std::size_t k = 0; k < errors.size(); ++k) found.relative_error[found.held[k]] = scatter * errors[k];
}

/// A minimum of which it is not known yet how well it is known.
Found search(const FitProblem& problem, const Values& start, double tolerance) {
  Found found{
      .minimum = minimise({.count = static_cast<Index>(problem.count()),
                           .residuals = [&](auto x, auto r) { problem.residuals(x, r); },
                           .slopes = [&](auto x, auto columns) { problem.search_slopes(x, columns); }},
                          start, tolerance),
      .columns = {}};
  const auto scatter = problem.scatter(found.minimum.x);
  found.squares = scatter.squares;
  found.degrees_of_freedom = scatter.rows - std::ssize(start);
  return found;
}

Found assessed(const FitProblem& problem, Found found) {
  found.columns.resize(problem.count() * found.minimum.x.size());
  problem.slopes(found.minimum.x, found.columns);
  assess(problem, found);
  return found;
}

}  // namespace

bool Found::is_firm() const {
  const auto is_known = [](double error) { return error < loose; };
  return minimum.converged && !relative_error.empty() &&
         std::all_of(relative_error.begin(), relative_error.end(), is_known);
}

Values Found::held_columns() const {
  Values some;
  for (const auto j : held) {
    const auto c = column(columns, columns.size() / minimum.x.size(), j);
    some.insert(some.end(), c.begin(), c.end());
  }
  return some;
}

Found best_of_searches(const FitProblem& problem, const std::vector<Values>& starts) {
  auto best = assessed(problem, search(problem, starts.front(), fine));
  const auto enough = [&] { return best.is_firm() ? least_searches : most_searches; };
  for (std::size_t i = 1; i < std::min(starts.size(), enough()); ++i) try {
      auto found = search(problem, starts[i], rough);
      if (!(found.squares < alike * best.squares)) continue;
      found = assessed(problem, search(problem, found.minimum.x, fine));
      if (!found.minimum.converged || !(found.squares < alike * best.squares)) continue;
      if (!found.relative_error.empty()) best = std::move(found);
    } catch (const Error&) {
      // A way on which something cannot be simulated leads nowhere.
    }
  return best;
}

}  // namespace mariotte::study
