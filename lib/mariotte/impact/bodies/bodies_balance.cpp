#include "mariotte/impact/bodies/bodies_balance.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {

using model::vector3;

namespace {

template <int D>
double kinetic(const model::BodiesSetting<D>& setting, ConstState x) {
  const model::BodiesLayout<D> at{.bodies = std::ssize(setting.body), .slots = 0};
  double sum = 0;
  for (Index i = 0; i < at.bodies; ++i) {
    const auto motion = model::motion_of(setting.body[i], at, x, i);
    sum += 0.5 * setting.body[i].mass * dot(motion.velocity, motion.velocity);
    const auto turn = model::vec_at<model::turns(D)>(x, at.momentum(i));
    sum += 0.5 * (D == 2 ? setting.body[i].inertia[0] : 1) * dot(motion.spin, turn);
  }
  return sum;
}

/// Angular momentum about the origin.
template <int D>
Vector3 angular_momentum(const model::Bodies& bodies, const model::BodiesSetting<D>& setting, ConstState x) {
  const model::BodiesLayout<D> at{.bodies = std::ssize(setting.body), .slots = 0};
  Vector3 sum;
  for (Index i = 0; i < at.bodies; ++i) {
    const auto motion = model::motion_of(setting.body[i], at, x, i);
    const Vector3 place = bodies.body[i].position + vector3(motion.shift);
    const auto turn = vector3(model::vec_at<model::turns(D)>(x, at.momentum(i)));
    sum = sum + cross(place, setting.body[i].mass * vector3(motion.velocity)) +
          (D == 2 ? setting.body[i].inertia[0] : 1) * turn;
  }
  return sum;
}

/// Impulse of a plane on a body, in axes of space.
Vector3 impulse(const model::Bodies& bodies, const BodyContactHistory& contact) {
  const auto& normal = bodies.plane[bodies.contact[contact.contact].a.owner].normal;
  const Vector3 along = bodies.dimension == 2
                            ? contact.tangential_impulse.e1 * cross(Vector3{0, 0, 1}, normal)
                            : contact.tangential_impulse;
  return contact.normal_impulse * normal + along;
}

/// What the law of a contact remembers as lost.
void add_remembered(const contact::Law& law, const contact::Memory& past, double depth,
                    ContactLosses& losses) {
  const auto* branches = contact::branched(law);
  if (!branches) return;
  losses.plastic += contact::plastic_loss(*branches, past, depth);
  losses.adhesion += past.adhesion_loss;
}

double stored(const contact::Law& law, const contact::Memory& past, double indentation) {
  const auto* branches = contact::branched(law);
  return branches ? branches->stored_energy(past, indentation)
                  : contact::stored_energy(law, std::max(0.0, indentation));
}

}  // namespace

template <int D>
std::vector<BodyContactHistory> exchanged(const model::BodiesSystem<D>& system, const model::BodiesMode& mode,
                                          ConstState x) {
  const auto at = system.layout(x);
  std::vector<BodyContactHistory> list(mode.totals.size());
  std::vector<std::array<double, 3>> along(list.size(), std::array<double, 3>{});
  for (std::size_t c = 0; c < list.size(); ++c) {
    const auto& totals = mode.totals[c];
    list[c].contact = static_cast<Index>(c);
    list[c].normal_impulse = totals.normal;
    std::copy(totals.tangential.begin(), totals.tangential.end(), along[c].begin());
    list[c].losses = {totals.friction, totals.rescale, totals.damper};
    add_remembered(system.setting().contact[c].law, memory_of(mode, list[c].contact), 0, list[c].losses);
  }
  const auto& field = system.field(mode, x);
  for (std::size_t k = 0; k < mode.closed.size(); ++k) {
    const auto& one = mode.closed[k];
    const auto& contact = system.setting().contact[one.contact];
    const auto& now = field.contact(k);
    auto& history = list[one.contact];
    history.normal_impulse += x[at.normal(one.slot)];
    for (Index i = 0; i < at.tangents; ++i) along[one.contact][i] += x[at.tangential(one.slot) + i];
    const Index loss = at.losses(one.slot);
    history.losses.friction += x[loss];
    history.losses.rescale += x[loss + 1];
    history.losses.damper += x[loss + 2];
    const double depth = std::max(0.0, -now.motion.gap);
    history.stored = stored(contact.law, one.past, -now.motion.gap);
    history.losses.plastic = history.losses.adhesion = 0;
    add_remembered(contact.law, one.past, depth, history.losses);
    if (contact.tangential.has_spring() && depth > 0)
      history.stored_in_friction = 0.5 * dot(now.friction, now.friction) / now.spring;
    history.stored += history.stored_in_friction;
  }
  for (std::size_t c = 0; c < list.size(); ++c)
    list[c].tangential_impulse = {along[c][0], along[c][1], along[c][2]};
  return list;
}

template <int D>
void balance(const model::Bodies& bodies, const model::BodiesSystem<D>& system, ConstState start,
             ConstState end, const std::vector<BodyContactHistory>& contacts, BodiesImpact& impact) {
  const auto& setting = system.setting();
  auto& energy = impact.energy;
  energy.initial = kinetic(setting, start);
  energy.final = kinetic(setting, end);
  Vector3 given;
  double mass = 0;
  const model::BodiesLayout<D> at{.bodies = std::ssize(setting.body), .slots = 0};
  for (Index i = 0; i < at.bodies; ++i) {
    mass += setting.body[i].mass;
    energy.work += setting.body[i].mass * dot(setting.gravity, model::vec_at<D>(end, at.shift(i)));
  }
  for (const auto& contact : contacts) {
    energy.stored += contact.stored;
    for (const auto loss : each_loss) energy.losses.*loss += contact.losses.*loss;
    if (!bodies.contact[contact.contact].a.is_plane()) continue;
    const Vector3 one = impulse(bodies, contact);
    given = given + one;
    energy.work += dot(bodies.plane[bodies.contact[contact.contact].a.owner].velocity, one);
  }
  energy.residual = energy.final + energy.stored + energy.losses.total() - energy.initial - energy.work;
  Vector3 gained = (-mass * impact.time) * bodies.gravity - given;
  for (Index i = 0; i < at.bodies; ++i) {
    const auto before = model::vec_at<D>(start, at.velocity(i)),
               after = model::vec_at<D>(end, at.velocity(i));
    gained = gained + setting.body[i].mass * vector3(after - before);
  }
  impact.momentum_residual = gained;
  if (bodies.plane.empty() && norm(bodies.gravity) == 0)
    impact.angular_momentum_residual =
        angular_momentum(bodies, setting, end) - angular_momentum(bodies, setting, start);
}

template <int D>
std::vector<Balance> balances(const model::BodiesSystem<D>& system, const model::BodiesMode& mode, ConstState,
                              ConstState end, const std::vector<BodyContactHistory>& contacts,
                              const BodiesImpact& impact, double accuracy) {
  const double slack = body_slack * accuracy;
  const bool finite = std::all_of(end.begin(), end.end(), [](double v) { return std::isfinite(v); });
  if (!finite) return {{"the final state", NAN, slack}};
  const auto& setting = system.setting();
  double mass = 0;
  for (const auto& body : setting.body) mass = std::max(mass, body.mass);
  const double natural = std::max(impact.energy.initial, 0.5 * mass * setting.speed * setting.speed) +
                         std::abs(impact.energy.work);
  std::vector<Balance> list = {
      {"the energy balance [J]", impact.energy.residual, slack * natural},
      {"the momentum balance [N s]", norm(impact.momentum_residual), slack * 2 * natural / setting.speed}};
  double least = 0, lowest = 0;
  for (const auto& contact : contacts)
    for (const auto loss : each_loss) least = std::min(least, contact.losses.*loss);
  list.push_back({"a loss, which is below 0 [J],", least, slack * natural});
  const auto& field = system.field(mode, end);
  std::vector<bool> is_closed(contacts.size());
  for (const auto& one : mode.closed) is_closed[one.contact] = true;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (!is_closed[c]) {
      const Index i = static_cast<Index>(c);
      const double dent = model::closing_depth(setting.contact[c].law, memory_of(mode, i));
      lowest = std::min(lowest, field.approach(i).gap + dent);
    }
  list.push_back({"the gap of an open contact [m]", lowest, slack * setting.length});
  return list;
}

template std::vector<BodyContactHistory> exchanged(const model::BodiesSystem<2>&, const model::BodiesMode&,
                                                   ConstState);
template std::vector<BodyContactHistory> exchanged(const model::BodiesSystem<3>&, const model::BodiesMode&,
                                                   ConstState);
template void balance(const model::Bodies&, const model::BodiesSystem<2>&, ConstState, ConstState,
                      const std::vector<BodyContactHistory>&, BodiesImpact&);
template void balance(const model::Bodies&, const model::BodiesSystem<3>&, ConstState, ConstState,
                      const std::vector<BodyContactHistory>&, BodiesImpact&);
template std::vector<Balance> balances(const model::BodiesSystem<2>&, const model::BodiesMode&, ConstState,
                                       ConstState, const std::vector<BodyContactHistory>&,
                                       const BodiesImpact&, double);
template std::vector<Balance> balances(const model::BodiesSystem<3>&, const model::BodiesMode&, ConstState,
                                       ConstState, const std::vector<BodyContactHistory>&,
                                       const BodiesImpact&, double);

}  // namespace mariotte::impact
