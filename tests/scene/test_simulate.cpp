#define BOOST_TEST_MODULE scene_simulate
#include <boost/test/unit_test.hpp>

#include "mariotte/report/json/json.hpp"
#include "mariotte/report/text.hpp"

using namespace mariotte;

namespace {

scene::Scene example(const std::string& name) {
  return scene::read(MARIOTTE_SCENES "/" + name + ".toml");
}

constexpr const char* law_alone =
    "[law]\nmass = [1, 1]\nvelocity = [1, 0]\ndirection = [1]\nenergy_ratio = 1\n";

}  // namespace

BOOST_AUTO_TEST_CASE(the_result_is_of_the_kind_of_the_model) {
  BOOST_TEST(std::holds_alternative<impact::ChainImpact>(scene::simulate(example("triplet"))));
  BOOST_TEST(std::holds_alternative<impact::NetworkImpact>(scene::simulate(example("bernoulli"))));
  BOOST_TEST(std::holds_alternative<impact::MicrobodyImpact>(scene::simulate(example("microsphere"))));
}

BOOST_AUTO_TEST_CASE(a_law_alone_is_refused_where_a_model_is_needed) {
  const auto scene = scene::parse(law_alone, "law.toml", {}, scene::Purpose::law);
  BOOST_TEST(std::holds_alternative<scene::LawAlone>(scene.model));
  BOOST_CHECK_THROW(scene::simulate(scene), scene::SceneError);
  BOOST_CHECK_THROW(report::json(scene), scene::SceneError);
}

BOOST_AUTO_TEST_CASE(texts_are_those_of_the_command_for_every_kind_of_result) {
  for (const char* name : {"triplet", "bernoulli", "microsphere"}) {
    const auto scene = example(name);
    const auto impact = scene::simulate(scene, {.trace = true});
    BOOST_TEST(report::Json::parse(report::json_text(impact, scene))["ending"] == "separated");
    BOOST_TEST(report::table_text(impact, scene).starts_with(scene.title));
    BOOST_TEST(report::events_text(impact).starts_with("time [s],open,close"));
    BOOST_TEST(report::trace_text(impact).starts_with("time [s],"));
  }
}

// At 0.24 s a contact begins at a depth that positions cannot tell from zero, with a damper that makes its
// cap grow sooner than its spring.
BOOST_AUTO_TEST_CASE(a_contact_within_rounding_of_its_onset_goes_on) {
  const auto scene = scene::read(
      MARIOTTE_SCENES "/climbing_dumbbell.toml",
      {"bodies.friction=0.001", "bodies.law=\"kuwabara-kono\"", "bodies.stiffness=21104295.91399529",
       "bodies.damping=13.932437636068071", "run.until=0.4"});
  const auto impact = std::get<impact::BodiesImpact>(scene::simulate(scene));
  BOOST_TEST((impact.ending == hybrid::Ending::time_limit));
  Index steps = 0;
  for (const auto& flow : impact.flows) steps += flow.steps;
  BOOST_TEST(steps < 20000);
}
