#include "mariotte/impact/laws/frictional_contact.hpp"

#include <cmath>

#include "mariotte/core/error.hpp"

namespace mariotte::impact {

InContact velocity_after(const FrictionalContact& c, const InContact& p) {
  return {c.velocity.normal + c.nn * p.normal + c.nt * p.tangential,
          c.velocity.tangential + c.nt * p.normal + c.tt * p.tangential};
}

double energy_change(const FrictionalContact& c, const InContact& p) {
  const auto after = velocity_after(c, p);
  return 0.5 * (p.normal * (c.velocity.normal + after.normal) +
                p.tangential * (c.velocity.tangential + after.tangential));
}

void validate(const FrictionalContact& c, double restitution) {
  const auto expect = [](bool holds, const char* rule) {
    if (!holds) throw InvalidParameter(rule);
  };
  expect(c.nn > 0 && c.nn * c.tt - c.nt * c.nt > 0, "the response of a contact must be positive");
  expect(c.velocity.normal < 0, "the gap of a contact must close before its impact");
  expect(std::isfinite(c.velocity.tangential), "velocities must be finite");
  expect(c.friction >= 0 && std::isfinite(c.friction), "friction must be >= 0");
  expect(restitution >= 0 && std::isfinite(restitution), "the coefficient of restitution must be >= 0");
}

}  // namespace mariotte::impact
