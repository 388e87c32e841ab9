// The lists of a chain and of a contact network.
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/laws/restitution.hpp"
#include "mariotte/impact/quantities/readers.hpp"

namespace mariotte::impact {
namespace {

double energy_before(const Brief<ChainImpact>& b) {
  return kinetic_energy(b.chain, b.chain.velocity);
}
double energy_after(const Brief<ChainImpact>& b) {
  return kinetic_energy(b.chain, b.impact.velocity);
}
double energy_before(const Brief<NetworkImpact>& b) {
  return kinetic_energy(configuration_of(b.network), b.network.velocity);
}
double energy_after(const Brief<NetworkImpact>& b) {
  return kinetic_energy(configuration_of(b.network), b.impact.velocity);
}

template <class Number>
Value at(const std::vector<Number>& values, Index i) {
  return i < std::ssize(values) ? Value(values[i]) : Value();
}

/// r_j; zero if no impulse was exchanged.
Value direction(const BriefImpact& impact, Index j) {
  const double length = magnitude(impact.impulse);
  return length > 0 && j < std::ssize(impact.impulse) ? impact.impulse[j] / length : at(impact.impulse, j);
}

/// Coordinates of balls move in m/s; other degrees of freedom have units that only the author knows.
template <class I>
constexpr std::string_view velocity_unit = std::is_same_v<I, ChainImpact> ? "m/s" : "SI";

template <class I>
List<I> motion() {
  return {
      {.is = {"final.time", "s", "t", "time at which the run ended"},
       .read = own<&I::time>,
       .brief = [](const Brief<I>& b, Indices) -> Value { return b.impact.time; }},
      {.is = {"final.velocity[]", velocity_unit<I>, "v_i",
              "velocity at the end, of each ball or degree of freedom"},
       .read = element<&I::velocity>,
       .count = size_of<&I::velocity>,
       .brief = [](const Brief<I>& b, Indices i) { return at(b.impact.velocity, i[0]); }},
      {.is = {"final.gap[]", "m", "g_j", "gap of each contact at the end, negative in contact, to rounding"},
       .read = element<&I::gap>,
       .count = size_of<&I::gap>},
  };
}

template <class I>
List<I> contacts() {
  using One = ContactHistory;
  return {
      {.is = {"contacts[]", "", "", "one per contact, from left to right"}, .count = size_of<&I::contacts>},
      {.is = {"contacts[].impulse", "N s", "p_j", "impulse of the contact, the integral of its force"},
       .read = of_element<&I::contacts, &One::impulse>,
       .brief = [](const Brief<I>& b, Indices i) { return at(b.impact.impulse, i[0]); }},
      {.is = {"contacts[].peak_force", "N", "max f_j", "largest force"},
       .read = of_element<&I::contacts, &One::peak_force>,
       .needs_peaks = true},
      {.is = {"contacts[].peak_indentation", "m", "max δ_j", "largest indentation"},
       .read = of_element<&I::contacts, &One::peak_indentation>,
       .needs_peaks = true},
      {.is = {"contacts[].approach_speed", "m/s", "δ̇_j⁻",
              "at which its bodies first met; null if they never did, or were indented from the start"},
       .read = meeting<&I::contacts, &MeetingSpeeds::approach>},
      {.is = {"contacts[].separation_speed", "m/s", "−δ̇_j⁺",
              "at which they first parted; null if they did not"},
       .read = meeting<&I::contacts, &MeetingSpeeds::separation>},
      {.is = {"contacts[].periods[]", "", "", "stretches of time in which it carries force"},
       .count = size_in<&I::contacts, &One::periods>,
       .counted_by_run = true,
       .brief = [](const Brief<I>& b, Indices i) { return at(b.impact.periods, i[0]); }},
      {.is = {"contacts[].periods[][]", "s", "",
              "start and end of one; the end is null if it never came, and blurred where bodies part with "
              "hardly any "
              "speed"},
       .read = [](const I& r, Indices at) -> Value {
         const auto& period = r.contacts[at[0]].periods[at[1]];
         return at[2] == 0 ? period.start : value(period.end);
       },
       .count = fixed<2>},
      {.is = {"contacts[].stored", "J", "", "elastic energy left at the end"},
       .read = of_element<&I::contacts, &One::stored>},
      {.is = {"contacts[].dissipated", "J", "", "energy dissipated in the contact"},
       .read = of_element<&I::contacts, &One::dissipated>},
      {.is = {"contacts[].plastic_work", "J", "", "of the dissipated energy, what yielding took"},
       .read = of_element<&I::contacts, &One::plastic>},
      {.is = {"contacts[].adhesion_loss", "J", "",
              "of the dissipated energy, what snapping in and letting go took"},
       .read = of_element<&I::contacts, &One::adhesion>},
      {.is = {"contacts[].permanent_indentation", "m", "δ_p", "depth of the dent"},
       .read = of_element<&I::contacts, &One::permanent_indentation>},
      {.is = {"bound_frequency[]", "Hz", "ω/2π",
              "of small oscillations of what adhesion holds together, at the ending `bound`"},
       .read = element<&I::bound_frequency>,
       .count = size_of<&I::bound_frequency>,
       .counted_by_run = true},
  };
}

template <class I>
List<I> directions() {
  return {
      {.is = {"impulse_direction[]", "1", "r_j", "direction of all impulses, p_j/|p|"},
       .read = element<&I::impulse_direction>,
       .count = size_of<&I::impulse_direction>,
       .brief = [](const Brief<I>& b, Indices i) { return direction(b.impact, i[0]); }},
  };
}

/// Every model names the same five changes; contacts without friction neither stick, slip nor get captured.
template <class I>
List<I> events() {
  List<I> list = {
      {.is = {"events[]", "", "",
              "instants at which contacts start or cease to carry force, yield or unload"},
       .count = size_of<&I::events>,
       .counted_by_run = true},
      {.is = {"events[].time", "s", "t", "when"}, .read = of_element<&I::events, &Event::time>},
      {.is = {"events[].open[]", "1", "j", "contacts that open, from 1"},
       .read = numbered<&Event::open>,
       .count = size_in<&I::events, &Event::open>,
       .counted_by_run = true},
      {.is = {"events[].close[]", "1", "j", "contacts that close, from 1"},
       .read = numbered<&Event::close>,
       .count = size_in<&I::events, &Event::close>,
       .counted_by_run = true},
      {.is = {"events[].yield[]", "1", "j", "contacts that become plastic, for the first time or again"},
       .read = numbered<&Event::yield>,
       .count = size_in<&I::events, &Event::yield>,
       .counted_by_run = true},
      {.is = {"events[].unload[]", "1", "j", "plastic contacts that turn back"},
       .read = numbered<&Event::unload>,
       .count = size_in<&I::events, &Event::unload>,
       .counted_by_run = true},
  };
  for (const auto* key : {"events[].stick[]", "events[].slip[]", "events[].capture[]"})
    list.push_back({.is = {key, "1", "j", "always empty: contacts are without friction"},
                    .read = [](const I&, Indices) { return Value(); },
                    .count = fixed<0>});
  return list;
}

template <class I>
List<I> energies() {
  using One = EnergyBalance;
  return {
      {.is = {"energy.initial", "J", "", "kinetic and elastic energy at the start"},
       .read = energy<&One::initial>},
      {.is = {"energy.final", "J", "T⁺", "kinetic energy at the end"},
       .read = energy<&One::final>,
       .brief = [](const Brief<I>& b, Indices) -> Value { return energy_after(b); }},
      {.is = {"energy.stored", "J", "", "elastic energy at the end"}, .read = energy<&One::stored>},
      {.is = {"energy.dissipated", "J", "", "energy dissipated in all contacts"},
       .read = energy<&One::dissipated>},
      {.is = {"energy.plastic_work", "J", "", "of the dissipated energy, what yielding took"},
       .read = energy<&One::plastic>},
      {.is = {"energy.adhesion_loss", "J", "",
              "of the dissipated energy, what snapping in and letting go took"},
       .read = energy<&One::adhesion>},
      {.is = {"energy.work", "J", "", "work of gravity, moving walls and forces on the balls"},
       .read = energy<&One::work>},
      {.is = {"energy.residual", "J", "", "final + stored + dissipated − initial − work, the error"},
       .read = energy<&One::residual>},
      {.is = {"energy.ratio_lab", "1", "T⁺/T⁻", "kinetic energies, in the given frame"},
       .read = energy<&One::ratio_lab>,
       .brief = [](const Brief<I>& b,
                   Indices) { return value(energy_ratio(energy_after(b), energy_before(b))); }},
      {.is = {"energy.ratio_centre", "1", "T⁺/T⁻", "kinetic energies, relative to the mass centre"},
       .read = energy<&One::ratio_centre>},
  };
}

template <auto member>
constexpr auto momentum = [](const ChainImpact& r, Indices) -> Value { return r.momentum.*member; };

List<ChainImpact> momenta(const ChainImpact*) {
  using One = MomentumBalance;
  return {
      {.is = {"momentum.initial", "N s", "", "momentum of the balls at the start"},
       .read = momentum<&One::initial>},
      {.is = {"momentum.final", "N s", "", "momentum of the balls at the end"},
       .read = momentum<&One::final>},
      {.is = {"momentum.residual", "N s", "", "final − initial − impulses of walls and gravity, the error"},
       .read = momentum<&One::residual>},
  };
}

/// Of two balls alone.
Value pair_restitution(const ChainImpact& r) {
  if (r.contacts.size() != 1) return Omitted();
  const auto& [approach, separation] = r.contacts[0].meeting;
  if (!approach) return {};
  if (separation) return *separation / *approach;
  return r.ending == hybrid::Ending::bound || r.ending == hybrid::Ending::captured ? Value(0.0) : Value();
}

/// What only a chain has: contacts that follow each other are neighbours.
List<ChainImpact> ratios(const ChainImpact*) {
  using I = ChainImpact;
  return {
      {.is = {"icr[]", "1", "α_j",
              "impulse correlation ratio p_j/p_{j+1}; null where p_{j+1} = 0, or below what counts as rest"},
       .read = element<&I::icr>,
       .count = size_of<&I::icr>,
       .brief = [](const Brief<I>& b,
                   Indices i) { return value(correlation_ratio(b.impact.impulse, i[0])); }},
      {.is =
           {"restitution", "1", "e",
            "of two balls alone: speed at which they first parted over that at which they met; 0 where they "
            "stay together"},
       .read = [](const ChainImpact& r, Indices) { return pair_restitution(r); }},
  };
}

/// What only a network has: an approximation.
List<NetworkImpact> ratios(const NetworkImpact*) {
  return {
      {.is = {"turning", "rad", "Δψ",
              "largest angle by which the direction of a closed contact of balls would have turned, which "
              "is neglected; null for other degrees of freedom"},
       .read = own<&NetworkImpact::turning>}};
}

List<NetworkImpact> momenta(const NetworkImpact*) {
  return {
      {.is = {"momentum.residual", "1", "", "what the impulses do not explain of the velocities, relative"},
       .read = own<&NetworkImpact::momentum_residual>}};
}

template <class I>
List<I> all() {
  List<I> list = motion<I>();
  for (const auto& part :
       {contacts<I>(), ratios(static_cast<const I*>(nullptr)), directions<I>(), events<I>(), energies<I>(),
        momenta(static_cast<const I*>(nullptr)), validity<I>(), cost_of_run<I>()})
    append(list, part);
  return list;
}

template <class I, class Model>
I sized(const Model& model) {
  I impact;
  const std::size_t contacts = model.law.size();
  impact.velocity.resize(model.velocity.size());
  impact.gap.resize(contacts);
  impact.contacts.resize(contacts);
  impact.icr.resize(contacts > 0 ? contacts - 1 : 0);
  impact.impulse_direction.resize(contacts);
  return impact;
}

}  // namespace

template <>
const std::vector<Quantity<ChainImpact>>& quantities() {
  static const auto list = all<ChainImpact>();
  return list;
}

template <>
const std::vector<Quantity<NetworkImpact>>& quantities() {
  static const auto list = all<NetworkImpact>();
  return list;
}

ChainImpact unfilled(const model::Chain& chain) {
  return sized<ChainImpact>(chain);
}

NetworkImpact unfilled(const model::Network& network) {
  return sized<NetworkImpact>(network);
}

}  // namespace mariotte::impact
