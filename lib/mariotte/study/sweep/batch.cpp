#include "mariotte/study/sweep/batch.hpp"

#include <algorithm>
#include <limits>

namespace mariotte::study {
namespace {

/// An exception is an answer, too: this point has no result, the others do.
void put(Variation& variation, PointEvaluation& evaluation, const PointRow& row) try {
  evaluation.put(variation, row);
} catch (const scene::SceneError& error) {
  *row.verdict = {.ending = "rejected", .reason = error.what()};
} catch (const InvalidParameter& error) {
  *row.verdict = {.ending = "rejected", .reason = error.what()};
} catch (const Error& error) {
  *row.verdict = {.ending = "failed", .reason = error.what()};
}

}  // namespace

Index Batch::failed() const {
  return std::count_if(verdicts.begin(), verdicts.end(),
                       [](const Verdict& verdict) { return !verdict.has_numbers(); });
}

void evaluate(Variation& variation, PointEvaluation& evaluation, std::size_t columns, Index first,
              Index count, Batch& batch) {
  const auto size = static_cast<std::size_t>(count);
  batch.first = first;
  batch.numbers.resize(size * columns);
  batch.verdicts.assign(size, {});
  const auto row = [&](std::size_t k) { return std::span(batch.numbers).subspan(k * columns, columns); };
  for (std::size_t k = 0; k < size; ++k)
    put(variation, evaluation, {first + static_cast<Index>(k), row(k), &batch.verdicts[k]});
  evaluation.finish();
  for (std::size_t k = 0; k < size; ++k)
    if (!batch.verdicts[k].has_numbers())
      std::fill(row(k).begin(), row(k).end(), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace mariotte::study
