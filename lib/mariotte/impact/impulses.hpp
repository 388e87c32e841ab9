// Impulses and their ratios.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/model/chain_layout.hpp"

namespace mariotte::impact {

/// A stretch of a run: two states and the time between them, dimensionless.
struct Stretch {
  ConstState before;
  ConstState after;
  double time;
};

/// p_j = ∫ f_j dt of all n−1 contacts, from momentum: p_j = p_{j−1} − m_j (Δv_j + γ t), started at a free end
/// of the chain where p = 0. Only between two walls does it rest on the integral of a wall's force.
std::vector<double> impulses(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                             const Stretch& stretch);

/// α_j = p_j/p_{j+1} [Acary 2003, eq. 5], n−2 values; empty where p_{j+1} = 0.
std::vector<std::optional<double>> correlation_ratios(const std::vector<double>& impulses);

/// r = p/|p|, defined even where ratios are not; zeros if every impulse is zero.
std::vector<double> direction(const std::vector<double>& impulses);

}  // namespace mariotte::impact
