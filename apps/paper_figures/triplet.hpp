// Three touching balls of unit mass.
#pragma once
#include <string_view>

#include "mariotte/model/chain/chain.hpp"

namespace mariotte::paper_figures {

struct Triplet {
  std::string_view law;   ///< "hertz" or "linear"
  double ratio;           ///< κ = k₂/k₁, k₁ = 1
  double third_velocity;  ///< v₃; v₁ = 1, v₂ = 0
};

model::Chain chain(const Triplet& triplet);

}  // namespace mariotte::paper_figures
