#include "mariotte/study/sweep/batch.hpp"

#include <algorithm>
#include <limits>

namespace mariotte::study {
namespace {

/// An exception is an answer, too: this point has no result, the others do.
Verdict verdict_at(Variation& variation, const EvaluatePoint& evaluate, Index point,
                   std::span<double> row) try {
  return evaluate(variation.at(point), point, row);
} catch (const scene::SceneError& error) {
  return {.ending = "rejected", .reason = error.what()};
} catch (const InvalidParameter& error) {
  return {.ending = "rejected", .reason = error.what()};
} catch (const Error& error) {
  return {.ending = "failed", .reason = error.what()};
}

}  // namespace

Index Batch::failed() const {
  return std::count_if(verdicts.begin(), verdicts.end(),
                       [](const Verdict& verdict) { return !verdict.has_numbers(); });
}

void evaluate(Variation& variation, const EvaluatePoint& evaluate, std::size_t columns, Index first,
              Index count, Batch& batch) {
  batch.first = first;
  batch.numbers.resize(static_cast<std::size_t>(count) * columns);
  batch.verdicts.clear();
  for (Index k = 0; k < count; ++k) {
    const auto row = std::span(batch.numbers).subspan(static_cast<std::size_t>(k) * columns, columns);
    batch.verdicts.push_back(verdict_at(variation, evaluate, first + k, row));
    if (!batch.verdicts.back().has_numbers())
      std::fill(row.begin(), row.end(), std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace mariotte::study
