// The impacts of a table: triplets or rows of equal balls.
#pragma once
#include <string>

#include "mariotte/impact/laws/icr_table.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::icr_table {

/// f = k δⁿ, damped by c δ^{n−1} δ̇.
struct ContactLaw {
  std::string name = "hertz";  ///< linear, hertz or viscoelastic
  double exponent = 1.5;       ///< of viscoelastic contacts
};

/// Balls 1, 2, 3 touch; ball 1 strikes with v₁ = 1, ball 2 rests. m₁ = k₁ = 1 without loss of generality.
struct Triplet {
  double kappa = 1;    ///< k₂/k₁
  double mass_2 = 1;   ///< m₂/m₁
  double mass_3 = 1;   ///< m₃/m₁
  double v_3 = 0;      ///< v₃/v₁
  double damping = 0;  ///< Π of contact 1, c₁ = Π here; contact 2 has the same c/k
};
model::Chain chain(const Triplet& triplet, const ContactLaw& law);

/// n equal balls that touch, the first striking at unit speed; damping Π of every contact.
model::Chain row(Index balls, double damping, const ContactLaw& law);

/// Simulate and reduce to what the table keeps.
impact::TablePoint simulate(const model::Chain& chain, double accuracy);

}  // namespace mariotte::icr_table
