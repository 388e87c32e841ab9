#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/report/reason.hpp"
#include "mariotte/report/table/background.hpp"
#include "mariotte/report/table/balance_tables.hpp"
#include "mariotte/report/table/law_name.hpp"
#include "mariotte/report/table/pair_speeds.hpp"
#include "mariotte/report/table/quantity_table.hpp"
#include "mariotte/report/table/restitution_table.hpp"
#include "mariotte/report/table/table.hpp"
#include "mariotte/scene/restitution.hpp"

namespace mariotte::report {
namespace {

using model::BodyEvent;

std::string summary(const impact::BodiesImpact& impact, const scene::Scene& scene, const Display& time) {
  std::string text = fmt::format("{} at {} {} · accuracy {:.3g} requested", ending_name(impact.ending, scene),
                                 shown(time, impact.time), time.unit, impact.requested_accuracy);
  text += estimate(impact.estimated_accuracy);
  if (const auto why = reason(impact.ending, impact.message, scene); !why.empty()) text += "\n" + why;
  return text + "\n";
}

std::string what(const impact::BodiesEvents& event) {
  std::string text;
  const auto add = [&](BodyEvent kind, const char* word) {
    if (const auto& list = event.of(kind); !list.empty())
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", numbers(list), word);
  };
  add(BodyEvent::close, "closes");
  add(BodyEvent::touch, "touches");
  add(BodyEvent::part, "parts");
  add(BodyEvent::stick, "sticks");
  add(BodyEvent::slip, "slips");
  add(BodyEvent::reverse, "slips back");
  add(BodyEvent::load, "loads");
  add(BodyEvent::unload, "unloads");
  add(BodyEvent::slack, "goes slack");
  add(BodyEvent::grip, "grips");
  add(BodyEvent::yield, "yields");
  add(BodyEvent::open, "opens");
  return text;
}

std::string events(const impact::BodiesImpact& impact, const Display& time) {
  if (impact.events.empty()) return "\nEvents: none\n";
  const auto row = [&](Index i) -> TableRow {
    return {shown(time, impact.events[i].time), what(impact.events[i])};
  };
  return "\nEvents\n" + columns({"time [" + time.unit + "]", "contacts"}, std::ssize(impact.events), row);
}

std::string three(const Vector3& v, int dimension) {
  const auto two = rounded(v.e1, 8) + ", " + rounded(v.e2, 8);
  return dimension == 2 ? two : two + ", " + rounded(v.e3, 8);
}
std::string turn(const Vector3& v, int dimension) {
  return dimension == 2 ? rounded(v.e3, 8) : three(v, 3);
}

std::string motion(const impact::BodiesImpact& impact, const model::Bodies& bodies) {
  const int d = impact.dimension;
  const auto row = [&](Index i) -> TableRow {
    const auto& end = impact.body[i];
    return {body_name(bodies, i), three(bodies.body[i].velocity, d), three(end.velocity, d),
            turn(bodies.body[i].spin, d), turn(end.spin, d)};
  };
  return "\nBodies\n" +
         columns({"", "velocity before [m/s]", "after [m/s]", "spin before [rad/s]", "after [rad/s]"},
                 std::ssize(impact.body), row);
}

/// Of those that closed or have a table of their own in the scene.
std::string contacts(const impact::BodiesImpact& impact, const model::Bodies& bodies) {
  std::vector<Index> shown;
  for (Index i = 0; i < std::ssize(impact.contacts); ++i)
    if (impact.contacts[i].contact < bodies.named || !impact.contacts[i].periods.empty()) shown.push_back(i);
  const auto row = [&](Index k) -> TableRow {
    const Index i = shown[k];
    const auto& one = impact.contacts[i];
    return {fmt::format("{}", i + 1),
            fmt::format("{} – {}", one.between[0], one.between[1]),
            fmt::format("{}", one.periods.size()),
            rounded(one.normal_impulse, 6),
            impact.dimension == 2 ? rounded(one.tangential_impulse.e1, 6)
                                  : rounded(norm(one.tangential_impulse), 6),
            rounded(one.peak_force, 5),
            rounded(one.losses.friction, 5),
            rounded(one.losses.total() - one.losses.friction, 5)};
  };
  return "\nContacts\n" + columns({"", "between", "periods", "∫ f_n dt [N s]", "∫ f_t dt", "peak f_n [N]",
                                   "friction [J]", "other loss [J]"},
                                  std::ssize(shown), row);
}

/// How fast the two of each contact first met and parted; of the only one that has closed also their ratio.
std::string meetings(const impact::BodiesImpact& impact) {
  std::vector<Index> met;
  for (Index i = 0; i < std::ssize(impact.contacts); ++i)
    if (!impact.contacts[i].periods.empty()) met.push_back(i);
  if (met.empty()) return "";
  const auto& first = impact.contacts[met[0]];
  if (met.size() == 1) return pair_table(first.meeting, first.periods.size());
  const auto speed = [](const std::optional<double>& one) {
    return one ? rounded(*one, 6) : std::string("–");
  };
  const auto row = [&](Index i) -> TableRow {
    const auto& [approach, separation] = impact.contacts[met[i]].meeting;
    return {fmt::format("{}", met[i] + 1), speed(approach), speed(separation)};
  };
  return "\nFirst meetings\n" +
         columns({"contact", "approach [m/s]", "separation [m/s]"}, std::ssize(met), row);
}

constexpr BalanceLine bodies_energies[] = {{"kinetic before", "energy.initial"},
                                           {"work of gravity and planes", "energy.work", true},
                                           {"kinetic after", "energy.final"},
                                           {"stored in contacts", "energy.stored", true},
                                           {"dissipated", "energy.dissipated"},
                                           {"  by friction", "energy.friction"},
                                           {"  by rescaling", "energy.rescale", true},
                                           {"  by dampers", "energy.damper", true},
                                           {"  by yielding", "energy.plastic_work", true},
                                           {"  by adhesion", "energy.adhesion_loss", true}};

/// What damped pairs alone would do, as if their bodies were balls.
std::string restitutions(const model::Bodies& bodies) {
  double speed = 0;
  bool damped = false;
  const auto of = [&](const model::Feature& one) {
    return one.is_plane() ? bodies.plane[one.owner].velocity : bodies.body[one.owner].velocity;
  };
  const auto mass = [&](const model::Feature& one) {
    return one.is_plane() ? infinity : bodies.body[one.owner].mass;
  };
  for (const auto& contact : bodies.contact) {
    speed = std::max(speed, norm(of(contact.b) - of(contact.a)));
    damped = damped || contact::dissipates(contact.law);
  }
  if (!damped) return "";
  return restitution_table("contact", std::ssize(bodies.contact), speed, [&](Index i, double at) {
    const auto& one = bodies.contact[i];
    return scene::restitution(one.law,
                              {.reduced_mass = scene::reduced_mass(mass(one.a), mass(one.b)), .speed = at});
  });
}

std::string contacts_at_start(const model::Bodies& bodies) {
  TableRow header = {"",           "contact", "law",      "k [N/mⁿ]", "c [N s/mⁿ]",        "n",
                     "tangential", "μ",       "k_t or κ", "gap [m]",  "other numbers [SI]"};
  std::vector<LawCells> laws;
  for (const auto& one : bodies.contact)
    laws.push_back(law_cells(one.law, [](double value) { return rounded(value, 8); }));
  const bool has_others =
      std::any_of(laws.begin(), laws.end(), [](const auto& one) { return !one.others.empty(); });
  if (!has_others) header.pop_back();
  return columns(header, std::ssize(bodies.contact), [&](Index i) {
    const auto& one = bodies.contact[i];
    const auto& law = laws[static_cast<std::size_t>(i)];
    TableRow row = {fmt::format("{}", i + 1),
                    fmt::format("{} – {}", name_of(bodies, one.a), name_of(bodies, one.b)),
                    law_name(one.law),
                    law.stiffness,
                    law.damping,
                    law.exponent,
                    std::string(name(one.tangential.law)),
                    rounded(one.tangential.friction, 6),
                    one.tangential.has_spring() ? rounded(one.tangential.stiffness, 8) : "",
                    rounded(start_gap(bodies, one), 8),
                    law.others};
    row.resize(header.size());
    return row;
  });
}

}  // namespace

std::string table(const impact::BodiesImpact& impact, const scene::Scene& scene, Detail detail) {
  const auto time = display_for(std::vector{impact.time}, "s");
  const auto& bodies = std::get<model::Bodies>(scene.model);
  return heading(scene.title.empty() ? "Bodies with friction" : scene.title) + summary(impact, scene, time) +
         events(impact, time) + motion(impact, bodies) + contacts(impact, bodies) + meetings(impact) +
         balance_table("Energy", impact, bodies_energies, "energy.residual") +
         (detail == Detail::full ? background(impact, "contact") : "");
}

std::string table_of_bodies(const model::Bodies& bodies, const scene::Scene& scene) {
  const int d = bodies.dimension;
  std::string text = (scene.title.empty() ? "Bodies with friction" : scene.title) + "\n";
  text += fmt::format("{} dimensions · gravity {} m/s²\n\n", d, three(bodies.gravity, d));
  const auto body = [&](Index i) -> TableRow {
    const auto& one = bodies.body[i];
    return {body_name(bodies, i),
            rounded(one.mass, 8),
            d == 2 ? rounded(one.inertia.e3, 8) : three(one.inertia, 3),
            fmt::format("{}", one.spheres.size()),
            three(one.position, d),
            three(one.velocity, d),
            turn(one.spin, d)};
  };
  text += columns(
      {"", "mass [kg]", "inertia [kg m²]", "spheres", "position [m]", "velocity [m/s]", "spin [rad/s]"},
      std::ssize(bodies.body), body);
  text += "\n" + contacts_at_start(bodies) + restitutions(bodies);
  return text + fmt::format("\naccuracy {:.3g} · flow {}\n", scene.run.accuracy, flow::name(scene.run.flow));
}

}  // namespace mariotte::report
