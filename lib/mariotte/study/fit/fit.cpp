#include "mariotte/study/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/core/counted.hpp"
#include "mariotte/study/fault.hpp"
#include "mariotte/study/fit/fit_intervals.hpp"
#include "mariotte/study/fit/fit_search.hpp"
#include "mariotte/study/fit/uncertainty.hpp"

namespace mariotte::study {
namespace {

using Values = std::vector<double>;

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

void expect_determined(const Found& found, const std::vector<std::string>& free, const Values& values) {
  if (found.directions.empty()) return;
  std::string names;
  int count = 0;
  for (std::size_t k = 0; k < found.held.size(); ++k) {
    const auto takes_part = [&](const Values& direction) { return std::abs(direction[k]) > 1e-3; };
    if (std::none_of(found.directions.begin(), found.directions.end(), takes_part)) continue;
    const auto j = found.held[k];
    names += fmt::format("{}{} (here {:.4g})", count++ > 0 ? ", " : "", free[j], values[j]);
  }
  const auto* why = count > 1
                        ? ": these can change together and nothing that was measured does; leave one out"
                        : ": nothing that was measured depends on it";
  throw FitError("the measurements do not determine " + names + why, fault::undetermined);
}

void estimate(const FitProblem& problem, const Found& found, const FitModel& model,
              const std::vector<std::string>& free, Fit& fit) {
  const auto all = intervals(problem, found, student_t(fit.confidence, fit.degrees_of_freedom));
  const auto values = problem.values(found.minimum.x);
  for (std::size_t j = 0; j < free.size(); ++j) {
    const double start = model.start()[j];
    fit.estimates.push_back({.key = free[j],
                             .start = start,
                             .value = values[j],
                             .standard_error = values[j] * found.relative_error[j],
                             .lower = start * std::exp(all[j].lower - 1),
                             .upper = start * std::exp(all[j].upper - 1)});
  }
}

/// Of the keys that have not vanished; the others are correlated with nothing.
void correlate(const Found& found, Fit& fit) {
  const auto keys = found.minimum.x.size();
  const auto some = uncertainty(found.held_columns(), std::ssize(found.held)).correlation;
  fit.correlation.assign(keys, Values(keys, 0));
  for (std::size_t j = 0; j < keys; ++j) fit.correlation[j][j] = 1;
  for (std::size_t i = 0; i < some.size(); ++i)
    for (std::size_t k = 0; k < some.size(); ++k) fit.correlation[found.held[i]][found.held[k]] = some[i][k];
}

void warn(Fit& fit) {
  std::string names;
  for (const auto& one : fit.estimates) {
    if (!(one.upper < infinity))
      names += fmt::format("{}{} ({:.4g} ± {:.2g})", names.empty() ? "" : ", ", one.key, one.value,
                           one.standard_error);
    else if (one.lower == 0)
      fit.warnings.push_back(
          fmt::format("{} is not told from zero: all values up to {:.4g} fit as well", one.key, one.upper));
  }
  if (!names.empty())
    fit.warnings.push_back("the measurements do not determine " + names +
                           ": start from other values, or leave a key out");
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
  if (free.empty()) throw InvalidParameter("no key of the scene is free: there is nothing to find");
  if (!(confidence > 0 && confidence < 1))
    throw InvalidParameter(fmt::format("confidence must be between 0 and 1, is {:g}", confidence));
  expect_enough(model.measurements(), model.measurements().rows.size(), free.size());
  const FitProblem problem(model);
  const auto starts = problem.starts();
  expect_separation(problem, starts.front());
  const auto found = best_of_searches(problem, starts);
  const auto degrees = found.degrees_of_freedom;
  expect_enough(model.measurements(), degrees + free.size(), free.size());
  expect_determined(found, free, problem.values(found.minimum.x));
  if (!found.minimum.converged) throw FitError(found.minimum.message, fault::no_minimum);
  Fit fit{.predicted = problem.predicted(found.minimum.x),
          .degrees_of_freedom = degrees,
          .confidence = confidence};
  judge(model.measurements(), std::ssize(free), fit);
  correlate(found, fit);
  estimate(problem, found, model, free, fit);
  warn(fit);
  fit.runs = model.runs();
  fit.runs_with_slopes = model.runs_with_slopes();
  return fit;
}

}  // namespace mariotte::study
