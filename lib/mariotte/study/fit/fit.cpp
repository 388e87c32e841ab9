#include "mariotte/study/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mariotte/core/counted.hpp"
#include "mariotte/study/fault.hpp"
#include "mariotte/study/fit/fit_problem.hpp"
#include "mariotte/study/fit/least_squares.hpp"
#include "mariotte/study/fit/uncertainty.hpp"

namespace mariotte::study {
namespace {

using Values = std::vector<double>;

// Differences have some six digits; keys whose effects differ by less cannot be told apart.
constexpr double slope_tolerance = 1e-5;

/// Rows, but for those that nothing can be learned from.
void expect_enough(const Measurements& measurements, std::size_t rows, std::size_t values) {
  if (rows > values) return;
  const bool all = rows == measurements.rows.size();
  throw scene::SceneError(
      fmt::format("{}: {}{} cannot give {} and {}; at least {} are needed", measurements.file,
                  counted(rows, "measurement"), all ? "" : " of what is not captured",
                  counted(values, "value"), values == 1 ? "its error" : "their errors", values + 1),
      fault::too_few_rows);
}

/// A place where nothing separates has no slope that could lead out of it.
void expect_separation(const FitProblem& problem, const Values& x) {
  const auto all = problem.predicted(x);
  if (std::all_of(all.begin(), all.end(), [](const Prediction& one) { return one.captured; }))
    throw FitError(
        "every body is predicted to be captured where the search starts; start from less damping, or look "
        "whether speeds and sizes have the right unit",
        fault::no_minimum);
}

/// Smallest value / start that is not taken for zero, where nothing depends on it any more.
constexpr double nothing = 1e-3;
/// Standard error / value from which a value is hardly known, and the search tries elsewhere.
constexpr double loose = 3;
/// Value / start below which a look at still less tells whether the value tends to zero.
constexpr double little = 0.1;
/// Ratio of sums of squares above which they differ by what searches leave.
constexpr double alike = 1 - 1e-6;
constexpr std::size_t most_searches = 8;

const char* why_undetermined(int count, bool vanishes) {
  if (count > 1) return ": these can change together and nothing that was measured does; leave one out";
  return vanishes ? ": it tends to zero; set it to 0 and leave it out"
                  : ": nothing that was measured depends on it";
}

void expect_determined(const Values& columns, const FitModel& model, const std::vector<std::string>& free,
                       const Values& values) {
  const auto directions = undetermined(columns, std::ssize(free), slope_tolerance);
  if (directions.empty()) return;
  std::string names;
  int count = 0;
  bool vanishes = false;
  for (std::size_t j = 0; j < free.size(); ++j) {
    const auto takes_part = [&](const Values& direction) { return std::abs(direction[j]) > 1e-3; };
    if (std::none_of(directions.begin(), directions.end(), takes_part)) continue;
    names += fmt::format("{}{} (here {:.4g})", count++ > 0 ? ", " : "", free[j], values[j]);
    vanishes = values[j] < nothing * model.start()[j];
  }
  throw FitError("the measurements do not determine " + names + why_undetermined(count, vanishes),
                 fault::undetermined);
}

/// A minimum with what tells how well it is known.
struct Found {
  Minimum minimum;
  Values columns;      ///< slopes of the residuals there
  double squares = 0;  ///< Σ residual²
  Index degrees_of_freedom = 0;
  Values relative_error = {};  ///< standard error / value; empty if nothing determines some value

  bool is_firm() const {
    const auto is_known = [](double error) { return error < loose; };
    return minimum.converged && !relative_error.empty() &&
           std::all_of(relative_error.begin(), relative_error.end(), is_known);
  }
};

Values relative_errors(const Found& found, Index keys) {
  if (found.degrees_of_freedom < 1 || !undetermined(found.columns, keys, slope_tolerance).empty()) return {};
  auto errors = uncertainty(found.columns, keys).standard_error;
  for (double& one : errors) one *= std::sqrt(found.squares / static_cast<double>(found.degrees_of_freedom));
  return errors;
}

Found search(const FitProblem& problem, const Values& start) {
  Found found{
      .minimum = minimise({.count = static_cast<Index>(problem.count()),
                           .residuals = [&](auto x, auto r) { problem.residuals(x, r); },
                           .slopes = [&](auto x, auto columns) { problem.search_slopes(x, columns); }},
                          start),
      .columns = Values(problem.count() * start.size())};
  problem.slopes(found.minimum.x, found.columns);
  const auto scatter = problem.scatter(found.minimum.x);
  found.squares = scatter.squares;
  found.degrees_of_freedom = scatter.rows - std::ssize(start);
  found.relative_error = relative_errors(found, std::ssize(start));
  return found;
}

/// From the best start; from the next ones, too, until one leads to values that are known.
Found best_of_searches(const FitProblem& problem, const std::vector<Values>& starts) {
  auto best = search(problem, starts.front());
  bool is_firm = best.is_firm();
  for (std::size_t i = 1; i < std::min(starts.size(), most_searches) && !is_firm; ++i) try {
      auto found = search(problem, starts[i]);
      is_firm = found.is_firm();
      const bool is_better = found.squares < alike * best.squares;
      if (is_better && found.minimum.converged && !found.relative_error.empty()) best = std::move(found);
    } catch (const Error&) {
      // A way on which something cannot be simulated leads nowhere.
    }
  return best;
}

void estimate(const FitModel& model, const std::vector<std::string>& free, const Values& values,
              const Values& relative_error, Fit& fit) {
  const double reach = student_t(fit.confidence, fit.degrees_of_freedom);
  for (std::size_t j = 0; j < free.size(); ++j) {
    const double relative = relative_error[j];
    fit.estimates.push_back({.key = free[j],
                             .start = model.start()[j],
                             .value = values[j],
                             .standard_error = values[j] * relative,
                             .lower = values[j] * std::exp(-reach * relative),
                             .upper = values[j] * std::exp(reach * relative)});
  }
}

void warn_of_loose(Fit& fit) {
  std::string names;
  for (const auto& one : fit.estimates)
    if (!(one.standard_error < loose * one.value))
      names += fmt::format("{}{} ({:.4g} ± {:.2g})", names.empty() ? "" : ", ", one.key, one.value,
                           one.standard_error);
  if (!names.empty())
    fit.warnings.push_back("the measurements do not determine " + names +
                           ": start from other values, or leave a key out");
}

/// Where still less fits no worse, only the end of the search keeps the value from zero.
void warn_of_vanishing(const FitProblem& problem, const Found& found, Fit& fit) {
  for (std::size_t j = 0; j < fit.estimates.size(); ++j) {
    const auto& one = fit.estimates[j];
    if (one.value > little * one.start) continue;
    auto less = found.minimum.x;
    less[j] += std::log(nothing);
    if (problem.sum_of_squares(less) <= found.squares)
      fit.warnings.push_back(fmt::format(
          "{} tends to zero: {:.4g} fits no better than a thousandth of it; set it to 0 and leave it out",
          one.key, one.value));
  }
}

void judge(const Measurements& measurements, Index keys, Fit& fit) {
  double squares = 0;
  for (std::size_t row = 0; row < measurements.rows.size(); ++row) {
    const auto& one = measurements.rows[row];
    const double residual = one.measured - fit.predicted[row].value;
    squares += residual * residual;
    fit.chi_square += residual * residual / (one.deviation * one.deviation);
  }
  fit.rms = std::sqrt(squares / static_cast<double>(fit.degrees_of_freedom + keys));
}

}  // namespace

std::vector<double> Fit::values() const {
  Values all;
  for (const auto& one : estimates) all.push_back(one.value);
  return all;
}

Fit fit(FitModel& model, const std::vector<std::string>& free, double confidence) {
  expect_enough(model.measurements(), model.measurements().rows.size(), free.size());
  const FitProblem problem(model);
  const auto starts = problem.starts();
  expect_separation(problem, starts.front());
  const auto found = best_of_searches(problem, starts);
  const auto& [minimum, columns, squares, degrees, relative_error] = found;
  const auto values = problem.values(minimum.x);
  expect_enough(model.measurements(), degrees + free.size(), free.size());
  expect_determined(columns, model, free, values);
  if (!minimum.converged) throw FitError(minimum.message, fault::no_minimum);
  Fit fit{.predicted = problem.predicted(minimum.x), .degrees_of_freedom = degrees, .confidence = confidence};
  judge(model.measurements(), std::ssize(free), fit);
  fit.correlation = uncertainty(columns, std::ssize(free)).correlation;
  estimate(model, free, values, relative_error, fit);
  warn_of_loose(fit);
  warn_of_vanishing(problem, found, fit);
  fit.runs = model.runs();
  fit.runs_with_slopes = model.runs_with_slopes();
  return fit;
}

}  // namespace mariotte::study
