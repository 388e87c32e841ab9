#include "mariotte/impact/laws/newton_law.hpp"

#include "mariotte/impact/laws/complementarity.hpp"

namespace mariotte::impact {

LawOutcome newton(const Configuration& c, const std::vector<double>& restitution) {
  validate(c, restitution);
  auto q = gap_rates(c, c.velocity);
  for (std::size_t j = 0; j < q.size(); ++j) q[j] *= 1 + restitution[j];
  return outcome_of(c, solve_complementarity(compliance(c), q));
}

}  // namespace mariotte::impact
