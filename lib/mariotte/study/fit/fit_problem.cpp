#include "mariotte/study/fit/fit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mariotte/core/error.hpp"

namespace mariotte::study {
namespace {

using Values = std::vector<double>;

constexpr double least_step = 1e-4;  // of differences; (step)²/6 is below what slopes need
constexpr double widest = 14;        // ln of the largest factor between start and value
constexpr double scan_factor = 4;
constexpr std::size_t most_scanned = 5;  // keys: 3⁵ times all measurements

Values moved(std::span<const double> x, std::size_t j, double step) {
  Values other(x.begin(), x.end());
  other[j] += step;
  return other;
}

/// The neighbours of the start, counted in the base of three.
Values neighbour(std::size_t number, std::size_t keys) {
  Values x(keys, 1);
  for (double& one : x) {
    one += std::log(scan_factor) * (static_cast<double>(number % 3) - 1);
    number /= 3;
  }
  return x;
}

double weighted_residual(const Measurement& one, const Prediction& predicted) {
  return (one.measured - predicted.value) / one.deviation;
}

}  // namespace

FitProblem::FitProblem(FitModel& model)
    : model_(model), step_(std::max(least_step, std::cbrt(model.accuracy()))) {}

Values FitProblem::values(std::span<const double> x) const {
  Values values(x.begin(), x.end());
  for (std::size_t j = 0; j < x.size(); ++j) values[j] = model_.start()[j] * std::exp(x[j] - 1);
  return values;
}

std::vector<Prediction> FitProblem::predicted(std::span<const double> x) const {
  const auto at = values(x);
  std::vector<Prediction> all;
  for (std::size_t row = 0; row < count(); ++row) all.push_back(model_.of_row(row, at));
  return all;
}

void FitProblem::residuals(std::span<const double> x, std::span<double> r) const {
  for (const double one : x)
    if (!(std::abs(one - 1) < widest)) throw Error("a value left the range of the search");
  const auto all = predicted(x);
  for (std::size_t row = 0; row < r.size(); ++row)
    r[row] = weighted_residual(model_.measurements().rows[row], all[row]);
}

void FitProblem::slopes(std::span<const double> x, std::span<double> columns) const {
  fill(x, columns, true);
}

void FitProblem::search_slopes(std::span<const double> x, std::span<double> columns) const {
  fill(x, columns, model_.searches_by_slopes());
}

void FitProblem::fill(std::span<const double> x, std::span<double> columns, bool exact) const {
  const auto at = values(x);
  for (std::size_t row = 0; row < count(); ++row) {
    const auto known = exact ? model_.slopes_of_row(row, at) : Slopes(x.size());
    for (std::size_t j = 0; j < x.size(); ++j)
      columns[j * count() + row] =
          -(known[j] ? *known[j] * at[j] : difference(row, x, j)) / model_.measurements().rows[row].deviation;
  }
}

double FitProblem::difference(std::size_t row, std::span<const double> x, std::size_t j) const {
  const auto rebound = [&](double step) { return model_.of_row(row, values(moved(x, j, step))); };
  const auto beside = [&](double step) -> std::optional<double> {
    try {
      const auto found = rebound(step);
      return found.captured ? std::nullopt : std::optional(found.value);
    } catch (const Error&) {
      return std::nullopt;
    }
  };
  const auto less = beside(-step_), more = beside(step_);
  if (less && more) return (*more - *less) / (2 * step_);
  const auto here = rebound(0);
  if (here.captured || !(less || more)) return 0;
  return (more ? *more - here.value : here.value - *less) / step_;
}

bool FitProblem::is_possible(std::span<const double> x) const {
  try {
    model_.of_row(0, values(x));
    return true;
  } catch (const Error&) {
    return false;
  }
}

FitProblem::Scatter FitProblem::scatter(std::span<const double> x) const {
  const auto all = predicted(x);
  Scatter found;
  for (std::size_t row = 0; row < all.size(); ++row) {
    const auto& measured = model_.measurements().rows[row];
    found.squares += std::pow(weighted_residual(measured, all[row]), 2);
    found.rows += !all[row].captured || measured.measured != 0;
  }
  return found;
}

double FitProblem::measured_size() const {
  double squares = 0;
  for (const auto& one : model_.measurements().rows) squares += std::pow(one.measured / one.deviation, 2);
  return std::sqrt(squares);
}

std::vector<Values> FitProblem::starts() const {
  const auto keys = model_.start().size();
  const Values start(keys, 1);
  std::vector<std::pair<double, Values>> known = {{sum_of_squares(start), start}};
  const auto neighbours = keys > most_scanned ? 0 : static_cast<std::size_t>(std::lround(std::pow(3, keys)));
  for (std::size_t number = 0; number < neighbours; ++number) try {
      auto x = neighbour(number, keys);
      const double sum = x == start ? NAN : sum_of_squares(x);
      if (std::isfinite(sum)) known.emplace_back(sum, std::move(x));
    } catch (const Error&) {
      // A neighbour that cannot be simulated is no place to start from.
    }
  std::stable_sort(known.begin(), known.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Values> all;
  for (auto& one : known) all.push_back(std::move(one.second));
  return all;
}

}  // namespace mariotte::study
