// The columns of points of a sweep: numbers of results, and formulas.
#pragma once
#include "mariotte/hybrid/options.hpp"
#include "mariotte/study/sweep/evaluate.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"
#include "mariotte/study/sweep/variation.hpp"

namespace mariotte::study {

/// What came out of a point.
struct PointRow {
  Index point = 0;
  std::span<double> numbers;  ///< one per column; nan where it is undefined or infinite
  Verdict* verdict = nullptr;
};

/// Evaluates points of a plan, several at once. Not to be shared between threads.
class PointEvaluation {
 public:
  explicit PointEvaluation(const SweepPlan& plan);
  PointEvaluation(const PointEvaluation&) = delete;
  PointEvaluation& operator=(const PointEvaluation&) = delete;

  /// Fills in a row now, later, or by `finish`; it must stay where it is until then.
  void put(Variation& points, const PointRow& row);
  void finish();

 private:
  /// A row that waits for its numbers, and the limits of its run.
  struct Pending {
    PointRow row;
    hybrid::Options run;
  };
  void keep(const Pending& pending, Verdict verdict, std::span<const double> results) const;

  Design design_;
  std::vector<Output> outputs_;
  bool has_slopes_;
  std::vector<Pending> rows_;  ///< that have been put in since the last `finish`
  Evaluations evaluations_;
};

}  // namespace mariotte::study
