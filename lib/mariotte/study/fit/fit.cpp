#include "mariotte/study/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

void expect_enough(const Measurements& measurements, std::size_t values) {
  const auto rows = measurements.rows.size();
  if (rows <= values)
    throw scene::SceneError(
        fmt::format("{}: {} cannot give {} and {}; at least {} are needed", measurements.file,
                    counted(rows, "measurement"), counted(values, "value"),
                    values == 1 ? "its error" : "their errors", values + 1),
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

void estimate(const FitModel& model, const std::vector<std::string>& free, const Values& values,
              const Uncertainty& known, Fit& fit) {
  const double scatter = std::sqrt(fit.chi_square / static_cast<double>(fit.degrees_of_freedom));
  const double reach = student_t(fit.confidence, fit.degrees_of_freedom);
  for (std::size_t j = 0; j < free.size(); ++j) {
    const double relative = scatter * known.standard_error[j];
    fit.estimates.push_back({.key = free[j],
                             .start = model.start()[j],
                             .value = values[j],
                             .standard_error = values[j] * relative,
                             .lower = values[j] * std::exp(-reach * relative),
                             .upper = values[j] * std::exp(reach * relative)});
  }
}

void judge(const Measurements& measurements, Fit& fit) {
  double squares = 0;
  for (std::size_t row = 0; row < measurements.rows.size(); ++row) {
    const auto& one = measurements.rows[row];
    const double residual = one.measured - fit.predicted[row].value;
    squares += residual * residual;
    fit.chi_square += residual * residual / (one.deviation * one.deviation);
  }
  fit.rms = std::sqrt(squares / static_cast<double>(measurements.rows.size()));
}

}  // namespace

std::vector<double> Fit::values() const {
  Values all;
  for (const auto& one : estimates) all.push_back(one.value);
  return all;
}

Fit fit(FitModel& model, const std::vector<std::string>& free, double confidence) {
  expect_enough(model.measurements(), free.size());
  const FitProblem problem(model);
  const auto start = problem.best_start();
  expect_separation(problem, start);
  const auto found = minimise({.count = static_cast<Index>(problem.count()),
                               .residuals = [&](auto x, auto r) { problem.residuals(x, r); },
                               .slopes = [&](auto x, auto columns) { problem.search_slopes(x, columns); }},
                              start);
  const auto values = problem.values(found.x);
  Values columns(problem.count() * free.size());
  problem.slopes(found.x, columns);
  expect_determined(columns, model, free, values);
  if (!found.converged) throw FitError(found.message, fault::no_minimum);
  Fit fit{.predicted = problem.predicted(found.x),
          .degrees_of_freedom = static_cast<Index>(problem.count() - free.size()),
          .confidence = confidence};
  judge(model.measurements(), fit);
  const auto known = uncertainty(columns, std::ssize(free));
  fit.correlation = known.correlation;
  estimate(model, free, values, known, fit);
  fit.runs = model.runs();
  fit.runs_with_slopes = model.runs_with_slopes();
  return fit;
}

}  // namespace mariotte::study
