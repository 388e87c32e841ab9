// Neighbouring points of a sweep and what came out of them.
#pragma once
#include <vector>

#include "mariotte/study/sweep/point_evaluation.hpp"
#include "mariotte/study/sweep/variation.hpp"

namespace mariotte::study {

/// Points of a design from `first`; rows have one number per column, nan where there is none.
struct Batch {
  Index first = 0;
  std::vector<double> numbers;
  std::vector<Verdict> verdicts;  ///< one per point

  Index count() const { return static_cast<Index>(verdicts.size()); }
  Index failed() const;  ///< points without numbers
};

/// Evaluates `count` points from `first` on into `batch`, whose memory is reused.
void evaluate(Variation& variation, PointEvaluation& evaluation, std::size_t columns, Index first,
              Index count, Batch& batch);

}  // namespace mariotte::study
