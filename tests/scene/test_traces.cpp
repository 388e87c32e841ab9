// Samples of runs for pictures: they reach the end, show jumps of forces, and miss no peak.
#define BOOST_TEST_MODULE scene traces
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/scene/scene.hpp"

using namespace mariotte;

namespace {

constexpr std::size_t most_rows = 20000;

impact::BodiesImpact run_bodies(const std::string& name, double until) {
  auto scene = scene::read(MARIOTTE_SCENES "/" + name + ".toml");
  scene.run.max_time = until;
  return impact::simulate(std::get<model::Bodies>(scene.model), scene.run, {.trace = true});
}

/// ∫ f dt of a column of a trace, and the impulse that it must be.
void check_impulse(const impact::Trace& trace, std::size_t contact, double impulse) {
  double sum = 0;
  for (std::size_t i = 1; i < trace.time.size(); ++i)
    sum +=
        0.5 * (trace.time[i] - trace.time[i - 1]) * (trace.force[i - 1][contact] + trace.force[i][contact]);
  BOOST_TEST(std::abs(sum - impulse) < 1e-3 * impulse);
}

template <class Model>
auto traced(const std::string& text) {
  const auto scene = scene::parse(text, "t.toml");
  return impact::simulate(std::get<Model>(scene.model), scene.run, {.trace = true});
}

}  // namespace

BOOST_AUTO_TEST_CASE(traces_of_long_runs_reach_their_end) {
  const auto impact = run_bodies("settling_column", 1);
  const auto& trace = impact.trace;
  BOOST_TEST(trace.time.size() > most_rows / 2);
  BOOST_TEST(trace.time.size() <= most_rows);
  BOOST_TEST(trace.time.front() == 0);
  BOOST_TEST(trace.time.back() == impact.time);
  for (std::size_t i = 0; i < impact.body.size(); ++i)
    BOOST_TEST(norm(trace.body.back()[i].velocity - impact.body[i].velocity) < 1e-12);
  for (const auto rows :
       {trace.body.size(), trace.gap.size(), trace.force.size(), trace.friction.size(), trace.slip.size()})
    BOOST_TEST(rows == trace.time.size());
}

BOOST_AUTO_TEST_CASE(traces_of_long_runs_of_a_microbody_reach_their_end) {
  const auto impact = traced<model::Microbody>(R"(
[body]
shape   = "custom"
radius  = "4.067 um"
mass    = 1e-13
inertia = [1e-25, 2e-25, 3e-25]
density = 1350
tips    = [{ centre = [-3e-6, 1e-6, 0.5e-6] }, { centre = [3e-6, -1e-6, 0] }]
[surface]
stiffness        = "1.74 GPa"
work_of_adhesion = 0.206
zeta_hertz       = 0.03
zeta_adhesion    = 0.20
friction         = 0.13
[incidence]
normal_speed        = 5.07
tangential_velocity = [0.35, 0.10]
angles              = [-0.32, 0.59, 0.00]
spin                = [41312.6, 39020.3, 129271]
[run]
impacts = 1
until   = "20 us"
)");
  const auto& state = impact.trace.state;
  BOOST_TEST(state.size() > most_rows / 2);
  BOOST_TEST(state.size() <= most_rows);
  BOOST_TEST(state.back().time == impact.final.time);
}

BOOST_AUTO_TEST_CASE(times_of_traces_never_fall) {
  for (const char* name : {"rack_break", "coin", "rocking_with_friction"}) {
    const auto impact = run_bodies(name, 0.05);
    BOOST_TEST(std::is_sorted(impact.trace.time.begin(), impact.trace.time.end()));
  }
}

BOOST_AUTO_TEST_CASE(forces_that_jump_have_a_row_on_either_side) {
  const std::string damped = "law = 'kelvin-voigt'\nstiffness = 1\ndamping = 0.5\n",
                    adhesive =
                        "law = 'dmt'\neffective_modulus = 1\neffective_radius = 1\n"
                        "work_of_adhesion = 0.01\n";
  for (const auto& law : {damped, adhesive}) {
    const auto row =
        traced<model::Chain>("[chain]\nmass = [1, 1, 1]\nvelocity = [1, 0, 0]\ngap = [0.1, 4]\n" + law);
    for (std::size_t j = 0; j < 2; ++j) check_impulse(row.trace, j, row.contacts[j].impulse);
  }
  const auto network = traced<model::Network>(
      "[network]\nmass = 1\nradius = 0.5\nreach = 0.2\n" + damped +
      "[[network.ball]]\nposition = [0, 0]\nvelocity = [1, 0]\n[[network.ball]]\nposition = [1.1, 0]\n");
  check_impulse(network.trace, 0, network.contacts[0].impulse);
}

BOOST_AUTO_TEST_CASE(peaks_of_bodies_are_no_less_than_their_samples) {
  const auto impact = run_bodies("rack_break", infinity);
  for (const auto& one : impact.contacts)
    for (std::size_t i = 0; i < impact.trace.time.size(); ++i) {
      BOOST_TEST(impact.trace.force[i][one.contact] <= (1 + 1e-9) * one.peak_force);
      BOOST_TEST(norm(impact.trace.friction[i][one.contact]) <= (1 + 1e-9) * one.peak_friction);
    }
}
