#include "mariotte/study/sweep/point_evaluation.hpp"

#include <utility>

namespace mariotte::study {

PointEvaluation::PointEvaluation(const SweepPlan& plan)
    : design_(plan.design),
      outputs_(plan.outputs),
      evaluations_(plan.results, [this](Index which, Verdict verdict, std::span<const double> results) {
        keep(rows_[static_cast<std::size_t>(which)], std::move(verdict), results);
      }) {}

void PointEvaluation::put(const scene::Scene& scene, const PointRow& row) {
  rows_.push_back(row);
  evaluations_.put(std::ssize(rows_) - 1, scene);
}

void PointEvaluation::finish() {
  evaluations_.finish();
  rows_.clear();
}

void PointEvaluation::keep(const PointRow& row, Verdict verdict, std::span<const double> results) const {
  for (std::size_t i = 0; i < outputs_.size(); ++i)
    row.numbers[i] = outputs_[i].formula ? number(design_, *outputs_[i].formula, row.point, results)
                                         : results[outputs_[i].result];
  *row.verdict = std::move(verdict);
}

}  // namespace mariotte::study
