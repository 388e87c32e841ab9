#include "mariotte/study/fit/fit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  for (std::size_t row = 0; row < r.size(); ++row) {
    const auto& one = model_.measurements().rows[row];
    r[row] = (one.measured - all[row].value) / one.deviation;
  }
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
  const auto predicted = [&](double step) { return model_.of_row(row, values(moved(x, j, step))); };
  const auto less = predicted(-step_), more = predicted(step_);
  if (!less.captured && !more.captured) return (more.value - less.value) / (2 * step_);
  const auto here = predicted(0);
  if (here.captured || (less.captured && more.captured)) return 0;
  return (less.captured ? more.value - here.value : here.value - less.value) / step_;
}

double FitProblem::sum_of_squares(std::span<const double> x) const {
  Values r(count());
  residuals(x, r);
  return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
}

Values FitProblem::best_start() const {
  const auto keys = model_.start().size();
  Values best(keys, 1);
  if (keys > most_scanned) return best;
  double least = sum_of_squares(best);
  const auto neighbours = static_cast<std::size_t>(std::lround(std::pow(3, keys)));
  for (std::size_t number = 0; number < neighbours; ++number) try {
      const auto x = neighbour(number, keys);
      const double sum = sum_of_squares(x);
      if (sum < least) best = x;
      least = std::min(sum, least);
    } catch (const Error&) {
      // A neighbour that cannot be simulated is no place to start from.
    }
  return best;
}

}  // namespace mariotte::study
