// The list of a microbody.
#include "mariotte/impact/laws/restitution.hpp"
#include "mariotte/impact/quantities/readers.hpp"

namespace mariotte::impact {
namespace {

using BriefBody = Brief<MicrobodyImpact>;

/// Both are 0 of a captured body, and empty before the tip has separated.
std::optional<Restitution> restitution_of(const BriefBody& b) {
  if (b.impact.ending == hybrid::Ending::captured) return Restitution{};
  if (b.impact.ending != hybrid::Ending::separated) return std::nullopt;
  return restitution(tip_velocity(b.body, 0), b.impact.tip_velocity, b.body.velocity.e1,
                     b.impact.velocity.e1);
}

std::optional<Restitution> restitution_of(const MicrobodyImpact& r) {
  return has_restitution(r) ? std::optional(r.restitution) : std::nullopt;
}

template <auto member>
constexpr auto restitution_at = [](const auto& r, Indices) -> Value {
  const auto e = restitution_of(r);
  return e ? value((*e).*member) : Value();
};

template <auto member>
constexpr auto final_vector =
    [](const MicrobodyImpact& r, Indices i) { return component(r.final.*member, i[0]); };

template <auto member>
constexpr auto brief_vector =
    [](const BriefBody& b, Indices i) { return i[0] < 3 ? component(b.impact.*member, i[0]) : Value(); };

List<MicrobodyImpact> body_motion() {
  return {
      {.is = {"final.time", "s", "t", "time at which the run ended"},
       .read = [](const MicrobodyImpact& r, Indices) -> Value { return r.final.time; },
       .brief = [](const BriefBody& b, Indices) -> Value { return b.impact.time; }},
      {.is = {"final.position[]", "m", "x", "mass centre: height over the plane, then way along e2 and e3"},
       .read = final_vector<&BodyState::position>,
       .count = fixed<3>},
      {.is = {"final.quaternion[]", "1", "q", "attitude: w, x, y, z"},
       .read = [](const MicrobodyImpact& r, Indices i) -> Value {
         const auto& q = r.final.attitude;
         return std::array{q.w, q.x, q.y, q.z}[i[0]];
       },
       .count = fixed<4>},
      {.is = {"final.angles[]", "rad", "α, β, γ", "attitude as angles"},
       .read = [](const MicrobodyImpact& r, Indices i) -> Value {
         const auto angles = to_euler(r.final.attitude);
         return std::array{angles.alpha, angles.beta, angles.gamma}[i[0]];
       },
       .count = fixed<3>},
      {.is = {"final.velocity[]", "m/s", "v", "velocity of the mass centre: normal, along e2, along e3"},
       .read = final_vector<&BodyState::velocity>,
       .count = fixed<3>,
       .brief = brief_vector<&BriefMicrobodyImpact::velocity>},
      {.is = {"final.spin[]", "rad/s", "ω", "angular velocity at the end, space axes"},
       .read = final_vector<&BodyState::spin>,
       .count = fixed<3>,
       .brief = brief_vector<&BriefMicrobodyImpact::spin>},
      {.is = {"restitution.tip", "1", "e_n", "rebound over incident normal velocity of the first tip"},
       .read = restitution_at<&Restitution::tip>,
       .brief = restitution_at<&Restitution::tip>},
      {.is = {"restitution.centre", "1", "e_nm", "the same of the mass centre"},
       .read = restitution_at<&Restitution::centre>,
       .brief = restitution_at<&Restitution::centre>},
  };
}

template <auto member>
constexpr auto impact_at = of_element<&MicrobodyImpact::impacts, member>;

/// What is known only once the tip has separated.
template <auto member>
constexpr auto after_impact = [](const MicrobodyImpact& r, Indices at) -> Value {
  const auto& one = r.impacts[at[0]];
  return one.end ? value(one.*member) : Value();
};

List<MicrobodyImpact> impacts() {
  using One = TipImpact;
  return {
      {.is = {"impacts[]", "", "", "contacts of a tip, in order of time"},
       .count = size_of<&MicrobodyImpact::impacts>,
       .counted_by_run = true},
      {.is = {"impacts[].tip", "1", "i", "the tip, from 1"},
       .read = [](const MicrobodyImpact& r, Indices at) -> Value { return r.impacts[at[0]].tip + 1; }},
      {.is = {"impacts[].start", "s", "", "when it touches"}, .read = impact_at<&One::start>},
      {.is = {"impacts[].end", "s", "", "when it separates; null if it does not"},
       .read = impact_at<&One::end>},
      {.is = {"impacts[].normal_velocity_in", "m/s", "ṅ⁻", "normal velocity of the tip before"},
       .read = impact_at<&One::normal_velocity_in>},
      {.is = {"impacts[].normal_velocity_out", "m/s", "ṅ⁺", "normal velocity of the tip after"},
       .read = after_impact<&One::normal_velocity_out>},
      {.is = {"impacts[].centre_velocity_in", "m/s", "", "normal velocity of the mass centre before"},
       .read = impact_at<&One::centre_velocity_in>},
      {.is = {"impacts[].centre_velocity_out", "m/s", "", "normal velocity of the mass centre after"},
       .read = after_impact<&One::centre_velocity_out>},
      {.is = {"impacts[].slip_out[]", "m/s", "", "velocity of the contact point along e2, e3 after"},
       .read = [](const MicrobodyImpact& r,
                  Indices at) { return component(r.impacts[at[0]].slip_out, at[1] + 1); },
       .count = [](const MicrobodyImpact& r,
                   Indices at) { return r.impacts[at[0]].end ? Count(2) : Count(); },
       .counted_by_run = true},
      {.is = {"impacts[].peak_force", "N", "max F_n", "largest push of the plane"},
       .read = impact_at<&One::peak_force>,
       .needs_peaks = true},
      {.is = {"impacts[].peak_pull", "N", "−min F_n", "largest pull of the plane, ≥ 0"},
       .read = impact_at<&One::peak_pull>,
       .needs_peaks = true},
      {.is = {"impacts[].peak_indentation", "m", "max n", "largest indentation"},
       .read = impact_at<&One::peak_indentation>,
       .needs_peaks = true},
  };
}

template <auto member>
Quantity<MicrobodyImpact> change(std::string_view key, std::string_view meaning) {
  return {.is = {key, "1", "i", meaning},
          .read = numbered<member>,
          .count = size_in<&MicrobodyImpact::events, member>,
          .counted_by_run = true};
}

List<MicrobodyImpact> body_events() {
  return {
      {.is = {"events[]", "", "", "instants at which something changes at a tip"},
       .count = size_of<&MicrobodyImpact::events>,
       .counted_by_run = true},
      {.is = {"events[].time", "s", "t", "when"},
       .read = of_element<&MicrobodyImpact::events, &TipEvents::time>},
      change<&TipEvents::open>("events[].open[]", "tips that separate, from 1"),
      change<&TipEvents::close>("events[].close[]", "tips that touch, from 1"),
      change<&TipEvents::stick>("events[].stick[]", "tips that begin to stick, from 1"),
      change<&TipEvents::slip>("events[].slip[]", "tips that begin to slip, from 1"),
      {.is = {"events[].force_sign[]", "1", "±i",
              "tips that are pushed from now on, negative: pulled; from 1"},
       .read = [](const MicrobodyImpact& r, Indices at) -> Value {
         const auto& [push, pull] = std::tie(r.events[at[0]].push, r.events[at[0]].pull);
         const Index pushed = std::ssize(push);
         return at[1] < pushed ? push[at[1]] + 1 : -(pull[at[1] - pushed] + 1);
       },
       .count = [](const MicrobodyImpact& r, Indices at) -> Count {
         return std::ssize(r.events[at[0]].push) + std::ssize(r.events[at[0]].pull);
       },
       .counted_by_run = true},
      change<&TipEvents::capture>("events[].capture[]", "tips that are captured, from 1"),
  };
}

List<MicrobodyImpact> energies() {
  using One = MicrobodyBalance;
  return {
      {.is = {"energy.initial", "J", "T⁻", "kinetic energy at the start"}, .read = energy<&One::initial>},
      {.is = {"energy.final", "J", "T⁺", "kinetic energy at the end"}, .read = energy<&One::final>},
      {.is = {"energy.stored", "J", "", "in closed contacts at the end; negative in the well of adhesion"},
       .read = energy<&One::stored>},
      {.is = {"energy.dissipated", "J", "", "the three below together"},
       .read = [](const MicrobodyImpact& r, Indices) -> Value { return r.energy.dissipated(); }},
      {.is = {"energy.hertz_damping", "J", "", "energy dissipated by the damping of the Hertz force"},
       .read = energy<&One::hertz_damping>},
      {.is = {"energy.adhesion_damping", "J", "", "energy dissipated by the damping of adhesion"},
       .read = energy<&One::adhesion_damping>},
      {.is = {"energy.friction", "J", "", "energy dissipated by friction"}, .read = energy<&One::friction>},
      {.is = {"energy.work", "J", "", "work of gravity"}, .read = energy<&One::work>},
      {.is = {"energy.residual", "J", "", "final + stored + dissipated − initial − work, the error"},
       .read = energy<&One::residual>},
  };
}

Value if_captured(const MicrobodyImpact& r, Value told) {
  return r.rest ? told : Omitted{};
}

List<MicrobodyImpact> others() {
  return {
      {.is = {"rest.tip", "1", "i", "captured tip, from 1; rest is null of a body that is not captured"},
       .read = [](const MicrobodyImpact& r,
                  Indices) { return if_captured(r, r.rest ? r.rest->tip + 1 : 0); }},
      {.is = {"rest.indentation", "m", "n", "how deep it comes to rest"},
       .read = [](const MicrobodyImpact& r,
                  Indices) { return if_captured(r, r.rest ? r.rest->indentation : 0); }},
      {.is = {"shared_friction", "", "", "two tips stuck at once, and the least friction was taken"},
       .read = own<&MicrobodyImpact::shared_friction>},
  };
}

List<MicrobodyImpact> momenta() {
  return {{.is = {"momentum.impulse[]", "N s", "", "impulse of the plane on the body: normal, along e2, e3"},
           .read = [](const MicrobodyImpact& r, Indices i) { return component(r.impulse, i[0]); },
           .count = fixed<3>}};
}

}  // namespace

template <>
const std::vector<Quantity<MicrobodyImpact>>& quantities() {
  static const auto list = [] {
    List<MicrobodyImpact> all = body_motion();
    for (const auto& part : {impacts(), body_events(), others(), energies(), momenta(),
                             validity<MicrobodyImpact>(), cost_of_run<MicrobodyImpact>()})
      append(all, part);
    return all;
  }();
  return list;
}

MicrobodyImpact unfilled(const model::Microbody&) {
  return {};
}

}  // namespace mariotte::impact
