#include "mariotte/impact/laws/moreau_law.hpp"

#include "mariotte/impact/laws/complementarity.hpp"

namespace mariotte::impact {

LawOutcome moreau(const Configuration& c, double restitution) {
  validate(c, std::vector(c.contact.size(), restitution));
  auto p = solve_complementarity(compliance(c), gap_rates(c, c.velocity));
  for (double& impulse : p) impulse *= 1 + restitution;
  return outcome_of(c, std::move(p));
}

}  // namespace mariotte::impact
