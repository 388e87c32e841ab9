// The least sum of squares of functions that are known by their values and slopes.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::study {

/// Minimise |r(x)|². Where x makes no sense `residuals` throws Error or is not finite, and the search turns
/// back.
struct LeastSquares {
  Index count = 0;  ///< of residuals
  std::function<void(std::span<const double> x, std::span<double> r)> residuals;
  std::function<void(std::span<const double> x, std::span<double> columns)> slopes;  ///< ∂r/∂x_j one by one
};

struct Minimum {
  std::vector<double> x;
  bool converged = false;
  std::string message;  ///< why not, else empty
};

/// Levenberg and Marquardt's method as in MINPACK [Moré 1978], from `start`; x is of order one, and steps are
/// first no longer than |start|. It ends where sums and steps change by less than the share `tolerance`;
/// values beyond some ten digits are noise of the simulations, and far below that of any measurement. Throws
/// Error if the functions do at the start.
Minimum minimise(const LeastSquares& problem, std::vector<double> start, double tolerance = 1e-10);

}  // namespace mariotte::study
