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

/// Of a row of power laws without gravity, which has ended at `end`; one weight per ball.
RowSlopes sweep_back(const model::DimensionlessChain& chain, const MotionRecord& motion, Instant end,
                     std::span<const double> weights);

}  // namespace mariotte::impact
