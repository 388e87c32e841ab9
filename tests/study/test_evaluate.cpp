#define BOOST_TEST_MODULE study_evaluate
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/report/json/json.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/study/sweep/batch.hpp"
#include "mariotte/study/sweep/brief_quantities.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"
#include "study/sweep_scenes.hpp"

using namespace mariotte;

namespace {

scene::Scene three() {
  return scene::parse(test::three_balls, "three", {"chain.velocity[2]=-0.5", "chain.mass[1]=2"});
}

std::vector<double> evaluated(const std::vector<std::string>& columns, const scene::Scene& scene) {
  std::vector<double> numbers(columns.size());
  study::make_evaluate(columns, test::simulate)(scene, numbers);
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(quick_and_whole_results_give_the_same_columns) {
  const auto scene = three();
  const auto result = test::simulate(scene);
  int compared = 0;
  for (const std::string key :
       {"final.time", "final.velocity[0]", "final.velocity[2]", "contacts[1].impulse", "icr[0]", "icr[1]",
        "contacts[0].periods.count", "impulse_direction[1]", "energy.final", "energy.ratio_lab"}) {
    BOOST_TEST(study::brief_quantity_of_chain(key).has_value(), key);
    const double quick = evaluated({key}, scene)[0], full = number(result, study::result_key(key));
    BOOST_TEST(std::isnan(quick) == std::isnan(full), key);
    if (!std::isnan(quick)) BOOST_TEST(std::abs(quick - full) <= 1e-10 * (1 + std::abs(full)), key);
    compared += !std::isnan(quick);
  }
  BOOST_TEST(compared == 9);  // icr[1] is beyond the end
}

namespace {

scene::Scene rod(std::vector<std::string> overrides) {
  overrides.push_back("incidence.tangential_velocity=[1, 0]");
  return scene::read(MARIOTTE_SCENES "/microrod.toml", overrides);
}

}  // namespace

BOOST_AUTO_TEST_CASE(quick_and_whole_results_of_a_body_give_the_same_columns) {
  const std::vector<std::string> keys = {
      "final.time",    "final.velocity[0]", "final.velocity[1]", "final.velocity[2]", "final.spin[0]",
      "final.spin[1]", "final.spin[2]",     "final.spin[3]",     "restitution.tip",   "restitution.centre"};
  const auto refuse = [](const scene::Scene&) -> study::Json {
    throw Error("the whole result is not needed");
  };
  for (const auto& overrides : std::vector<std::vector<std::string>>{
           {}, {"incidence.angles[1]=80 deg"}, {"incidence.normal_speed=1 mm/s"}, {"run.max_time=1 ns"}}) {
    auto scene = rod(overrides);
    auto& body = std::get<model::Microbody>(scene.model);
    body.impacts = 1;
    const auto result = report::json(impact::simulate(body, scene.run), scene);
    std::vector<double> quick(keys.size());
    const auto verdict = study::make_evaluate(keys, refuse)(scene, quick);
    BOOST_TEST(verdict.ending == result["ending"].get<std::string>());
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const double full = number(result, study::result_key(keys[k]));
      BOOST_TEST(std::isnan(quick[k]) == std::isnan(full), keys[k]);
      if (!std::isnan(full)) BOOST_TEST(std::abs(quick[k] - full) <= 1e-9 * std::abs(full) + 1e-12, keys[k]);
    }
  }
  std::vector<double> one(1);
  BOOST_CHECK_THROW(study::make_evaluate({"restitution.tip"}, refuse)(rod({}), one), Error);
}

BOOST_AUTO_TEST_CASE(columns_are_the_numbers_of_the_result) {
  const auto scene = three();
  const auto whole = impact::simulate(std::get<model::Chain>(scene.model), scene.run);
  const auto numbers = evaluated({"final.velocity[2]", "icr[0]", "contacts[1].peak_force", "energy.residual",
                                  "events.count", "accuracy.estimated"},
                                 scene);
  BOOST_TEST(numbers[0] == whole.velocity[2]);
  BOOST_TEST(numbers[1] == *whole.icr[0]);
  BOOST_TEST(numbers[2] == whole.contacts[1].peak_force);
  BOOST_TEST(numbers[3] == whole.energy.residual);
  BOOST_TEST(numbers[4] == static_cast<double>(whole.events.size()));
  BOOST_TEST(std::isnan(numbers[5]));
}

BOOST_AUTO_TEST_CASE(a_scene_of_another_kind_needs_only_its_result) {
  scene::Scene body;
  body.model = model::Microbody{};
  const auto simulate = [](const scene::Scene&) {
    return study::Json::parse(R"({"ending": "captured", "restitution": {"tip": 0.5, "centre": null},
                                  "impacts": [{"tip": 1, "peak_force": 2}]})");
  };
  const auto columns = study::expand_columns({}, simulate(body));
  BOOST_TEST(columns == (std::vector<std::string>{"restitution.tip", "restitution.centre"}),
             boost::test_tools::per_element());
  std::vector<double> numbers(2);
  const auto verdict =
      study::make_evaluate({"restitution.tip", "impacts[0].peak_force"}, simulate)(body, numbers);
  BOOST_TEST(verdict.ending == "captured");
  BOOST_TEST(verdict.has_numbers());
  BOOST_TEST(numbers == (std::vector<double>{0.5, 2}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_star_stands_for_all_indices) {
  const auto result = test::simulate(three());
  BOOST_TEST(study::expand_columns({"final.velocity[*]", "energy.final", "icr[*]"}, result) ==
                 (std::vector<std::string>{"final.velocity[0]", "final.velocity[1]", "final.velocity[2]",
                                           "energy.final", "icr[0]"}),
             boost::test_tools::per_element());
  BOOST_TEST((study::expand_columns({"energy.final", "icr[*]", "energy.final", "icr[0]"}, result) ==
              study::expand_columns({"energy.final", "icr[*]"}, result)));
  BOOST_TEST(study::expand_columns({"contacts[*].peak_force"}, result).back() == "contacts[1].peak_force");
}

BOOST_AUTO_TEST_CASE(columns_without_sense_are_refused) {
  const auto result = test::simulate(three());
  for (const auto* key : {"icr", "icr[]", "icr[a]", "icr[-1]", "icr]x[", "velocity[0]", "", "final", "ending",
                          "final.time[*]", "final.velocty[0]", "contacts[0].peak"})
    BOOST_CHECK_THROW(study::expand_columns({key}, result), study::ColumnError);
}

BOOST_AUTO_TEST_CASE(long_chains_have_few_columns_unless_asked) {
  const auto scene = scene::parse(test::steel_balls, "steel", {"chain.balls=1000", "chain.velocity=1"});
  const auto result = test::simulate(scene);
  BOOST_TEST(study::expand_columns({}, result).size() < 10);
  BOOST_TEST(study::expand_columns({"final.velocity[*]"}, result).size() == 1000);
}

BOOST_AUTO_TEST_CASE(a_point_that_fails_has_a_reason_and_no_numbers) {
  auto plan = study::read_sweep(scene::parse_document(test::three_balls + R"(
[[sweep]]
key = "chain.precompressed"
values = [false, true]
[[sweep]]
key = "chain.gap"
values = [0, -0.1]
)",
                                                      "s.toml"),
                                test::simulate);
  study::Variation variation(plan.document, plan.design, std::nullopt);
  study::Batch batch;
  study::evaluate(variation, study::make_evaluate({"final.velocity[2]"}, test::simulate), 1, 0, 4, batch);
  BOOST_TEST(batch.failed() == 1);
  BOOST_TEST(batch.verdicts[1].ending == "rejected");
  BOOST_TEST(batch.verdicts[1].reason.find("must not be negative") != std::string::npos);
  BOOST_TEST(std::isnan(batch.numbers[1]));
  BOOST_TEST(batch.verdicts[0].ending == "separated");
  BOOST_TEST(batch.numbers[0] > 0.9);
}

BOOST_AUTO_TEST_CASE(a_limit_keeps_the_numbers_that_were_reached) {
  const auto scene = scene::parse(test::three_balls, "three", {"run.max_time=0.5"});
  std::vector<double> numbers(1);
  const auto verdict = study::make_evaluate({"final.time"}, test::simulate)(scene, numbers);
  BOOST_TEST(verdict.ending == "time_limit");
  BOOST_TEST(verdict.has_numbers());
  BOOST_TEST(numbers[0] == 0.5, boost::test_tools::tolerance(1e-14));
}
