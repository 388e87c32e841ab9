// Slopes of microbodies that random search found wrong. Expected are differences of runs at 10⁻¹³ by two
// flows.
#define BOOST_TEST_MODULE hard slopes
#include <fmt/format.h>

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <optional>
#include <string>

#include "mariotte/study/sensitivity/scene_parameters.hpp"

using namespace mariotte;
using namespace std::string_literals;

namespace {

impact::Sensitivity slopes_of(const std::string& name, const std::string& key,
                              const std::vector<std::string>& set) {
  const auto document = scene::open(fmt::format("{}/body/hard/{}.toml", MARIOTTE_TEST_DATA, name), set);
  return study::sensitivity(document, resolve(document), {key});
}

double slope(const impact::Sensitivity& slopes, const std::string& outcome) {
  for (const auto& one : slopes.outcome)
    if (impact::name_of(one) == outcome) return one.slope.at(0).value();
  throw std::runtime_error("no outcome " + outcome);
}

const auto accuracies = boost::unit_test::data::make({"1e-6", "1e-8", "1e-10"});
const auto flows = boost::unit_test::data::make({"auto", "cvode-adams"});

}  // namespace

/// A tip begins to slip 2·10⁻²¹ s before it lets go, where its force ends as the root of the time left: what
/// that does until then is not rounding in slopes.
BOOST_DATA_TEST_CASE(a_tip_that_slips_as_it_lets_go_has_the_slopes_of_one_that_lets_go, accuracies* flows,
                     accuracy, flow) {
  const auto found = slopes_of("slips_as_it_lets_go", "surface.zeta_hertz",
                               {"run.accuracy="s + accuracy, "run.flow=\""s + flow + "\""});
  BOOST_TEST(std::abs(slope(found, "w2") - 409.936303) < 2e-6);
  BOOST_TEST(std::abs(slope(found, "v3") + 0.0018815885775) < 1e-10);
  BOOST_TEST(found.notes.empty());
}

/// A step ends where the tip has nearly let go. Where that will be, a straight line does not tell well
/// enough.
BOOST_DATA_TEST_CASE(a_force_that_ends_beyond_a_step_is_resolved, accuracies* flows, accuracy, flow) {
  const auto found = slopes_of("ends_beyond_a_step", "body.radius",
                               {"run.accuracy="s + accuracy, "run.flow=\""s + flow + "\""});
  BOOST_TEST(std::abs(slope(found, "normal_velocity") / -3167047.8447 - 1) <
             1e-8 + 0.01 * std::stod(accuracy));
}

/// The tip strikes at a few per cent of the normal speed. Other spins and lengths lift it off, where
/// restitution has a pole. Expected are differences of runs of an integrator written for this alone.
BOOST_AUTO_TEST_CASE(restitution_of_a_tip_that_a_spin_nearly_stops_has_its_slopes) {
  const auto by_length = [](const char* spin) {
    const auto set = {"incidence.spin[1]="s + spin};
    return slope(slopes_of("spin_nearly_stops_the_tip", "body.length_ratio", set), "e_n");
  };
  BOOST_TEST(std::abs(by_length("138600") + 0.01515285) < 2e-8);
  BOOST_TEST(std::abs(by_length("140850") - 0.06708679) < 2e-8);
}

/// Its spring has held since it was pressed, and not since it was noticed. By differences of runs at 10⁻¹³.
BOOST_AUTO_TEST_CASE(a_contact_that_touches_and_sticks_as_it_is_pressed_has_its_slopes) {
  const auto document =
      scene::open(MARIOTTE_TEST_DATA "/bodies/hard/pressed_by_a_damper.toml", {"run.accuracy=1e-10"});
  const auto found = study::sensitivity(document, resolve(document), {"bodies.body[0].spin"});
  BOOST_TEST(std::abs(slope(found, "bodies[0].spin") - 0.9352654659) < 1e-9);
  BOOST_TEST(found.notes.empty());
}

/// A slip comes within 10⁻⁹ of the speed to rest and goes on the other way: more digits are needed than were
/// asked for, and doubles do not have all.
BOOST_DATA_TEST_CASE(a_slip_that_passes_by_rest_says_how_well_its_slopes_are_known, accuracies, accuracy) {
  const auto found = slopes_of("slips_past_rest", "surface.friction", {"run.accuracy="s + accuracy});
  std::optional<double> error;
  for (const auto& note : found.notes)
    if (note.text.starts_with("a slip in space passes so near to rest")) error = note.error;
  BOOST_TEST_REQUIRE(error.has_value());
  BOOST_TEST(*error < 1e-4);
  BOOST_TEST(std::abs(slope(found, "normal_velocity") / 0.84220118969 - 1) < *error);
}
