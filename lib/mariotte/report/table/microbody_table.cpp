#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/report/reason.hpp"
#include "mariotte/report/table/background.hpp"
#include "mariotte/report/table/balance_tables.hpp"
#include "mariotte/report/table/quantity_table.hpp"
#include "mariotte/report/table/restitution_table.hpp"
#include "mariotte/report/table/table.hpp"
#include "mariotte/scene/restitution.hpp"

namespace mariotte::report {
namespace {

constexpr double degree = std::numbers::pi / 180;

std::string summary(const impact::MicrobodyImpact& impact, const scene::Scene& scene, const Display& time) {
  std::string text =
      fmt::format("{} at {} {} · {} impact{} · accuracy {:.3g} requested", ending_name(impact.ending, scene),
                  shown(time, impact.final.time), time.unit, impact.impacts.size(),
                  impact.impacts.size() == 1 ? "" : "s", impact.requested_accuracy);
  text += estimate(impact.estimated_accuracy);
  if (const auto why = reason(impact.ending, impact.message, scene); !why.empty()) text += "\n" + why;
  if (impact.rest)
    text += fmt::format("\ntip {} stays in the well of adhesion; it would rest {:.4g} nm deep",
                        impact.rest->tip + 1, 1e9 * impact.rest->indentation);
  if (impact.shared_friction)
    text += "\nboth tips stuck at once: statics leaves the friction between them open, the least was taken";
  return text + "\n";
}

std::string what(const impact::TipEvents& event) {
  std::string text;
  const auto add = [&](const std::vector<Index>& tips, const char* words) {
    for (const Index tip : tips) text += fmt::format("{}tip {} {}", text.empty() ? "" : ", ", tip + 1, words);
  };
  add(event.close, "touches");
  add(event.push, "is pushed");
  add(event.pull, "is pulled");
  add(event.stick, "sticks");
  add(event.slip, "slips");
  add(event.open, "separates");
  add(event.capture, "is captured");
  return text;
}

std::string events(const impact::MicrobodyImpact& impact, const Display& time) {
  const auto row = [&](Index i) -> TableRow {
    const auto& event = impact.events[static_cast<std::size_t>(i)];
    return {shown(time, event.time), what(event)};
  };
  return "\nEvents\n" + columns({"time [" + time.unit + "]", "what"}, std::ssize(impact.events), row);
}

std::string motion(const impact::MicrobodyImpact& impact, const model::Microbody& body) {
  const auto start = to_euler(body.attitude), end = to_euler(impact.final.attitude);
  const auto& v = body.velocity;
  const auto& u = impact.final.velocity;
  const auto& w = body.spin;
  const auto& z = impact.final.spin;
  const auto velocity = display_for(std::vector{v.e1, v.e2, v.e3, u.e1, u.e2, u.e3}, "m/s");
  const auto spin = display_for(std::vector{w.e1, w.e2, w.e3, z.e1, z.e2, z.e3}, "rad/s");
  const double before[] = {v.e1, v.e2, v.e3, w.e1, w.e2, w.e3};
  const double after[] = {u.e1, u.e2, u.e3, z.e1, z.e2, z.e3};
  const double tilt_before[] = {start.alpha, start.beta, start.gamma};
  const double tilt_after[] = {end.alpha, end.beta, end.gamma};
  constexpr const char* names[] = {"normal", "along e2", "along e3"};
  constexpr const char* angles[] = {"alpha", "beta", "gamma"};
  const auto row = [&](Index i) -> TableRow {
    if (i >= 6)
      return {fmt::format("{} [deg]", angles[i - 6]), fixed(tilt_before[i - 6] / degree, 8),
              fixed(tilt_after[i - 6] / degree, 8)};
    const auto& display = i < 3 ? velocity : spin;
    return {fmt::format("{} {} [{}]", i < 3 ? "velocity" : "spin", names[i % 3], display.unit),
            shown(display, before[i]), shown(display, after[i])};
  };
  return "\nMass centre\n" + columns({"", "before", "after"}, 9, row);
}

std::string impacts(const impact::MicrobodyImpact& impact, const Display& time) {
  const auto row = [&](Index i) -> TableRow {
    const auto& one = impact.impacts[static_cast<std::size_t>(i)];
    return {fmt::format("{}", one.tip + 1),
            shown(time, one.start),
            one.end ? shown(time, *one.end) : "",
            rounded(one.normal_velocity_in, 8),
            one.end ? rounded(one.normal_velocity_out, 8) : "",
            rounded(1e6 * one.peak_force, 6),
            rounded(1e9 * one.peak_indentation, 6)};
  };
  return "\nImpacts\n" + columns({"tip", "from [" + time.unit + "]", "to [" + time.unit + "]",
                                  "ṅ before [m/s]", "ṅ after [m/s]", "peak force [µN]", "indentation [nm]"},
                                 std::ssize(impact.impacts), row);
}

std::string restitution(const impact::MicrobodyImpact& impact) {
  if (!impact::has_restitution(impact)) return "";
  const auto& e = impact.restitution;
  return "\nRestitution\n" + line("tip", fixed(e.tip, 10)) + line("mass centre", fixed(e.centre, 10));
}

constexpr BalanceLine microbody_energies[] = {{"before", "energy.initial"},
                                              {"work of gravity", "energy.work", true},
                                              {"kinetic after", "energy.final"},
                                              {"stored in contacts", "energy.stored", true},
                                              {"dissipated", "energy.dissipated"},
                                              {"  by Hertz damping", "energy.hertz_damping"},
                                              {"  by adhesion damping", "energy.adhesion_damping"},
                                              {"  by friction", "energy.friction"}};

/// What damped tips would do if they were spheres of the body's mass that strike head on.
std::string restitutions(const model::Microbody& body) {
  const auto damped = [](const contact::BrachDunn& law) {
    return law.damping_hertz > 0 || law.damping_adhesion > 0;
  };
  if (std::none_of(body.law.begin(), body.law.end(), damped)) return "";
  return restitution_table("tip", std::ssize(body.law), -body.velocity.e1, [&](Index i, double speed) {
    return scene::restitution(body.law[i], body.body.tips[i].radius,
                              {.reduced_mass = body.body.mass, .speed = speed});
  });
}

}  // namespace

std::string table(const impact::MicrobodyImpact& impact, const scene::Scene& scene, Detail detail) {
  const auto time = display_for(std::vector{impact.final.time}, "s");
  return heading(scene.title.empty() ? "Microbody on a plane" : scene.title) + summary(impact, scene, time) +
         events(impact, time) + motion(impact, std::get<model::Microbody>(scene.model)) +
         restitution(impact) + impacts(impact, time) +
         balance_table("Energy", impact, microbody_energies, "energy.residual") +
         (detail == Detail::full ? background(impact, "tip") : "");
}

std::string table_of_body(const model::Microbody& body, const scene::Scene& scene) {
  const auto angles = to_euler(body.attitude);
  const auto three = [](const Vector3& v) {
    return rounded(v.e1, 10) + ", " + rounded(v.e2, 10) + ", " + rounded(v.e3, 10);
  };
  std::string text = (scene.title.empty() ? "Microbody" : scene.title) + "\n";
  text += fmt::format("mass {:.10g} kg · moments of inertia {} kg m²\n", body.body.mass,
                      three(body.body.inertia));
  const auto row = [&](Index i) -> TableRow {
    const auto& tip = body.body.tips[static_cast<std::size_t>(i)];
    const auto& law = body.law[static_cast<std::size_t>(i)];
    return {fmt::format("{}", i + 1),        three(tip.centre),         rounded(tip.radius, 10),
            rounded(law.stiffness, 10),      rounded(law.adhesion, 10), rounded(law.damping_hertz, 8),
            rounded(law.damping_adhesion, 8)};
  };
  text += "\n" + columns({"tip", "centre [m]", "radius [m]", "√r K [N/m^1.5]", "2πf₀√r [N/m^0.5]",
                          "C_H [s/m]", "C_A [s/m]"},
                         std::ssize(body.body.tips), row);
  text += restitutions(body);
  text += fmt::format("\nvelocity {} m/s · spin {} rad/s\n", three(body.velocity), three(body.spin));
  text += fmt::format("angles {} deg · friction {:.10g} · gravity {:.10g} m/s²\n",
                      three({angles.alpha / degree, angles.beta / degree, angles.gamma / degree}),
                      body.friction.coefficient, body.gravity);
  return text + fmt::format("impacts {} · accuracy {:.3g} · flow {}\n", body.impacts, scene.run.accuracy,
                            flow::name(scene.run.flow));
}

}  // namespace mariotte::report
