// Taylor series of every field of a tip. Code compiled for different instruction sets shares nothing but this
// layout.
#pragma once
#include <memory>

#include "mariotte/flow/instruction_set.hpp"
#include "mariotte/flow/taylor/tip_fields.hpp"
#include "mariotte/flow/tip_phase.hpp"

namespace mariotte::flow {

inline constexpr int most_order = 22;
/// Coefficients of one quantity, by order.
using PowerSeries = std::array<double, most_order + 2>;

/// Where a motion starts; its enumerations name the rows, the states to start from, and the parameters.
template <class Motion>
struct TipStart : Motion {
  std::array<double, Motion::states> start = {};  ///< zero where nothing else is said
  std::array<double, Motion::parameters> parameter = {};
};

/// Memory of one run. Each gives the coefficients 0 … order of every row, by the field of the phase; valid
/// until the next call. Those up to the order `known` may be taken from the call before, if it had the same
/// start.
class TipExpansions {
 public:
  virtual ~TipExpansions() = default;
  virtual const PowerSeries* expand(const TipPhase& phase, const TipStart<NormalMotion>& from, int order,
                                    int known = 0) = 0;
  virtual const PowerSeries* expand(const TipPhase& phase, const TipStart<PlanarMotion>& from, int order,
                                    int known = 0) = 0;
  virtual const PowerSeries* expand(const TipPhase& phase, const TipStart<SpatialMotion>& from, int order,
                                    int known = 0) = 0;
};

MARIOTTE_PER_INSTRUCTION_SET(std::unique_ptr<TipExpansions>, make_tip_expansions, (), ())

/// Of a slip from rest: how fast a turn of û along `across` changes u' along it.
double turn_response(const TipStart<SpatialMotion>& from, const std::array<double, 2>& across);

}  // namespace mariotte::flow
