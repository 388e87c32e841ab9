#include "mariotte/impact/bodies/compliant_impact.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/bracket.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/bodies/contact_instant.hpp"
#include "mariotte/impact/bodies/plane_motions.hpp"
#include "mariotte/impact/fault.hpp"

namespace mariotte::impact {
namespace {

bool acts_during(const BodyContactHistory& history, const Closure& closure) {
  return history.contact != closure.contact &&
         std::any_of(history.periods.begin(), history.periods.end(), [&](const Period& period) {
           return period.start <= closure.end && period.end.value_or(infinity) >= closure.start;
         });
}

}  // namespace

Closure first_closure(const BodiesImpact& run) {
  const auto refuse = [](const std::string& why) { throw InvalidParameter(why, fault::no_single_contact); };
  const auto start = [](const BodyContactHistory& history) {
    return history.periods.empty() ? infinity : history.periods.front().start;
  };
  const auto first = std::min_element(run.contacts.begin(), run.contacts.end(),
                                      [&](const auto& a, const auto& b) { return start(a) < start(b); });
  if (first == run.contacts.end() || first->periods.empty()) refuse("no contact closes: there is no impact");
  const auto& period = first->periods.front();
  if (!period.end) refuse("the first contact is still closed when the run ends");
  const Closure closure{first->contact, period.start, *period.end};
  for (const auto& other : run.contacts)
    if (acts_during(other, closure))
      refuse("laws of one contact do not apply: " + first->between[0] + "–" + first->between[1] + " and " +
             other.between[0] + "–" + other.between[1] + " are closed together");
  return closure;
}

const BodyContactHistory& history_of(const BodiesImpact& run, Index contact) {
  return *std::find_if(run.contacts.begin(), run.contacts.end(),
                       [&](const auto& history) { return history.contact == contact; });
}

namespace {

/// The run until an instant.
BodiesImpact run_until(const model::Bodies& bodies, hybrid::Options options, double time) {
  options.max_time = time;
  options.flies_on = true;
  auto run = simulate(bodies, options);
  if (run.ending == hybrid::Ending::failed || run.ending == hybrid::Ending::unsure) throw Error(run.message);
  return run;
}

/// The bodies where a run has left them.
model::Bodies moved(model::Bodies bodies, const BodiesImpact& run) {
  for (std::size_t i = 0; i < bodies.body.size(); ++i) {
    auto& body = bodies.body[i];
    const auto& end = run.body[i];
    body.position = end.position;
    body.angle = end.angle;
    body.velocity = end.velocity;
    body.spin = end.spin;
  }
  for (auto& plane : bodies.plane) plane.point = plane.point + run.time * plane.velocity;
  return bodies;
}

double normal_loss(const BodyContactHistory& history) {
  return history.losses.damper + history.losses.plastic + history.losses.adhesion;
}

/// All of one run until the greatest indentation, and of one until the end.
struct Halves {
  BodiesImpact compressed, whole;
};

Halves halves(const model::Bodies& bodies, const hybrid::Options& options, const Closure& closure,
              double approach) {
  const auto gap_rate = [&](double time) {
    return ContactInstant(bodies_after(bodies, options, time), closure.contact).motion.gap_rate;
  };
  const double precise = 1e-12 * (closure.end - closure.start);
  const double turning =
      locate_sign_change(gap_rate, closure.start, approach, closure.end, gap_rate(closure.end), precise);
  return {run_until(bodies, options, turning), run_until(bodies, options, closure.end)};
}

}  // namespace

model::Bodies bodies_after(const model::Bodies& bodies, const hybrid::Options& options, double time) {
  return moved(bodies, run_until(bodies, options, time));
}

Compliant compliant_impact(const model::Bodies& bodies, const hybrid::Options& options,
                           const Closure& closure, double approach) {
  const auto run = halves(bodies, options, closure, approach);
  const auto &half = history_of(run.compressed, closure.contact),
             &whole = history_of(run.whole, closure.contact);
  const auto after = moved(bodies, run.whole);
  const double taken = half.stored - half.stored_in_friction + normal_loss(half);
  Compliant made;
  made.outcome = {.law = "simulation",
                  .impulse = {whole.normal_impulse, whole.tangential_impulse.e1},
                  .velocity = velocity(ContactInstant(after, closure.contact)),
                  .energy = kinetic_energy(after, motions(after)),
                  .loss = whole.losses.total(),
                  .body = motions(after)};
  made.kinematic = -made.outcome.velocity.normal / approach;
  made.kinetic = whole.normal_impulse / half.normal_impulse - 1;
  made.energetic = std::sqrt(std::max(0.0, 1 - normal_loss(whole) / taken));
  return made;
}

}  // namespace mariotte::impact
