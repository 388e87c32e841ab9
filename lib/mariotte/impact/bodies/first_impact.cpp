#include "mariotte/impact/bodies/first_impact.hpp"

#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/bodies/compliant_impact.hpp"
#include "mariotte/impact/bodies/contact_instant.hpp"
#include "mariotte/impact/bodies/plane_motions.hpp"
#include "mariotte/impact/fault.hpp"
#include "mariotte/impact/laws/friction_laws.hpp"
#include "mariotte/impact/laws/law_outcome.hpp"

namespace mariotte::impact {
namespace {

/// What is no more than rounding of the velocities before is none.
InContact rounded(InContact after, const InContact& before) {
  const double least = rounding * std::hypot(before.normal, before.tangential);
  for (double* component : {&after.normal, &after.tangential})
    if (std::abs(*component) < least) *component = 0;
  return after;
}

FrictionOutcome outcome(const char* law, double restitution, const InContact& impulse,
                        const ContactInstant& at, const FirstImpact& impact, const model::Bodies& before) {
  auto after = struck(at, impulse, motions(before));
  return {.law = law,
          .restitution = restitution,
          .impulse = impulse,
          .velocity = rounded(velocity_after(impact.contact, impulse), impact.contact.velocity),
          .energy = kinetic_energy(before, after),
          .loss = -energy_change(impact.contact, impulse),
          .body = std::move(after)};
}

}  // namespace

FirstImpact first_impact(const model::Bodies& bodies, const hybrid::Options& options,
                         std::optional<double> restitution) {
  if (bodies.dimension != 2)
    throw InvalidParameter("impact laws with friction are those of the plane", fault::no_single_contact);
  const auto run = simulate(bodies, options);
  const auto closure = first_closure(run);
  const auto before = closure.start > 0 ? bodies_after(bodies, options, closure.start) : bodies;
  const ContactInstant at(before, closure.contact);
  FirstImpact impact{.between = history_of(run, closure.contact).between,
                     .start = closure.start,
                     .end = closure.end,
                     .contact = rigid_contact(at),
                     .energy = kinetic_energy(before, motions(before)),
                     .outcomes = {}};
  const auto made = compliant_impact(bodies, options, closure, impact.contact.velocity.normal);
  impact.outcomes = {made.outcome};
  const auto add = [&](const char* name, auto&& law, double measured) {
    const double e = restitution.value_or(measured);
    impact.outcomes.push_back(outcome(name, e, law(impact.contact, e), at, impact, before));
  };
  add("newton", &newton, made.kinematic);
  add("poisson", &poisson, made.kinetic);
  add("moreau", &moreau, made.kinematic);
  add("stronge", &stronge, made.energetic);
  return impact;
}

}  // namespace mariotte::impact
