// The list of bodies with friction.
#include "mariotte/impact/quantities/readers.hpp"

namespace mariotte::impact {
namespace {

using model::BodyEvent;

template <auto member>
constexpr auto of_body =
    [](const BodiesImpact& r, Indices at) { return component(r.body[at[0]].*member, at[1]); };

/// As many components as the dimension has.
constexpr auto components = [](const BodiesImpact& r, Indices) -> Count { return r.dimension; };
constexpr auto in_space = [](const BodiesImpact& r, Indices) -> Count { return r.dimension == 3 ? 3 : 0; };

Value in_plane(const BodiesImpact& r, double value) {
  return r.dimension == 2 ? Value(value) : Omitted{};
}

List<BodiesImpact> motion() {
  return {
      {.is = {"final.time", "s", "t", "time at which the run ended"}, .read = own<&BodiesImpact::time>},
      {.is = {"final.bodies[]", "", "", "bodies in the order of the scene"},
       .count = size_of<&BodiesImpact::body>},
      {.is = {"final.bodies[].position[]", "m", "x", "of the mass centre"},
       .read = of_body<&BodyEnd::position>,
       .count = components},
      {.is = {"final.bodies[].angle", "rad", "φ", "in the plane, above −π and at most π"},
       .read = [](const BodiesImpact& r, Indices at) { return in_plane(r, r.body[at[0]].angle); }},
      {.is = {"final.bodies[].quaternion[]", "1", "q", "attitude: w, x, y, z"},
       .read = [](const BodiesImpact& r, Indices at) -> Value {
         const auto& q = r.body[at[0]].attitude;
         return std::array{q.w, q.x, q.y, q.z}[at[1]];
       },
       .count = fixed<4>},
      {.is = {"final.bodies[].velocity[]", "m/s", "v", "of the mass centre"},
       .read = of_body<&BodyEnd::velocity>,
       .count = components},
      {.is = {"final.bodies[].spin", "rad/s", "ω", "in the plane: a number"},
       .read = [](const BodiesImpact& r, Indices at) { return in_plane(r, r.body[at[0]].spin.e3); }},
      {.is = {"final.bodies[].spin[]", "rad/s", "ω", "in space: three, space axes"},
       .read = of_body<&BodyEnd::spin>,
       .count = in_space},
  };
}

template <auto member>
constexpr auto contact_at = of_element<&BodiesImpact::contacts, member>;
template <auto member>
constexpr auto loss_at =
    [](const BodiesImpact& r, Indices at) -> Value { return r.contacts[at[0]].losses.*member; };

List<BodiesImpact> contacts() {
  using One = BodyContactHistory;
  return {
      {.is = {"contacts[]", "", "",
              "all pairs that may touch, as `check` lists them; of more than 200 pairs those that the scene "
              "names, in its order, then all others that have closed"},
       .count = size_of<&BodiesImpact::contacts>},
      {.is = {"contacts[].between[]", "", "", "the two that touch; a plane goes first"},
       .read = [](const BodiesImpact& r, Indices at) -> Value {
         return std::string_view(r.contacts[at[0]].between[at[1]]);
       },
       .count = fixed<2>},
      {.is = {"contacts[].normal_impulse", "N s", "∫ f_n dt", "along the normal"},
       .read = contact_at<&One::normal_impulse>},
      {.is = {"contacts[].tangential_impulse", "N s", "∫ f_t dt",
              "in the plane: on the second of the two, along the normal turned by 90°, which turns with it"},
       .read = [](const BodiesImpact& r,
                  Indices at) { return in_plane(r, r.contacts[at[0]].tangential_impulse.e1); }},
      {.is = {"contacts[].tangential_impulse[]", "N s", "∫ f_t dt", "in space: on the second of the two"},
       .read = [](const BodiesImpact& r,
                  Indices at) { return component(r.contacts[at[0]].tangential_impulse, at[1]); },
       .count = in_space},
      {.is = {"contacts[].losses.friction", "J", "", "lost by slip"},
       .read = loss_at<&ContactLosses::friction>},
      {.is = {"contacts[].losses.rescale", "J", "", "lost where Mindlin's stiffness changes"},
       .read = loss_at<&ContactLosses::rescale>},
      {.is = {"contacts[].losses.damper", "J", "", "lost in the damper of the normal law"},
       .read = loss_at<&ContactLosses::damper>},
      {.is = {"contacts[].losses.plastic_work", "J", "", "lost to yielding"},
       .read = loss_at<&ContactLosses::plastic>},
      {.is = {"contacts[].losses.adhesion_loss", "J", "", "lost where the contact snaps in and lets go"},
       .read = loss_at<&ContactLosses::adhesion>},
      {.is = {"contacts[].stored", "J", "", "elastic energy left at the end"},
       .read = contact_at<&One::stored>},
      {.is = {"contacts[].peak_force", "N", "max f_n", "largest normal force"},
       .read = contact_at<&One::peak_force>,
       .needs_peaks = true},
      {.is = {"contacts[].peak_friction", "N", "max f_t", "largest friction"},
       .read = contact_at<&One::peak_friction>,
       .needs_peaks = true},
      {.is = {"contacts[].peak_indentation", "m", "max δ", "largest indentation"},
       .read = contact_at<&One::peak_indentation>,
       .needs_peaks = true},
      {.is = {"contacts[].approach_speed", "m/s", "δ̇⁻",
              "along the normal, at which the two first met; null if they never did"},
       .read = meeting<&BodiesImpact::contacts, &MeetingSpeeds::approach>},
      {.is = {"contacts[].separation_speed", "m/s", "−δ̇⁺",
              "along the normal, at which they first parted; null if they did not"},
       .read = meeting<&BodiesImpact::contacts, &MeetingSpeeds::separation>},
      {.is = {"contacts[].periods[]", "", "", "intervals in which it is closed"},
       .count = size_in<&BodiesImpact::contacts, &One::periods>,
       .counted_by_run = true},
      {.is = {"contacts[].periods[][]", "s", "", "start and end; the end is null if it is still closed"},
       .read = [](const BodiesImpact& r, Indices at) -> Value {
         const auto& period = r.contacts[at[0]].periods[at[1]];
         return at[2] == 0 ? Value(period.start) : value(period.end);
       },
       .count = fixed<2>},
  };
}

template <BodyEvent event>
Quantity<BodiesImpact> change(std::string_view key, std::string_view meaning) {
  return {
      .is = {key, "1", "i", meaning},
      .read = [](const BodiesImpact& r, Indices at) -> Value { return r.events[at[0]].of(event)[at[1]] + 1; },
      .count = [](const BodiesImpact& r, Indices at) -> Count {
        return std::ssize(r.events[at[0]].of(event));
      },
      .counted_by_run = true};
}

List<BodiesImpact> events() {
  return {
      {.is = {"events[]", "", "", "instants at which something changes in a contact"},
       .count = size_of<&BodiesImpact::events>,
       .counted_by_run = true},
      {.is = {"events[].time", "s", "t", "when"},
       .read = of_element<&BodiesImpact::events, &BodiesEvents::time>},
      change<BodyEvent::close>("events[].close[]", "contacts that close, from 1"),
      change<BodyEvent::open>("events[].open[]", "contacts that open, from 1"),
      change<BodyEvent::stick>("events[].stick[]", "contacts that begin to stick, from 1"),
      change<BodyEvent::slip>("events[].slip[]", "contacts that begin to slip, from 1"),
      change<BodyEvent::reverse>("events[].reverse[]", "rigid contacts whose slip turns round, from 1"),
      change<BodyEvent::load>("events[].load[]", "contacts whose indentation grows again, from 1"),
      change<BodyEvent::unload>("events[].unload[]", "contacts whose indentation begins to fall, from 1"),
      change<BodyEvent::slack>("events[].slack[]",
                               "contacts whose damper takes all of the force, or that begin to pull, from 1"),
      change<BodyEvent::grip>("events[].grip[]", "contacts that push again after that, from 1"),
      change<BodyEvent::yield>("events[].yield[]", "contacts that begin to yield, from 1"),
      change<BodyEvent::touch>("events[].touch[]",
                               "contacts at rest at gap 0 that are pressed or part, from 1"),
      change<BodyEvent::part>("events[].part[]", "of these, those that part without a force, from 1"),
  };
}

template <auto member>
constexpr auto loss = [](const BodiesImpact& r, Indices) -> Value { return r.energy.losses.*member; };

List<BodiesImpact> balances() {
  using One = BodiesBalance;
  return {
      {.is = {"energy.initial", "J", "T⁻", "kinetic energy at the start"}, .read = energy<&One::initial>},
      {.is = {"energy.final", "J", "T⁺", "kinetic energy at the end"}, .read = energy<&One::final>},
      {.is = {"energy.stored", "J", "", "in contacts that are closed at the end"},
       .read = energy<&One::stored>},
      {.is = {"energy.dissipated", "J", "", "the five below together"},
       .read = [](const BodiesImpact& r, Indices) -> Value { return r.energy.losses.total(); }},
      {.is = {"energy.friction", "J", "", "lost by slip"}, .read = loss<&ContactLosses::friction>},
      {.is = {"energy.rescale", "J", "", "lost where Mindlin's stiffness changes"},
       .read = loss<&ContactLosses::rescale>},
      {.is = {"energy.damper", "J", "", "lost in dampers"}, .read = loss<&ContactLosses::damper>},
      {.is = {"energy.plastic_work", "J", "", "lost to yielding"}, .read = loss<&ContactLosses::plastic>},
      {.is = {"energy.adhesion_loss", "J", "", "lost where contacts snap in and let go"},
       .read = loss<&ContactLosses::adhesion>},
      {.is = {"energy.work", "J", "", "work of gravity and of moving planes"}, .read = energy<&One::work>},
      {.is = {"energy.residual", "J", "", "final + stored + dissipated − initial − work, the error"},
       .read = energy<&One::residual>},
      {.is = {"momentum.residual", "N s", "",
              "size of final − initial − impulses of planes and gravity, the error"},
       .read = [](const BodiesImpact& r, Indices) -> Value { return norm(r.momentum_residual); }},
      {.is = {"momentum.angular_residual", "N m s", "",
              "the same of angular momentum about the origin; 0 beside planes and gravity"},
       .read = [](const BodiesImpact& r, Indices) -> Value { return norm(r.angular_momentum_residual); }},
  };
}

}  // namespace

template <>
const std::vector<Quantity<BodiesImpact>>& quantities() {
  static const auto list = [] {
    List<BodiesImpact> all = motion();
    for (const auto& part :
         {contacts(), events(), balances(), validity<BodiesImpact>(), cost_of_run<BodiesImpact>()})
      append(all, part);
    return all;
  }();
  return list;
}

BodiesImpact unfilled(const model::Bodies& bodies) {
  BodiesImpact impact;
  impact.dimension = bodies.dimension;
  impact.body.resize(bodies.body.size());
  impact.contacts.resize(static_cast<std::size_t>(always_told(bodies)));
  return impact;
}

}  // namespace mariotte::impact
