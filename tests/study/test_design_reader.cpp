#define BOOST_TEST_MODULE study_design_reader
#include <boost/test/unit_test.hpp>

#include "mariotte/study/sweep/sweep_reader.hpp"
#include "study/sweep_scenes.hpp"

using namespace mariotte;

namespace {

/// What is said of a scene of three balls, whose text has 10 lines, with this after it.
std::string rejection(const std::string& sweeps, const std::string& scene = test::three_balls) {
  try {
    study::read_sweep(scene::parse_document(scene + "[[sweep]]\n" + sweeps, "s.toml"));
  } catch (const scene::SceneError& error) {
    return error.what();
  }
  return "accepted";
}

void expect(const std::string& sweeps, const std::string& place, const std::string& part) {
  const auto what = rejection(sweeps);
  BOOST_TEST(what.starts_with("s.toml:" + place + ": "), what);
  BOOST_TEST(what.find(part) != std::string::npos, what);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_key_that_is_nothing_is_rejected_where_it_is_written) {
  expect("key = 'chain.velocty[0]'\nvalues = [1]", "11:7", "has no 'chain.velocty'");
  expect("key = 'chain.stifness'\nvalues = [1]", "11:7", "did you mean 'stiffness'");
  expect("key = 'chain.velocity[3]'\nvalues = [1]", "11:7", "no element 3");
  expect("key = 'chain.velocity[0'\nvalues = [1]", "11:7", "cannot read the key");
  expect("key = 'sweep[0].from'\nvalues = [1]", "11:7", "cannot be varied");
}

BOOST_AUTO_TEST_CASE(a_unit_is_checked_against_its_key_where_it_is_written) {
  expect("key = 'chain.velocity[0]'\nvalues = [1, '1 kg']", "12:14", "expected a velocity (m/s), got 'kg'");
  expect("key = 'chain.mass[0]'\nfrom = '1 kg'\nto = '2 m'\ncount = 2", "13:6", "expected a mass (kg)");
  expect("key = 'chain.mass[0]'\nfrom = 1\nto = 2\nstep = '1 m'", "14:8", "expected a mass (kg)");
  expect("key = 'chain.contact[0].stiffness'\nvalues = ['1 N/m']", "12:11", "N/m^1.5");
}

BOOST_AUTO_TEST_CASE(a_frequency_counts_periods_and_an_angle_has_a_unit) {
  const std::string driven =
      "[chain]\nmass = [1, 1]\nlaw = 'hertz'\nstiffness = 1\nwall = 'left'\n[chain.drive]\nend = 'left'\n"
      "quantity = 'velocity'\nsignal = 'sine'\namplitude = 0.1\nfrequency = 2\nphase = 0\n[run]\nuntil = 1\n";
  const auto unit_of = [&](const std::string& sweep) {
    const auto document = scene::parse_document(driven + "[[sweep]]\n" + sweep, "s.toml");
    return study::read_sweep(document).design.parameters.at(0).unit;
  };
  BOOST_TEST(unit_of("key = 'chain.drive.frequency'\nvalues = [1, '2 Hz']\n") == "Hz");
  BOOST_TEST(unit_of("key = 'chain.drive.phase'\nvalues = [0, '90 deg']\n") == "rad");
}

BOOST_AUTO_TEST_CASE(a_value_no_scene_can_have_is_rejected_where_it_is_written) {
  expect("key = 'chain.mass[0]'\nfrom = -1\nto = 2\ncount = 4", "12:8", "must be positive");
  expect("key = 'chain.gap'\nvalues = [0, 1, -1]", "12:17", "must not be negative");
  expect("key = 'run.accuracy'\nvalues = [1e-6, 2]", "12:17", "must be between 0 and 1");
  expect("key = 'chain.contact[0].law'\nvalues = ['herz']", "12:11", "did you mean 'hertz'");
}

BOOST_AUTO_TEST_CASE(a_range_that_leads_nowhere_is_rejected) {
  expect("key = 'chain.velocity[0]'\nfrom = 0\nto = 1\nstep = -0.1", "14:8", "does not lead");
  expect("key = 'chain.velocity[0]'\nfrom = 0\nto = 1\nstep = 0", "14:8", "too many");
  expect("key = 'chain.mass[0]'\nfrom = -1\nto = 1\ncount = 3\nscale = 'log'", "12:8", "same sign");
  expect("key = 'chain.mass[0]'\nfrom = 1\nto = 2\nstep = 0.5\nscale = 'log'", "14:8", "log");
  expect("key = 'chain.contact[0].law'\nfrom = 1\nto = 2\ncount = 3", "12:8", "expected a string");
  expect("key = 'chain.velocity[0]'\nfrom = 0\nto = inf\ncount = 3", "13:6", "must be finite");
}

BOOST_AUTO_TEST_CASE(tables_that_do_not_fit_together_are_rejected) {
  expect("key = 'chain.mass[0]'\nvalues = [1, 2]\nzip = true", "13:7", "no table before");
  expect("key = 'chain.mass[0]'\nvalues = [1]\n[[sweep]]\nkey = 'chain.mass[0]'\nvalues = [2]", "14:7",
         "twice");
  expect("key = 'chain.mass[0]'\nvalues = [1, 2]\n[[sweep]]\nkey = 'chain.mass[1]'\nvalues = [2]\nzip = true",
         "13:1", "has 1 value, the table it goes along with 2");
  const std::string huge = "from = 1\nto = 2\ncount = 1000000000\n";
  expect("key = 'chain.mass[0]'\n" + huge + "[[sweep]]\nkey = 'chain.mass[1]'\n" + huge, "10:1",
         "too many points");
}

BOOST_AUTO_TEST_CASE(random_goes_with_from_to_and_count_only) {
  expect("key = 'chain.mass[0]'\nfrom = 1\nto = 2\nstep = 0.1\nrandom = 1", "14:8", "random");
  expect("key = 'chain.mass[0]'\nvalues = [1]\nrandom = 1", "13:10", "does not go with 'values'");
  expect("key = 'chain.mass[0]'\nfrom = 1\nto = 2\ncount = 2\nrandom = -1", "15:10", "must be between 0 and");
}

BOOST_AUTO_TEST_CASE(a_unit_that_depends_on_another_varied_key_is_rejected) {
  const std::string viscous =
      "[chain]\nmass=[1,1]\nvelocity=[1,0]\nlaw='viscoelastic'\ndamping=0\nstiffness=1\n";
  const auto what = rejection(
      "key='chain.exponent'\nvalues=[1.5, 2]\n[[sweep]]\nkey='chain.stiffness'\nvalues=[1,2]", viscous);
  BOOST_TEST(what.find("depends on another key that is varied") != std::string::npos, what);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_only_in_some_company_is_left_to_the_rows) {
  BOOST_TEST(
      rejection(
          "key='chain.precompressed'\nvalues=[false, true]\n[[sweep]]\nkey='chain.gap'\nvalues=[0, -0.1]") ==
      "accepted");
}

BOOST_AUTO_TEST_CASE(a_scene_without_a_table_is_told_so) {
  BOOST_CHECK_EXCEPTION(
      study::read_sweep(scene::parse_document(test::three_balls, "s.toml")), scene::SceneError,
      [](const auto& e) { return std::string(e.what()).find("no [[sweep]]") != std::string::npos; });
}

BOOST_AUTO_TEST_CASE(columns_of_the_scene_are_checked_where_they_are_written) {
  const std::string sweeps = "key = 'chain.mass[0]'\nvalues = [1, 2]\n";
  const auto what = rejection(sweeps, "columns = ['icr[0]', 'final.velocty[0]']\n" + test::three_balls);
  BOOST_TEST(what.starts_with("s.toml:1:22: "), what);
  BOOST_TEST(what.find("did you mean 'final.velocity[0]'") != std::string::npos, what);
}

BOOST_AUTO_TEST_CASE(a_key_the_scene_lacks_is_made) {
  auto plan = study::read_sweep(scene::parse_document(
      test::steel_balls + "[[sweep]]\nkey = 'run.accuracy'\nvalues = [1e-6, 1e-8]\n", "s.toml"));
  BOOST_TEST(resolve(plan.document).run.accuracy == 1e-6);
}
