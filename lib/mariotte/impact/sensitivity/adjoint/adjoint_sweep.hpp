// A motion read backwards: how the outcome of a row moves with its state at any earlier time.
//
// With λ = ∂J/∂x, μ_j = λ·(push of contact j) and the force f_j(δ_j, δ̇_j),
//
//   λ_g' = f_δ μ,   λ_v' = ±(λ_g − f_δ̇ μ) of the two balls of a contact,   dJ/dp = ∫ λ·f_p dt,
//
// and in free flight λ_g stands still. At an event λ⁻ = λ⁺ − (γ_x/γ̇) (f⁻ − f⁺)·λ⁺, the transpose of what
// slopes do there [Serban & Recuero 2019]: nothing where forces are continuous, and −c μ for λ_g where a
// linear damped contact closes. All parameters of a row cost one such sweep.
#pragma once
#include "mariotte/impact/sensitivity/adjoint/piece_sweep.hpp"

namespace mariotte::impact {

/// Of a row of power laws without gravity.
class BackSweep {
 public:
  /// From the end of a run on; one weight per ball. `chain` must outlive this.
  BackSweep(const model::DimensionlessChain& chain, Instant end, std::span<const double> weights);
  /// Through the last stretches that have not been passed.
  void pass(const MotionRecord& motion);
  /// Those at the start.
  RowSlopes take();

 private:
  void fly(Index first, Index last, Instant time);

  const model::DimensionlessChain& chain_;
  RowSlopes slopes_;
  std::vector<Instant> since_;  ///< by contact: the time at which those stand that do not push
};

}  // namespace mariotte::impact
