// What a run says of the limits of its model, every command says that makes runs.
#define BOOST_TEST_MODULE command_limits
#include <boost/test/unit_test.hpp>

#include "session.hpp"

using support::has;
using support::Outcome;
using support::Session;
using Json = nlohmann::json;

namespace {

const std::string beads = MARIOTTE_SCENES "/measured_restitution.toml --set chain.material=polystyrene ";
const std::string too_fast = beads + "--set chain.velocity[0]=5e3 ";
constexpr const char* deep = "contact 1 is indented by 4.02324 times the radius of its body; no contact law";
constexpr const char* strains = "max a/R = ";

bool is_refused_as_invalid(const Outcome& run) {
  return run.code == 4 && has(run.err, deep) && has(run.err, "[R004]") && has(run.err, strains);
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(slopes_and_deviations_of_what_no_law_describes_are_invalid, Session) {
  const auto slopes = mariotte("sensitivity " + too_fast + "--to velocity");
  BOOST_TEST(is_refused_as_invalid(slopes), slopes.err);
  BOOST_TEST(has(slopes.out, "invalid · slopes by 2 parameters"));
  BOOST_TEST(is_refused_as_invalid(mariotte("sensitivity " + too_fast + "--set run.until=1 --to mass")));
  const auto deviations = mariotte("uncertainty " + beads + "--set 'chain.velocity[0]=5 km/s ± 1 %' --json");
  BOOST_TEST(is_refused_as_invalid(deviations), deviations.err);
  BOOST_TEST(Json::parse(deviations.out)["ending"] == "invalid");
}

BOOST_FIXTURE_TEST_CASE(laws_and_curves_of_what_no_law_describes_are_invalid, Session) {
  const auto law = mariotte("law " + too_fast);
  BOOST_TEST(is_refused_as_invalid(law), law.err);
  const auto curve = mariotte("restitution " + beads + "--from 1 --to 5e3 --count 3");
  BOOST_TEST(is_refused_as_invalid(curve), curve.err);
  BOOST_TEST(has(curve.err, "warning: at 5000 m/s: contact 1: max a/R = "));
}

BOOST_FIXTURE_TEST_CASE(fits_of_what_no_law_describes_are_invalid, Session) {
  write("fast.csv", "speed,restitution\n4900,0.9\n5000,0.9\n5100,0.9\n");
  const auto fit = mariotte("fit " MARIOTTE_SCENES "/sphere_fit.toml fast.csv --free surface.zeta_hertz");
  BOOST_TEST(fit.code == 4);
  BOOST_TEST(has(fit.err, "at 2 of 2 measurements that were looked at, a contact is deeper than any law"));
  BOOST_TEST(has(fit.err, "[R004]"));
}

BOOST_FIXTURE_TEST_CASE(warnings_of_a_run_come_with_what_is_made_of_it, Session) {
  const std::string sphere = MARIOTTE_SCENES "/microsphere.toml ";
  for (const auto& line :
       {std::string("sensitivity ") + sphere, "sensitivity " + sphere + "--of capture_velocity",
        "capture " + sphere, "uncertainty " + sphere + "--set 'body.radius=2.45 um ± 1 %'"}) {
    const auto run = mariotte(line);
    BOOST_TEST(run.code == 0, line);
    BOOST_TEST(has(run.err, "adhesion alone strains the tip too much"), line);
    BOOST_TEST(mariotte(line + " -q").err == "", line);
  }
  const auto rod = mariotte("law " MARIOTTE_SCENES "/thrown_rod.toml");
  BOOST_TEST(rod.code == 0);
  BOOST_TEST(has(rod.err, "max p₀/1.6Y = "));
  const auto fit = mariotte("fit " MARIOTTE_SCENES "/sphere_fit.toml " MARIOTTE_SCENES "/sphere_fit.csv");
  BOOST_TEST(fit.code == 0);
  BOOST_TEST(has(fit.err, "at 3 of 3 measurements that were looked at, max a/R is above 0.1"));
}
