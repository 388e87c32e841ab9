// Taylor series of a body with one tip in contact, derived from the field of its motion and of its grip.
#pragma once
#include <memory>

#include "mariotte/flow/taylor/tip_fields.hpp"
#include "mariotte/flow/tip_phase.hpp"

namespace mariotte::flow {

inline constexpr int most_order = 22;
/// Coefficients of one quantity, by order.
using PowerSeries = std::array<double, most_order + 2>;

/// Series of a motion, whose enumerations name the rows, the states to start from, and the parameters.
template <class Motion>
class TipSeries : public Motion {
 public:
  TipSeries();
  ~TipSeries();
  /// Coefficients 0 … order of every row, by the field of this phase.
  void expand(const TipPhase& phase, int order);
  const PowerSeries& operator[](int row) const { return rows_[row]; }

  std::array<double, Motion::states> start = {};  ///< zero where nothing else is said
  std::array<double, Motion::parameters> parameter = {};

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
  const PowerSeries* rows_ = nullptr;
};

using NormalSeries = TipSeries<NormalMotion>;
using PlanarSeries = TipSeries<PlanarMotion>;
using SpatialSeries = TipSeries<SpatialMotion>;

}  // namespace mariotte::flow
