// A recording made ready for recurrences: which sums and convolutions an order takes, and in which sequence.
#pragma once
#include "mariotte/series/recording.hpp"

namespace mariotte::series {

/// A factor, number or fixed value, of the value of a step.
struct Term {
  int step;
  double number;
  int fixed;  ///< −1: the factor is the number
};

/// One operation on series.
struct Step {
  Op op;
  int a = -1, b = -1;            ///< steps that it works on; which map; the other of sine and cosine
  int first = 0, count = 0;      ///< terms of a sum
  int fixed = -1;                ///< constant part of a sum, exponent of a power, numerator of a quotient
  int depth = 0;                 ///< how long an order waits for it
  bool seen = false;             ///< some value that is not a rate needs it
  bool keeps = false;            ///< its coefficients enter a convolution
  bool keeps_slopes = false;     ///< j times its coefficient j enters a convolution
  int row = -1, slopes = -1;     ///< where these are kept
  int sum = -1, other_sum = -1;  ///< its convolutions
};

/// The series of a step, or of its slopes, j times its coefficient j.
struct Factor {
  int step = 0;
  bool slopes = false;
  constexpr bool operator==(const Factor&) const = default;
};
/// Σ a_j b_{k−j}.
struct Convolution {
  Factor a, b;
};

/// Everything that the compiler has to know about a field to unroll its recurrences.
struct Program {
  static constexpr int limit = 160;
  Step step[limit] = {};
  Term term[2 * limit] = {};
  Node fixed[limit] = {};  ///< constants; a and b are places here
  Convolution convolution[limit] = {};
  Term rate[limit] = {};   ///< of each state; step −1: only the factor
  Term value[limit] = {};  ///< of each row beyond; step −1: only the factor, else the step that keeps it
  int steps = 0, terms = 0, fixed_values = 0, rows = 0;
  int convolutions = 0, seen_convolutions = 0;  ///< those that values need come first

  constexpr int row(Factor f) const { return f.slopes ? step[f.step].slopes : step[f.step].row; }
};

}  // namespace mariotte::series
