#define BOOST_TEST_MODULE scene_restitution
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/scene/restitution.hpp"
#include "mariotte/scene/scene.hpp"

using namespace mariotte;

namespace {

model::Chain chain_of(const std::string& text) {
  return std::get<model::Chain>(scene::parse("[chain]\n" + text, "s.toml").model);
}

/// (v₂⁺ − v₁⁺)/(v₁⁻ − v₂⁻) of a pair.
double restitution_of(const model::Chain& pair) {
  const auto after = impact::simulate(pair).velocity;
  return (after[1] - after[0]) / (pair.velocity[0] - pair.velocity[1]);
}

std::string rejection(const std::string& text) {
  try {
    scene::parse(text, "s.toml");
    return "accepted";
  } catch (const scene::SceneError& error) {
    return error.what();
  }
}

bool has(const std::string& text, const std::string& part) {
  BOOST_TEST_INFO(text);
  return text.find(part) != std::string::npos;
}

/// Of a linear spring and dashpot with damping ratio ζ < 1 that lets go where the force ends: the contact
/// lasts t = (π − arg(1 − 2ζ² + 2iζω))/ω with ω = √(1−ζ²), and e = exp(−ζ t) [Schwager & Pöschel 2007].
double of_dashpot(double zeta) {
  const double omega = std::sqrt(1 - zeta * zeta);
  return std::exp(-zeta * (std::numbers::pi - std::atan2(2 * zeta * omega, 1 - 2 * zeta * zeta)) / omega);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_dashpot_has_the_damping_of_the_closed_form) {
  for (const double e : {0.999, 0.95, 0.8, 0.5, 0.3}) {
    const auto pair = chain_of(
        "mass = [2, 3]\nvelocity = [1.5, -1]\nlaw = 'viscoelastic'\nexponent = 1\n"
        "stiffness = 1e6\nrestitution = " +
        std::to_string(e) + "\n");
    const double zeta = contact::damping(pair.law[0]) / (2 * std::sqrt(1e6 * 1.2));
    BOOST_TEST(of_dashpot(zeta) == e, boost::test_tools::tolerance(1e-11));
  }
}

BOOST_AUTO_TEST_CASE(hunt_and_crossleys_law_has_the_damping_of_its_equation) {
  // a v (1 + e) = ln[(1 + a v)/(1 − a e v)]
  const auto pair = chain_of(
      "mass = [1, 1]\nvelocity = [2, 0]\nlaw = 'hunt-crossley'\nstiffness = 1e9\nrestitution = 0.7\n");
  const double av = 2 * contact::parameters(pair.law[0])[1].value;
  BOOST_TEST(av * 1.7 == std::log((1 + av) / (1 - 0.7 * av)), boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(a_pair_has_the_restitution_that_was_asked_for) {
  for (const char* law : {"law = 'viscoelastic'\n", "law = 'viscoelastic'\nexponent = 2.5\n",
                          "law = 'hunt-crossley'\n", "law = 'viscoelastic'\nexponent = 1\n"})
    for (const char* bodies :
         {"mass = [1, 3]\nvelocity = [1, -0.5]\n", "mass = [0.1, inf]\nvelocity = [20, 0]\n"})
      BOOST_TEST(restitution_of(
                     chain_of(std::string(law) + bodies + "stiffness = 1e8\nrestitution = 0.85\n")) == 0.85,
                 boost::test_tools::tolerance(1e-9));
}

// Hunt and Crossley's tends to 1/(a v) [its equation], the others to 0 faster. Runs of these know e to 1e-12
// of the speed, and so does the damping.
BOOST_AUTO_TEST_CASE(every_law_reaches_small_restitutions) {
  const std::string pair = "mass = [1, 1]\nvelocity = [1, 0]\nstiffness = 1\nrestitution = ";
  for (const char* law : {"hunt-crossley'", "kelvin-voigt'", "kuwabara-kono'", "tsuji'",
                          "viscoelastic'\nexponent = 3", "viscoelastic'\nexponent = 8"})
    for (const char* e : {"1e-4", "1e-6"}) BOOST_TEST_CONTEXT(law << " " << e) {
        const auto chain = chain_of(pair + e + "\nlaw = '" + law + "\n");
        const auto after = impact::simulate(chain, {.accuracy = 1e-12}).velocity;
        BOOST_TEST(std::abs(after[1] - after[0] - std::stod(e)) < 2e-12);
      }
  const auto grown = chain_of(pair + "1e-9\nlaw = 'hunt-crossley'\n");
  BOOST_TEST(contact::parameters(grown.law[0])[1].value == 1e9, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(at_says_the_speed_that_it_is_meant_for) {
  const std::string text =
      "mass = [1, 1]\nlaw = 'viscoelastic'\nstiffness = 1e8\nrestitution = 0.9\nat = '3 m/s'\n";
  BOOST_TEST(restitution_of(chain_of(text + "velocity = [3, 0]\n")) == 0.9,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(restitution_of(chain_of(text + "velocity = [1, 0]\n")) >
             0.91);  // for n = 3/2 it falls with the speed
}

BOOST_AUTO_TEST_CASE(each_contact_has_its_own_bodies_and_value) {
  const auto chain = chain_of(
      "mass = [1, 2, 4]\nvelocity = [1, 0, 0]\nlaw = 'viscoelastic'\nstiffness = 1e8\nrestitution = [0.9, "
      "0.6]\n");
  for (Index j = 0; j < 2; ++j)
    BOOST_TEST(scene::restitution(chain.law[j], {.reduced_mass = scene::reduced_mass(chain, j),
                                                 .speed = 1}) == (j == 0 ? 0.9 : 0.6),
               boost::test_tools::tolerance(1e-9));
  const auto mixed = chain_of(
      "mass = [1, 2, 4]\nvelocity = [1, 0, 0]\nlaw = 'viscoelastic'\nstiffness = 1e8\n"
      "damping = 7\n[[chain.contact]]\n[[chain.contact]]\nrestitution = 1\n");
  BOOST_TEST(contact::damping(mixed.law[0]) == 7);
  BOOST_TEST(contact::damping(mixed.law[1]) == 0);
}

BOOST_AUTO_TEST_CASE(balls_of_a_network_have_it_along_their_centres) {
  const auto scene = scene::parse(
      "[network]\nradius = 1\nmass = 2\nlaw = 'viscoelastic'\nstiffness = 1e6\nrestitution = 0.75\n"
      "[[network.ball]]\nposition = [0, 0]\nvelocity = [3, 4]\n"
      "[[network.ball]]\nposition = [2, 0]\n",
      "s.toml");
  const auto after = impact::simulate(std::get<model::Network>(scene.model)).velocity;
  BOOST_TEST((after[2] - after[0]) / 3 == 0.75, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(a_direction_of_a_network_has_its_reduced_mass) {
  const auto scene = scene::parse(
      "[network]\nmass = [5, 0.0208]\nvelocity = [-0.1, 1]\nlaw = 'viscoelastic'\nexponent = 1\n"
      "stiffness = 1e9\nrestitution = 0.8\n[[network.contact]]\ndirection = [1, -0.1]\n",
      "s.toml");
  const auto& network = std::get<model::Network>(scene.model);
  const auto after = impact::simulate(network).velocity;
  BOOST_TEST((after[0] - 0.1 * after[1]) / 0.2 == 0.8, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(a_sphere_on_a_plane_has_it_beside_its_adhesion) {
  const auto scene = scene::parse(
      "[body]\nshape = 'sphere'\nradius = '2.45 um'\ndensity = 1350\n[surface]\nlaw = 'brach-dunn'\n"
      "stiffness = '1.74 GPa'\nwork_of_adhesion = 0.38\nzeta_adhesion = 0.5\nrestitution = 0.8\n"
      "[incidence]\nnormal_speed = 5\n",
      "s.toml");
  const auto& body = std::get<model::Microbody>(scene.model);
  BOOST_TEST(body.law[0].damping_hertz > 0);
  BOOST_TEST(impact::simulate(body).restitution.tip == 0.8, boost::test_tools::tolerance(1e-9));
}

// Without adhesion it is Hunt and Crossley's law, with e ~ 1/(C_H v).
BOOST_AUTO_TEST_CASE(a_sphere_on_a_plane_reaches_small_restitutions) {
  const auto scene = scene::parse(
      "[body]\nshape = 'sphere'\nradius = '2.45 um'\ndensity = 1350\n[surface]\nlaw = 'brach-dunn'\n"
      "stiffness = '1.74 GPa'\nwork_of_adhesion = 0\nrestitution = 1e-4\n[incidence]\nnormal_speed = 5\n",
      "s.toml");
  const auto& body = std::get<model::Microbody>(scene.model);
  BOOST_TEST(5 * body.law[0].damping_hertz == 1e4,
             boost::test_tools::tolerance(1e-7));  // runs know e to 1e-12
  BOOST_TEST(std::abs(impact::simulate(body).restitution.tip - 1e-4) < 1e-10);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused_at_its_place) {
  const std::string pair = "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nstiffness = 1\n";
  const std::string damped = pair + "law = 'viscoelastic'\n";
  BOOST_TEST(
      has(rejection(damped + "restitution = 1.2\n"), "s.toml:6:15: chain.restitution: must not be above 1"));
  BOOST_TEST(has(rejection(damped + "restitution = 0\n"), "must be positive"));
  BOOST_TEST(has(rejection(damped + "restitution = 0.5\ndamping = 1\n"), "'damping' is given, too"));
  BOOST_TEST(has(rejection(pair + "law = 'hertz'\nrestitution = 0.5\n"), "law 'hertz' has no damping"));
  const std::string of_all = "law = 'viscoelastic'\ndamping = 1\n",
                    own = "[[chain.contact]]\nlaw = 'hertz'\n";
  BOOST_TEST(has(rejection(pair + of_all + own),
                 "'hertz' of contact 1 has no damping; give that contact damping = 0, or take viscoelastic"));
  BOOST_TEST(rejection(pair + of_all + own + "damping = 0\n") == "accepted");
  BOOST_TEST(
      has(rejection("[chain]\nmass = [1, 1]\nstiffness = 1\nlaw = 'viscoelastic'\nrestitution = 0.5\n"),
          "needs 'at'"));
  BOOST_TEST(
      has(rejection(damped + "exponent = 1e300\nrestitution = 0.5\n"), "s.toml:7:15: chain.restitution: "));
  BOOST_TEST(has(rejection(damped), "needs a damping, or a restitution"));
  BOOST_TEST(has(rejection(pair + "law = 'hunt-crossley'\nrestitution = 1e-13\n"),
                 "has no damping that double precision can carry"));
  BOOST_TEST(has(rejection("[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = 'jkr'\neffective_modulus = 1\n"
                           "effective_radius = 1\nwork_of_adhesion = 0.1\nrestitution = 0.99\n"),
                 "is more than is left without damping"));
  BOOST_TEST(has(rejection(damped + "damping = 1\nat = 1\n"), "has no effect without 'restitution'"));
}
