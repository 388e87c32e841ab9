// What a fit knows about the values that it found, to first order about the minimum.
#pragma once
#include <span>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::study {

/// Of p values, from the slopes of the residuals at the minimum, one column of n after the other.
struct Uncertainty {
  std::vector<double> standard_error;            ///< if residuals scatter with the deviation 1
  std::vector<std::vector<double>> correlation;  ///< p rows
};

/// Directions in which the residuals do not change, one per singular value below `least`, or `tolerance`
/// times the largest: the p components, the largest of magnitude 1.
std::vector<std::vector<double>> undetermined(std::span<const double> columns, Index count, double tolerance,
                                              double least = 0);

/// Throws nothing; the columns must determine all values.
Uncertainty uncertainty(std::span<const double> columns, Index count);

/// How many standard errors the two-sided interval of this confidence reaches to either side: Student's t.
double student_t(double confidence, Index degrees_of_freedom);

}  // namespace mariotte::study
