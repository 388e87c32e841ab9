#include "mariotte/impact/laws/poisson_law.hpp"

#include "mariotte/impact/laws/complementarity.hpp"

namespace mariotte::impact {

LawOutcome poisson(const Configuration& c, const std::vector<double>& restitution) {
  validate(c, restitution);
  const auto w = compliance(c);
  auto p = solve_complementarity(w, gap_rates(c, c.velocity));
  for (std::size_t j = 0; j < p.size(); ++j) p[j] *= 1 + restitution[j];
  const auto given_back = outcome_of(c, p);
  const auto more = solve_complementarity(w, gap_rates(c, given_back.velocity));
  for (std::size_t j = 0; j < p.size(); ++j) p[j] += more[j];
  return outcome_of(c, std::move(p));
}

}  // namespace mariotte::impact
