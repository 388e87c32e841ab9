// The search for the minimum of a fit, and what tells how well it is known.
#pragma once
#include <vector>

#include "mariotte/study/fit/fit_problem.hpp"
#include "mariotte/study/fit/least_squares.hpp"

namespace mariotte::study {

/// A minimum with what tells how well it is known.
struct Found {
  Minimum minimum;
  std::vector<double> columns;                       ///< slopes of the residuals there
  std::vector<std::size_t> held = {};                ///< keys that have not vanished
  std::vector<std::vector<double>> directions = {};  ///< of these, in which no residual changes
  double squares = 0;                                ///< Σ residual²
  Index degrees_of_freedom = 0;
  /// Standard error / value; infinite of what has vanished. Empty if `directions` are not.
  std::vector<double> relative_error = {};

  /// The search has come to values of which each is known.
  bool is_firm() const;
  /// Columns of the keys that have not vanished, one after the other.
  std::vector<double> held_columns() const;
};

/// From the best starts, since a minimum may not be the least one, and from more until one leads to values
/// that are known. Throws Error if the best start cannot be simulated.
Found best_of_searches(const FitProblem& problem, const std::vector<std::vector<double>>& starts);

}  // namespace mariotte::study
