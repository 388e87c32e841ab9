// Confidence intervals of a fit.
#pragma once
#include <vector>

#include "mariotte/study/fit/fit_search.hpp"

namespace mariotte::study {

/// Ends of an interval in x_j; infinite where the value may be zero, or where nothing bounds it.
struct Interval {
  double lower, upper;
};

/// Of all values, `reach` standard errors to either side where these are a small share of the value. Of
/// others by profiles: as far as the least sum of squares over all other values is no larger than the
/// confidence allows. Unlike standard errors that is right, too, where residuals are no linear function of
/// the value.
std::vector<Interval> intervals(const FitProblem& problem, const Found& found, double reach);

}  // namespace mariotte::study
