// How the law of a contact, its push and its approach move with parameters.
#pragma once
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/impact/sensitivity/stencil.hpp"

namespace mariotte::impact {

/// Slopes of the force of one contact by one parameter: of a power law by its numbers, of others by the laws
/// at the points of the stencil.
struct LawSlope {
  Index column;
  double step = 0;
  std::span<const StencilPoint> points;
  contact::PowerLaw power{0, 0, 0};  ///< slopes of k, c and n
  std::vector<contact::Law> shifted;
};

/// Of one contact: what its law, its push and its approach do.
struct ContactSlope {
  struct Term {
    Index place, column;
    double slope;
  };
  std::vector<LawSlope> law;
  std::vector<Term> push;       ///< of M⁻¹ Gᵀ
  std::vector<Term> direction;  ///< of G
};

}  // namespace mariotte::impact
