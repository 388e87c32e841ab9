#define BOOST_TEST_MODULE study_evaluate
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/quantities/quantity.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"
#include "mariotte/study/sweep/batch.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"
#include "study/sweep_scenes.hpp"

using namespace mariotte;

namespace {

using Keys = std::vector<std::string>;

scene::Scene three() {
  return scene::parse(test::three_balls, "three", {"chain.velocity[2]=-0.5", "chain.mass[1]=2"});
}

scene::Scene rod(std::vector<std::string> overrides) {
  overrides.push_back("incidence.tangential_velocity=[1, 0]");
  return scene::read(MARIOTTE_SCENES "/microrod.toml", overrides);
}

Keys expanded(const Keys& keys, const scene::Scene& scene) {
  Keys written_out;
  for (const auto& column : study::expand_columns(keys, scene)) written_out.push_back(column.key);
  return written_out;
}

std::vector<double> evaluated(const Keys& keys, const scene::Scene& scene) {
  std::vector<study::Column> columns;
  for (const auto& key : keys) columns.push_back({key});
  std::vector<double> numbers(columns.size());
  study::make_evaluate(columns)(scene, numbers);
  return numbers;
}

/// Of the same scene: the keys alone, which the quickest solver has, and with one that only a whole run has.
void compare(const Keys& keys, const scene::Scene& scene, double relative, double absolute) {
  const auto quick = evaluated(keys, scene);
  auto more = keys;
  more.push_back("energy.residual");
  const auto whole = evaluated(more, scene);
  BOOST_TEST(!std::isnan(whole.back()));
  for (std::size_t k = 0; k < keys.size(); ++k) {
    BOOST_TEST(std::isnan(quick[k]) == std::isnan(whole[k]), keys[k]);
    if (!std::isnan(quick[k]))
      BOOST_TEST(std::abs(quick[k] - whole[k]) <= absolute + relative * std::abs(whole[k]), keys[k]);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(quick_and_whole_results_give_the_same_columns) {
  const Keys keys = {
      "final.time",      "final.velocity[0]",         "final.velocity[2]",    "contacts[1].impulse",
      "icr[0]",          "contacts[0].periods.count", "impulse_direction[1]", "energy.final",
      "energy.ratio_lab"};
  compare(keys, three(), 1e-10, 1e-10);  // the accuracy asked for
  const auto beyond = evaluated({"icr[1]", "final.velocity[3]", "contacts[2].impulse", "impulse_direction[2]",
                                 "contacts[2].periods.count"},
                                three());
  for (const double number : beyond) BOOST_TEST(std::isnan(number));
}

BOOST_AUTO_TEST_CASE(quick_and_whole_results_of_a_body_give_the_same_columns) {
  const Keys keys = {"final.time",        "final.velocity[0]", "final.velocity[1]",
                     "final.velocity[2]", "final.spin[0]",     "final.spin[1]",
                     "final.spin[2]",     "restitution.tip",   "restitution.centre"};
  for (const auto& overrides : std::vector<Keys>{
           {}, {"incidence.angles[1]=80 deg"}, {"incidence.normal_speed=1 mm/s"}, {"run.max_time=1 ns"}}) {
    auto scene = rod(overrides);
    std::get<model::Microbody>(scene.model).impacts = 1;
    compare(keys, scene, 1e-9, 1e-12);  // the accuracy of the scene, magnified by the impact
  }
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

BOOST_AUTO_TEST_CASE(a_body_has_columns_of_its_own) {
  const auto body = rod({});
  BOOST_TEST(expanded({}, body) == (Keys{"final.velocity[0]", "final.velocity[1]", "final.velocity[2]",
                                         "final.spin[0]", "final.spin[1]", "final.spin[2]", "restitution.tip",
                                         "restitution.centre", "energy.final"}),
             boost::test_tools::per_element());
  const auto whole = impact::simulate(std::get<model::Microbody>(body.model), body.run);
  const auto numbers = evaluated({"restitution.tip", "impacts[0].peak_force", "impacts[99].tip"}, body);
  BOOST_TEST(numbers[0] == whole.restitution.tip);
  BOOST_TEST(numbers[1] == whole.impacts[0].peak_force);
  BOOST_TEST(std::isnan(numbers[2]));
}

BOOST_AUTO_TEST_CASE(a_star_stands_for_all_indices) {
  const auto scene = three();
  BOOST_TEST(
      expanded({"final.velocity[*]", "energy.final", "icr[*]"}, scene) ==
          (Keys{"final.velocity[0]", "final.velocity[1]", "final.velocity[2]", "energy.final", "icr[0]"}),
      boost::test_tools::per_element());
  BOOST_TEST((expanded({"energy.final", "icr[*]", "energy.final", "icr[0]"}, scene) ==
              expanded({"energy.final", "icr[*]"}, scene)));
  BOOST_TEST(expanded({"contacts[*].peak_force"}, scene).back() == "contacts[1].peak_force");
}

BOOST_AUTO_TEST_CASE(what_only_a_run_can_count_is_counted_by_a_run) {
  const auto scene = three();
  const auto events = static_cast<std::size_t>(evaluated({"events.count"}, scene)[0]);
  BOOST_TEST(events > 1);
  BOOST_TEST(expanded({"events[*].time"}, scene).size() == events);
  BOOST_TEST(expanded({"contacts[*].periods[*][0]"}, scene) ==
                 (Keys{"contacts[0].periods[0][0]", "contacts[1].periods[0][0]"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_column_knows_its_unit_and_meaning) {
  const auto columns = study::expand_columns({"contacts[1].impulse", "contacts[0].periods.count"}, three());
  BOOST_TEST(columns[0].unit == "N s");
  BOOST_TEST(columns[0].symbol == "p_j");
  BOOST_TEST(columns[0].meaning.starts_with("impulse of the contact"));
  BOOST_TEST(columns[1].unit == "1");
}

namespace {

/// What is said of a key that is refused.
std::string refusal(const std::string& key, const scene::Scene& scene) {
  try {
    study::expand_columns({key}, scene);
  } catch (const study::ColumnError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

BOOST_AUTO_TEST_CASE(columns_without_sense_are_refused) {
  auto scene = three();
  scene.run.max_events = 0;  // whoever simulated it would fail
  for (const auto* key : {"icr",
                          "icr[]",
                          "icr[a]",
                          "icr[-2]",
                          "icr]x[",
                          "icr[0",
                          "icr[0][0]",
                          "velocity[0]",
                          "",
                          "final",
                          "ending",
                          "final.time[*]",
                          "final.velocty[0]",
                          "contacts[0].peak",
                          "contacts[0]",
                          "icr[1]",
                          "final.velocity[3]",
                          "contacts[2].impulse",
                          "contacts[0].periods[0][2]",
                          "flows[0].name",
                          "icr.count.count",
                          "final.time.count",
                          "contacts[0].periods[0][0][0][0]"})
    BOOST_CHECK_THROW(study::expand_columns({key}, scene), study::ColumnError);
  for (const auto* key : {"final.velocity[3]", "shared_friction", "rest", "icr[0]"})
    BOOST_CHECK_THROW(study::expand_columns({key}, rod({})), study::ColumnError);
}

BOOST_AUTO_TEST_CASE(a_refusal_names_the_key_that_was_meant) {
  const auto scene = three();
  const auto names = [&](const std::string& key, const std::string& meant) {
    const auto what = refusal(key, scene);
    BOOST_TEST(what.find(meant) != std::string::npos, what);
  };
  names("final.velocty[1]", "did you mean 'final.velocity[1]'?");
  names("velocity[0]", "did you mean 'final.velocity[0]'?");
  names("velocty[1]", "did you mean 'final.velocity[1]'?");
  names("velocty", "did you mean 'final.velocity[0]'?");
  names("icr[0", "did you mean 'icr[0]'?");
  names("icr[x]", "did you mean 'icr[0]'?");
  names("contacts[1].peak_forse", "did you mean 'contacts[1].peak_force'?");
  names("events.cuont", "did you mean 'events.count'?");
  names("icr", "needs an index in brackets");
  names("icr[1]", "'icr[1]' does not exist: the last is icr[0]");
  names("flows[0].name", "is no number");
  const auto pair = scene::parse(test::steel_balls, "pair", {"chain.balls=2", "chain.velocity=[1, 0]"});
  BOOST_TEST(refusal("icr[*]", pair).find("'icr[*]' stands for nothing") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_index_that_only_some_points_have_is_right) {
  const std::string sweep = "[[sweep]]\nkey = 'chain.balls'\nvalues = [3, 5, 4]\n";
  const auto columns = [&](const std::string& keys) {
    return study::read_sweep(scene::parse_document("columns = [" + keys + "]\n" + test::steel_balls + sweep,
                                                   "s.toml", {"chain.velocity=1"}))
        .columns;
  };
  BOOST_TEST(columns("'icr[2]'")[0].key == "icr[2]");
  BOOST_CHECK_THROW(columns("'icr[3]'"), scene::SceneError);
  BOOST_TEST(columns("'final.velocity[*]'").size() == 5u);
}

BOOST_AUTO_TEST_CASE(long_chains_have_few_columns_unless_asked) {
  const auto scene = scene::parse(test::steel_balls, "steel", {"chain.balls=1000", "chain.velocity=1"});
  BOOST_TEST(expanded({}, scene).size() < 10);
  BOOST_TEST(expanded({"final.velocity[*]"}, scene).size() == 1000);
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
                                {"final.velocity[2]"});
  study::Variation variation(plan.document, plan.design, std::nullopt);
  study::PointEvaluation evaluation(plan);
  study::Batch batch;
  evaluate(variation, evaluation, 1, 0, 4, batch);
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
  const auto verdict = study::make_evaluate({{"final.time"}})(scene, numbers);
  BOOST_TEST(verdict.ending == "time_limit");
  BOOST_TEST(verdict.has_numbers());
  BOOST_TEST(numbers[0] == 0.5, boost::test_tools::tolerance(1e-14));
}

/// The columns of the first point of a sweep over one value.
struct Swept {
  study::SweepPlan plan;
  std::vector<double> numbers;
  study::Verdict verdict;
};
Swept swept(const std::string& scene, const std::string& key, const Keys& columns) {
  auto plan = study::read_sweep(
      scene::parse_document(scene + "\n[[sweep]]\nkey = '" + key + "'\nvalues = [2]\n", "s.toml"), columns);
  study::Variation points(plan.document, plan.design, study::find_slots(plan.document, plan.design));
  study::PointEvaluation evaluation(plan);
  study::Batch batch;
  evaluate(points, evaluation, plan.columns.size(), 0, 1, batch);
  return {std::move(plan), batch.numbers, batch.verdicts[0]};
}

/// The slope that `sensitivity` gives.
double slope(const scene::Document& document, const std::string& outcome, const std::string& number) {
  const auto all = study::sensitivity(document, resolve(document), {number});
  for (const auto& one : all.outcome)
    if (name_of(one) == outcome) return one.slope[0].value();
  return 0;
}

const std::string three_steel_balls =
    "[chain]\nradius = ['10 mm', '12 mm', '10 mm']\nmaterial = 'steel'\nlaw = 'hertz'\nvelocity = [1, 0, "
    "0]\n";

BOOST_AUTO_TEST_CASE(slopes_are_columns_beside_others) {
  const Keys keys = {"final.velocity[0]", "sensitivity.velocity[2].mass[0]",
                     "sensitivity.time.contact[1].stiffness", "sensitivity.icr[0].velocity[0]"};
  const auto [plan, numbers, verdict] = swept(test::three_balls, "chain.mass[1]", keys);
  BOOST_TEST(plan.columns[1].unit == "kg^-1 m s^-1");
  BOOST_TEST(plan.columns[3].unit == "s/m");
  const auto document = scene::parse_document(test::three_balls, "s.toml", {"chain.mass[1]=2"});
  BOOST_TEST(numbers[0] == evaluated({"final.velocity[0]"}, resolve(document))[0]);
  BOOST_TEST(numbers[1] == slope(document, "velocity[2]", "mass[0]"), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(numbers[2] == slope(document, "time", "contact[1].stiffness"),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_star_stands_for_all_indices_of_a_slope) {
  const auto columns = [](const char* scene, const char* key) {
    std::string all;
    for (const auto& one : swept(scene, "chain.velocity[0]", {key}).plan.columns)
      all += one.key.substr(12) + " ";
    return all;
  };
  const auto* const steel = three_steel_balls.c_str();
  BOOST_TEST(columns(steel, "sensitivity.velocity[2].mass[*]") ==
             "velocity[2].mass[0] velocity[2].mass[1] velocity[2].mass[2] ");
  BOOST_TEST(
      columns(steel, "sensitivity.impulse[*].contact[*].stiffness") ==
      "impulse[0].contact[0].stiffness impulse[0].contact[1].stiffness impulse[1].contact[0].stiffness "
      "impulse[1].contact[1].stiffness ");
  BOOST_TEST(columns(steel, "sensitivity.time.chain.radius[*]") ==
             "time.chain.radius[0] time.chain.radius[1] time.chain.radius[2] ");
}

BOOST_AUTO_TEST_CASE(slopes_by_numbers_of_the_scene_are_columns) {
  const auto [plan, numbers, verdict] =
      swept(three_steel_balls, "chain.velocity[0]", {"sensitivity.velocity[2].chain.radius[0]"});
  BOOST_TEST(verdict.reason == "");
  BOOST_TEST(plan.columns[0].unit == "s^-1");
  const auto document = scene::parse_document(three_steel_balls, "s.toml", {"chain.velocity[0]=2"});
  BOOST_TEST(numbers[0] != 0);
  BOOST_TEST(numbers[0] == slope(document, "velocity[2]", "chain.radius[0]"),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(slopes_of_bodies_are_columns) {
  std::ifstream file(MARIOTTE_SCENES "/oblique_sphere.toml");
  const std::string scene{std::istreambuf_iterator<char>(file), {}};
  const auto [plan, numbers, verdict] =
      swept(scene, "bodies.body[0].spin", {"sensitivity.bodies[0].velocity[0].body[0].velocity[0]"});
  const auto document = scene::parse_document(scene, "s.toml", {"bodies.body[0].spin=2"});
  BOOST_TEST(numbers[0] == slope(document, "bodies[0].velocity[0]", "body[0].velocity[0]"),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_point_says_why_it_has_no_slope) {
  const auto [plan, numbers, verdict] =
      swept("[chain]\nmass = [1, 2, 1]\nvelocity = [1, 0, -1]\nlaw = 'hertz'\nstiffness = 1\n",
            "chain.stiffness", {"sensitivity.time.mass[0]"});
  BOOST_TEST(verdict.ending == "separated");
  BOOST_TEST(verdict.reason.find("several contacts end the run at one instant") != std::string::npos,
             verdict.reason);
}

BOOST_AUTO_TEST_CASE(a_number_without_slopes_takes_none_from_others) {
  const auto [plan, numbers, verdict] =
      swept(three_steel_balls + "gap = [0, 1e-6]\n", "chain.velocity[0]",
            {"sensitivity.velocity[2].chain.gap[0]", "sensitivity.velocity[2].chain.radius[0]"});
  BOOST_TEST(verdict.ending == "separated");
  BOOST_TEST(std::isnan(numbers[0]));
  BOOST_TEST(numbers[1] > 0);
  BOOST_TEST(verdict.reason.find("chain.gap[0]") != std::string::npos, verdict.reason);
}

BOOST_AUTO_TEST_CASE(slopes_that_a_scene_does_not_have_are_refused) {
  const auto refused = [](const std::string& key, const char* message) {
    BOOST_CHECK_EXCEPTION(swept(test::three_balls, "chain.mass[1]", {key}), study::ColumnError,
                          [&](const auto& error) {
                            BOOST_TEST_INFO(error.what());
                            return std::string(error.what()).find(message) != std::string::npos;
                          });
  };
  refused("sensitivity.velocity[3].mass[0]", "this scene has no outcome 'velocity[3]'");
  refused("sensitivity.velocity[0].mas[0]", "did you mean 'mass[0]'?");
  refused("sensitivity.velocity[0].mas[*]", "this scene has no number 'mas[*]'");
  refused("sensitivity.velocity[0]", "this scene has no number ''");
  refused("sensitivity.velocity[0].chain.mass", "'chain.mass' is a list: say which, as 'chain.mass[0]'");
  BOOST_CHECK_THROW(study::expand_columns({"sensitivity.velocity[0].mass[0]"}, three()), study::ColumnError);
}

/// How many quantities have a column where every index is 0. What is counted by the run has no elements
/// before it; others the scene may not have, or they are words.
template <class Impact>
int first_elements(const scene::Scene& scene) {
  int found = 0;
  for (const auto& quantity : impact::quantities<Impact>()) {
    if (!quantity.read) continue;
    std::string key(quantity.is.key);
    for (std::size_t at; (at = key.find("[]")) != std::string::npos;) key.replace(at, 2, "[0]");
    try {
      evaluated(expanded({key}, scene), scene);
      ++found;
    } catch (const study::ColumnError&) {
    }
  }
  return found;
}

BOOST_AUTO_TEST_CASE(the_first_element_of_every_array_can_be_asked_for) {
  BOOST_TEST(first_elements<impact::ChainImpact>(three()) > 40);
  BOOST_TEST(first_elements<impact::NetworkImpact>(scene::read(MARIOTTE_SCENES "/rack_break.toml")) > 30);
  BOOST_TEST(first_elements<impact::MicrobodyImpact>(rod({})) > 50);
  BOOST_TEST(first_elements<impact::BodiesImpact>(scene::read(MARIOTTE_SCENES "/dropped_rod.toml")) > 50);
}
