// Values of scene keys that make simulated numbers fit measurements best, and how well these know them.
//
// Minimises Σ ((measured − predicted) / deviation)² over the logarithms of the values, so that they stay
// positive. Deviations count by their ratios: the scatter about the fit says how large they are, also where
// none are given. A body or a pair that is predicted to be captured counts with 0, and with no slope.
#pragma once
#include "mariotte/core/error.hpp"
#include "mariotte/study/fit/fit_model.hpp"

namespace mariotte::study {

/// The search found no minimum, or one that is not the only one; what() names the keys.
struct FitError : Error {
  FitError(const std::string& what, Fault kind) : Error(what, kind) {}
};

/// One value that was found.
struct Estimate {
  std::string key;
  double start = 0, value = 0;  ///< [SI]
  double standard_error = 0;    ///< infinite of a value that the search has followed down to zero
  double lower = 0, upper = 0;  ///< ends of the confidence interval; 0 where zero is not told from the value
};

struct Fit {
  std::vector<Estimate> estimates = {};
  std::vector<std::vector<double>> correlation = {};  ///< of the logarithms of the values
  std::vector<Prediction> predicted = {};             ///< one per measurement
  double rms = 0;                                     ///< root mean square of measured − predicted
  double chi_square = 0;                              ///< Σ ((measured − predicted) / deviation)²
  Index degrees_of_freedom = 0;
  double confidence = 0;
  Index runs = 0;                          ///< impacts simulated
  Index runs_with_slopes = 0;              ///< of them, those that carried exact slopes along
  std::vector<std::string> warnings = {};  ///< of values that may be zero or that nothing bounds

  std::vector<double> values() const;
};

/// Looks around the start by factors of four for the best place to search from, and searches from the next
/// ones, too, where that leads to values that are hardly determined. Throws FitError, and
/// scene::SceneError if there are too few measurements, and Error if a measurement cannot be simulated.
Fit fit(FitModel& model, const std::vector<std::string>& free, double confidence = 0.95);

}  // namespace mariotte::study
