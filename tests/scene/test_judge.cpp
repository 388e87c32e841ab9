#define BOOST_TEST_MODULE scene_judge
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/contact/limits.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/impact/shallow.hpp"
#include "mariotte/report/text.hpp"
#include "mariotte/report/warnings.hpp"
#include "mariotte/scene/judge.hpp"
#include "mariotte/scene/simulate.hpp"
#include "mariotte/study/sweep/columns.hpp"
#include "mariotte/study/sweep/evaluate.hpp"

using namespace mariotte;
using boost::test_tools::tolerance;

namespace {

/// Two balls of 10 mm, or a pair of other size and material.
std::string pair(const std::string& speed, const std::string& material = "'steel'") {
  return "[chain]\nradius = 5e-3\nmaterial = " + material + "\nvelocity = ['" + speed +
         "', 0]\nlaw = 'hertz'\n";
}

impact::ChainImpact run(const std::string& text) {
  return std::get<impact::ChainImpact>(simulate(scene::parse(text, "s.toml")));
}

bool has(const std::string& text, const std::string& part) {
  BOOST_TEST_INFO(text);
  return text.find(part) != std::string::npos;
}

std::string all_warnings(const impact::ContactImpact& impact) {
  std::string text;
  for (const auto& one : report::warnings(impact, {})) text += one + "\n";
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_gentle_impact_is_within_all_limits) {
  const auto impact = run(pair("0.1 m/s"));
  const auto& validity = impact.validity;
  BOOST_TEST(all_warnings(impact) == "");
  BOOST_TEST(validity.yield_ratio.has_value());
  BOOST_TEST(validity.contact_time_ratio.has_value());
}

BOOST_AUTO_TEST_CASE(first_yield_speed_is_where_the_pressure_reaches_its_limit) {
  const double speed = run(pair("0.1 m/s")).validity.first_yield_speed->value;
  const auto at_limit = run(pair(std::to_string(speed) + " m/s")).validity;
  BOOST_TEST(at_limit.yield_ratio->value == 1.0, tolerance(1e-5));  // of a speed written with six decimals
  BOOST_TEST(at_limit.peak_pressure->value == contact::first_yield * 2.03e9, tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(fast_steel_balls_yield_and_ring) {
  const auto impact = run(pair("500 m/s"));
  const auto text = all_warnings(impact);
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  for (const char* part : {"contact 1: max a/R = ", "max p₀/1.6Y = ", "min t_c/t_w = ", "is below 5"})
    BOOST_TEST(has(text, part), part);
  const auto json = report::json_text(impact, scene::parse(pair("500 m/s"), "s.toml"));
  BOOST_TEST(has(json, "\"warnings\""));
}

BOOST_AUTO_TEST_CASE(results_say_that_an_accuracy_was_not_reached) {
  auto impact = run(pair("0.1 m/s"));
  impact.estimated_accuracy = 3e-5;
  BOOST_TEST(
      has(all_warnings(impact), "velocities may be wrong by 3.0e-05 of the largest speed, where 1e-10"));
  const auto json = report::json_text(impact, scene::parse(pair("0.1 m/s"), "s.toml"));
  BOOST_TEST(has(json, "may be wrong by 3.0e-05"));
  impact.estimated_accuracy = impact.requested_accuracy;
  BOOST_TEST(all_warnings(impact) == "");
}

BOOST_AUTO_TEST_CASE(results_say_that_the_flow_asked_for_follows_no_contact) {
  const std::string bodies =
      "[bodies]\nlaw = 'hertz'\nstiffness = 1e9\nfriction = 0\n"
      "[[bodies.body]]\nmass = 1\nshape = 'ball'\nradius = 0.01\nposition = [0, 0, 0.011]\n"
      "velocity = [0.5, 0, -1]\n[[bodies.plane]]\nnormal = [0, 0, 1]\n[run]\nflow = ";
  const auto said = [&](const std::string& flow) {
    const auto scene = scene::parse(bodies + flow, "s.toml");
    return report::json_text(std::get<impact::BodiesImpact>(simulate(scene)), scene);
  };
  BOOST_TEST(has(said("'modal'"), "no contact phase of this scene admits flow = \\\"modal\\\": cvode-adams"));
  for (const char* flow : {"'auto'", "'cvode-adams'"}) BOOST_TEST(!has(said(flow), "admits flow"));
}

BOOST_AUTO_TEST_CASE(contact_time_is_that_of_hertz) {
  // t = 2.9432… (m²/(R E*² v))^{1/5}·… in terms of k: t_c = 3.2180 (m²/(k² v))^{1/5} [Johnson 1985, §11.4]
  const auto scene = scene::parse(pair("1 m/s"), "s.toml");
  const auto& chain = std::get<model::Chain>(scene.model);
  const double reduced = chain.mass[0] / 2, stiffness = contact::stiffness(chain.law[0]);
  const double time = 3.2180 * std::pow(reduced * reduced / (stiffness * stiffness), 0.2);
  const double travel = 4 * 5e-3 * std::sqrt(7830 / 203e9);
  BOOST_TEST(run(pair("1 m/s")).validity.contact_time_ratio->value == time / travel, tolerance(1e-4));
}

// The wave of four balls is cut off in its second contact, which would last as long as the first.
BOOST_AUTO_TEST_CASE(a_contact_that_is_not_over_has_no_contact_time) {
  const std::string four =
      "[chain]\nradius = 5e-3\nmaterial = 'steel'\nvelocity = [1, 0, 0, 0]\nlaw = 'hertz'\ngap = 1e-6\n";
  const auto whole = run(four), first = run(four + "[run]\nmax_time = 10e-6\n");
  BOOST_TEST(first.contacts[0].periods.size() == 1u);
  BOOST_TEST(!first.validity.contact_time_ratio);
  const double apart = *whole.contacts[0].periods[0].end;
  const auto cut = run(four + "[run]\nmax_time = " + std::to_string(1e6 * apart + 1) + "e-6\n");
  BOOST_TEST(!cut.contacts[1].periods.back().end);
  BOOST_REQUIRE(cut.validity.contact_time_ratio);
  BOOST_TEST(cut.validity.contact_time_ratio->contact == 0);
  BOOST_TEST(cut.validity.contact_time_ratio->value >= whole.validity.contact_time_ratio->value);
}

BOOST_AUTO_TEST_CASE(a_microbody_that_is_still_in_contact_has_no_contact_time) {
  const auto ratio = [](const std::string& limit) {
    const auto scene =
        scene::read(MARIOTTE_SCENES "/microsphere.toml",
                    {"body.material='steel'", "surface.material='steel'", "run.max_time=" + limit});
    return std::get<impact::MicrobodyImpact>(simulate(scene)).validity.contact_time_ratio;
  };
  BOOST_REQUIRE(ratio("1"));
  BOOST_TEST(!ratio("1e-9"));
}

BOOST_AUTO_TEST_CASE(an_indentation_beyond_the_radius_is_refused_by_name) {
  const auto impact = run(pair("5000 m/s", "'polystyrene'"));
  BOOST_TEST((impact.ending == hybrid::Ending::invalid));
  BOOST_TEST(has(impact.message, "contact 1 is indented by"));
  BOOST_TEST(has(impact.message, "times the radius"));
  BOOST_TEST(impact.velocity[1] > 4000);  // what was computed is kept
}

BOOST_AUTO_TEST_CASE(nothing_is_said_of_bodies_without_a_radius) {
  const std::string points = "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = 'hertz'\nstiffness = 1\n";
  const auto validity = run(points).validity;
  for (const auto& one : impact::validity_limits) BOOST_TEST(!(validity.*one.number), one.key);
  BOOST_TEST(!has_validity(scene::parse(points, "s.toml")));
  BOOST_TEST(has_validity(scene::parse(pair("1 m/s"), "s.toml")));
  BOOST_TEST(has_validity(scene::read(MARIOTTE_SCENES "/microsphere.toml")));
}

BOOST_AUTO_TEST_CASE(a_linear_spring_has_an_indentation_but_no_pressure) {
  const auto validity =
      run("[chain]\nmass = [1, 1]\nradius = 1\nvelocity = [1, 0]\nlaw = 'linear'\nstiffness = 50\n").validity;
  BOOST_TEST(validity.indentation_ratio->value == 0.1, tolerance(1e-9));  // v √(m/2k)
  BOOST_TEST(!validity.peak_pressure);
}

BOOST_AUTO_TEST_CASE(the_worst_contact_is_named) {
  const auto validity = run("[chain]\nballs = 3\nradius = 1e-2\nmaterial = 'steel'\nvelocity = [9, 0, "
                            "0]\nstiffness = [1e10, 1e8]\n"
                            "law = 'hertz'\ngap = [0, 1e-3]\n")
                            .validity;
  BOOST_TEST(validity.contact_radius_ratio->contact == 1);
}

BOOST_AUTO_TEST_CASE(laws_that_adhere_are_judged_as_hertz_is_and_by_adhesion) {
  const auto of = [](const std::string& law, const char* diameter) {
    return run(std::string("[chain]\nballs = 1\nwall = 'right'\ngap = 1e-7\nmaterial = 'polystyrene'\n") +
               "wall_material = 'fused-silica'\nvelocity = 20\ndiameter = '" + diameter + "'\nlaw = " + law)
        .validity;
  };
  const auto hertz = of("'hertz'", "5 um");
  BOOST_TEST(!hertz.tabor_number);
  BOOST_TEST(hertz.yield_ratio->value > 1);
  for (const std::string law : {"jkr", "dmt", "brach-dunn"}) BOOST_TEST_CONTEXT(law) {
      const auto sticky = of("'" + law + "'\nwork_of_adhesion = 0.06", "5 um");
      BOOST_TEST(sticky.yield_ratio->value == hertz.yield_ratio->value, tolerance(0.2));
      BOOST_TEST(sticky.tabor_number.has_value() == (law != "dmt"));
    }
  const auto jkr = of("'jkr'\nwork_of_adhesion = 0.06", "5 um"),
             small = of("'jkr'\nwork_of_adhesion = 0.06", "320 nm");
  BOOST_TEST(jkr.tabor_number->value == 2.5 * small.tabor_number->value, tolerance(1e-12));  // ∛(5000/320)
}

BOOST_AUTO_TEST_CASE(balls_in_the_plane_are_judged_as_those_of_a_row) {
  const auto network = std::get<impact::NetworkImpact>(simulate(scene::parse(
      "[network]\nradius = 5e-3\nmaterial = 'steel'\nlaw = 'hertz'\n[[network.ball]]\nposition = [0, 0]\n"
      "velocity = [10, 0]\n[[network.ball]]\nposition = [1e-2, 0]\n",
      "s.toml")));
  const auto row = run(pair("10 m/s"));
  for (const auto& one : impact::validity_limits) {
    const auto a = network.validity.*one.number, b = row.validity.*one.number;
    BOOST_TEST(a.has_value() == b.has_value(), one.key);
    if (a && b) BOOST_TEST(a->value == b->value, tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE(a_microbody_is_judged_by_adhesion_and_damping_too) {
  const auto scene = scene::read(MARIOTTE_SCENES "/microsphere.toml");
  const auto& body = std::get<model::Microbody>(scene.model);
  const auto impact = std::get<impact::MicrobodyImpact>(simulate(scene));
  const auto& law = body.law[0];
  const double radius = body.body.tips[0].radius;
  const auto& v = impact.validity;
  BOOST_TEST(v.contact_radius_ratio->value == std::sqrt(impact.impacts[0].peak_indentation / radius));
  BOOST_TEST(v.adhesion_ratio->value == contact::rest_indentation(law) / radius);
  BOOST_TEST(v.hertz_damping->value == law.damping_hertz * std::abs(impact.impacts[0].normal_velocity_in));
  BOOST_TEST(v.adhesion_damping->value ==
             law.damping_adhesion * std::abs(impact.impacts[0].normal_velocity_in));
  BOOST_TEST(v.tabor_number->value == contact::tabor_number(law, radius));
  BOOST_TEST(v.well_damping->value == contact::well_damping(law, body.body.mass));
}

BOOST_AUTO_TEST_CASE(validity_is_a_column_of_sweeps_and_what_is_invalid_has_no_numbers) {
  double number = 0;
  const auto verdict = [&](const std::string& text) {
    const auto scene = scene::parse(text, "s.toml");
    return study::make_evaluate(study::expand_columns({"validity.yield_ratio"}, scene))(scene, {&number, 1});
  };
  BOOST_TEST(verdict(pair("10 m/s")).has_numbers());
  BOOST_TEST(number == run(pair("10 m/s")).validity.yield_ratio->value, tolerance(1e-12));
  const auto invalid = verdict(pair("50000 m/s"));
  BOOST_TEST(invalid.ending == "invalid");
  BOOST_TEST(!invalid.has_numbers());
  BOOST_TEST(has(invalid.reason, "contact 1"));
}

BOOST_AUTO_TEST_CASE(columns_that_need_no_peaks_are_invalid_as_well) {
  double number = 0;
  for (const char* speed : {"10 m/s", "650 m/s", "5000 m/s", "50000 m/s"}) {
    const auto text = pair(speed, "'polystyrene'");
    const auto scene = scene::parse(text, "s.toml");
    const auto verdict =
        study::make_evaluate(study::expand_columns({"final.velocity[1]"}, scene))(scene, {&number, 1});
    BOOST_TEST(verdict.ending == name(run(text).ending), speed);
  }
}

namespace {

bool shallow(const std::string& text) {
  const auto scene = scene::parse(text, "s.toml");
  return std::visit(Overload{[](const scene::LawAlone&) { return false; },
                             [&](const auto& model) { return stays_shallow(model, scene.touching); }},
                    scene.model);
}

}  // namespace

BOOST_AUTO_TEST_CASE(energy_tells_whether_a_radius_can_be_reached) {
  // ½ (m/2) v² = k R²/2 at the radius, but half of all energy is that of the mass centre
  const auto spring = [](double speed) {
    return "[chain]\nmass = [1, 1]\nradius = 1\nvelocity = [" + std::to_string(speed) +
           ", 0]\nlaw = 'linear'\nstiffness = 50\n";
  };
  BOOST_TEST(shallow(spring(7.07)));
  BOOST_TEST(!shallow(spring(7.08)));
  BOOST_TEST((run(spring(9.99)).ending == hybrid::Ending::separated));
  BOOST_TEST((run(spring(10.01)).ending == hybrid::Ending::invalid));
  BOOST_TEST(!shallow(spring(1) + "gravity = 1\n"));
  BOOST_TEST(
      shallow("[network]\nradius = 1\nmass = 1\nlaw = 'linear'\nstiffness = 50\n[[network.ball]]\n"
              "position = [0, 0]\nvelocity = [7.07, 0]\n[[network.ball]]\nposition = [2, 0]\n"));
  BOOST_TEST(
      !shallow("[network]\nradius = 1\nmass = 1\nlaw = 'linear'\nstiffness = 50\n[[network.ball]]\n"
               "position = [0, 0]\nvelocity = [5, 5.1]\n[[network.ball]]\nposition = [2, 0]\n"));
}

BOOST_AUTO_TEST_CASE(wells_of_adhesion_deepen_an_impact) {
  auto scene = scene::read(MARIOTTE_SCENES "/microsphere.toml");
  auto body = std::get<model::Microbody>(scene.model);
  BOOST_TEST(stays_shallow(body, scene.touching));
  const double radius = body.body.tips[0].radius;
  const double speed = std::sqrt(2 * stored_energy(body.law[0], radius) / body.body.mass);
  body.velocity = {-speed, 0, 0};  // at the radius the well has given its energy back
  BOOST_TEST(!stays_shallow(body, scene.touching));
  body.velocity.e1 *= 0.5;
  BOOST_TEST(stays_shallow(body, scene.touching));
}
