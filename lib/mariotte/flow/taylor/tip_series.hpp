// Taylor series of a body with one tip in contact, derived from the field of its motion and of its grip.
#pragma once
#include "mariotte/flow/taylor/tip_expansions.hpp"

namespace mariotte::flow {

/// Start and series of a motion.
template <class Motion>
class TipSeries : public TipStart<Motion> {
 public:
  /// Coefficients 0 … order of every row, by the field of this phase; from `known` on, if those up to there
  /// are here.
  void expand(const TipPhase& phase, int order, int known) {
    rows_ = expansions_->expand(phase, *this, order, known);
  }
  const PowerSeries& operator[](int row) const { return rows_[row]; }

 private:
  std::unique_ptr<TipExpansions> expansions_ = make_tip_expansions();
  const PowerSeries* rows_ = nullptr;
};

using NormalSeries = TipSeries<NormalMotion>;
using PlanarSeries = TipSeries<PlanarMotion>;
using SpatialSeries = TipSeries<SpatialMotion>;

}  // namespace mariotte::flow
