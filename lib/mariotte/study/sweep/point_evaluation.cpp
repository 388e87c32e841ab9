#include "mariotte/study/sweep/point_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mariotte/hybrid/reached_limit.hpp"
#include "mariotte/impact/doubt.hpp"
#include "mariotte/study/sweep/slope_columns.hpp"

namespace mariotte::study {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Which limit ended a run; the end that its scene wants is none.
std::string limit_of(const hybrid::Options& run, const Verdict& verdict) {
  for (const auto ending : {hybrid::Ending::time_limit, hybrid::Ending::event_limit}) {
    const bool is_wanted = ending == hybrid::Ending::time_limit && run.flies_on;
    if (verdict.ending == hybrid::name(ending) && !is_wanted) return reached_limit(ending, run);
  }
  return "";
}

/// Says first which limit ended a run, and that its velocities may be less exact than was asked.
void tell(const hybrid::Options& run, Verdict& verdict) {
  if (!verdict.has_numbers()) return;
  std::string all;
  for (const auto& text :
       {limit_of(run, verdict), impact::doubt(verdict.estimated_accuracy, run.accuracy), verdict.reason})
    if (!text.empty()) all += (all.empty() ? "" : "; ") + text;
  verdict.reason = std::move(all);
}

}  // namespace

PointEvaluation::PointEvaluation(const SweepPlan& plan)
    : design_(plan.design),
      outputs_(plan.outputs),
      has_slopes_(std::any_of(plan.results.begin(), plan.results.end(),
                              [](const Column& one) { return is_slope(one.key); })),
      evaluations_(plan.results, [this](Index which, Verdict verdict, std::span<const double> results) {
        keep(rows_[static_cast<std::size_t>(which)], std::move(verdict), results);
      }) {}

void PointEvaluation::put(Variation& points, const PointRow& row) {
  const auto& scene = points.at(row.point);
  rows_.push_back({row, scene.run});
  evaluations_.put(std::ssize(rows_) - 1, scene, has_slopes_ ? &points.document(row.point) : nullptr);
}

void PointEvaluation::finish() {
  evaluations_.finish();
  rows_.clear();
}

void PointEvaluation::keep(const Pending& pending, Verdict verdict, std::span<const double> results) const {
  const auto& row = pending.row;
  const auto value_of = [&](const Output& output) {
    return output.formula ? number(design_, *output.formula, row.point, results) : results[output.result];
  };
  const auto finite = [](double value) { return std::isfinite(value) ? value : none; };
  for (std::size_t i = 0; i < outputs_.size(); ++i) row.numbers[i] = finite(value_of(outputs_[i]));
  tell(pending.run, verdict);
  *row.verdict = std::move(verdict);
}

}  // namespace mariotte::study
