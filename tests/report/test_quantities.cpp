#define BOOST_TEST_MODULE report_quantities
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "mariotte/impact/quantities/quantity_key.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/report/json/labels.hpp"
#include "mariotte/scene/judge.hpp"
#include "mariotte/scene/scene.hpp"

using namespace mariotte;
using report::Json;

namespace {

/// A chain, a network or a body, simulated.
template <class Impact>
struct Run {
  scene::Scene scene;
  Impact impact;
  Json json = report::json(impact, scene);
};

Run<impact::ChainImpact> chain(int balls) {
  auto scene = scene::read(MARIOTTE_SCENES "/solitary_wave.toml",
                           {"chain.balls=" + std::to_string(balls), "chain.material=steel"});
  auto impact = impact::simulate(std::get<model::Chain>(scene.model), scene.run);
  judge(impact, scene);
  return {std::move(scene), std::move(impact)};
}

Run<impact::NetworkImpact> network() {
  auto scene = scene::read(MARIOTTE_SCENES "/y_chain.toml", {"network.material=steel"});
  auto impact = impact::simulate(std::get<model::Network>(scene.model), scene.run);
  judge(impact, scene);
  return {std::move(scene), std::move(impact)};
}

Run<impact::MicrobodyImpact> body(const std::string& name, const scene::Overrides& overrides = {}) {
  auto scene = scene::read(MARIOTTE_SCENES "/" + name, overrides);
  auto impact = impact::simulate(std::get<model::Microbody>(scene.model), scene.run);
  judge(impact, scene);
  return {std::move(scene), std::move(impact)};
}

/// Leaves of the JSON and its arrays, by their keys: "contacts[0].impulse", "contacts".
using Nodes = std::map<std::string, const Json*>;

void walk(const Json& node, const std::string& key, Nodes& nodes) {
  if (!node.is_object()) nodes[key] = &node;
  if (node.is_object())
    for (const auto& [name, value] : node.items()) walk(value, key.empty() ? name : key + "." + name, nodes);
  if (node.is_array())
    for (std::size_t i = 0; i < node.size(); ++i) walk(node[i], key + "[" + std::to_string(i) + "]", nodes);
}

bool is_label(const std::string& pattern) {
  return pattern.starts_with("skipped.") ||  // what was skipped is a key of its own
         std::any_of(report::labels.begin(), report::labels.end(),
                     [&](const auto& label) { return label.key == pattern || label.key == pattern + "[]"; });
}

bool same(const Json& json, const impact::Value& value) {
  if (const auto* words = std::get_if<std::string_view>(&value)) return json == std::string(*words);
  if (const auto* truth = std::get_if<bool>(&value)) return json == *truth;
  const double number = impact::number(value);
  return json.is_null() ? std::isnan(number) : json.is_number() && json.get<double>() == number;
}

template <class Impact>
double length(const std::string& key, const Impact& impact) {
  const auto entry = impact::find_entry<Impact>(*impact::parse_key(key + ".count"));
  return entry ? impact::number(*entry, impact) : -1;
}

template <class Impact>
bool is_part_of_some_key(const std::string& pattern) {
  const auto& list = impact::quantities<Impact>();
  return std::any_of(list.begin(), list.end(), [&](const auto& one) {
    return one.is.key.starts_with(pattern + ".") || one.is.key == pattern + "[]";
  });
}

/// What stands in the JSON is what the list reads there, and nothing is in the JSON that the list and the
/// labels do not know. Returns the keys of the list that this result has no value of.
template <class Impact>
std::set<std::string> check(const Run<Impact>& run) {
  std::set<std::string> missing;
  for (const auto& quantity : impact::quantities<Impact>())
    if (quantity.read) missing.emplace(quantity.is.key);
  Nodes nodes;
  walk(run.json, "", nodes);
  for (const auto& [key, node] : nodes) {
    const auto parsed = *impact::parse_key(key);
    if (is_label(parsed.pattern)) continue;
    if (node->is_array()) {
      BOOST_TEST(length(key, run.impact) == static_cast<double>(node->size()), key);
    } else if (const auto entry = impact::find_entry<Impact>(parsed)) {
      BOOST_TEST(same(*node, entry->quantity->read(run.impact, entry->at)), key);
      missing.erase(parsed.pattern);
    } else {
      BOOST_TEST((node->is_null() && is_part_of_some_key<Impact>(parsed.pattern)), key);
    }
  }
  return missing;
}

using Keys = std::set<std::string>;

/// What elastic contacts without tables have no value of.
const Keys without_adhesion = {"bound_frequency[]",    "events[].capture[]",   "events[].slip[]",
                               "events[].stick[]",     "events[].unload[]",    "events[].yield[]",
                               "validity.table_ratio", "validity.tabor_number"};

}  // namespace

BOOST_AUTO_TEST_CASE(json_and_list_of_a_chain_are_the_same) {
  auto of_no_pair = without_adhesion;
  of_no_pair.insert("restitution");
  BOOST_TEST(check(chain(5)) == of_no_pair, boost::test_tools::per_element());
  BOOST_TEST(!check(chain(2)).contains("restitution"));
}

BOOST_AUTO_TEST_CASE(json_and_list_of_a_long_chain_are_the_same) {
  const auto run = chain(60);
  check(run);
  BOOST_TEST(run.json["contacts"][58]["peak_force"].get<double>() > 0);  // found in islands
}

BOOST_AUTO_TEST_CASE(json_and_list_of_a_network_are_the_same) {
  BOOST_TEST(check(network()) == without_adhesion, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(json_and_list_of_a_body_are_the_same) {
  const auto captured = check(body("captured_sphere.toml"));
  const auto sticking =
      check(body("microrod.toml",
                 {"surface.friction=0.5", "incidence.tangential_velocity=[0.5, 0]", "body.material=steel"}));
  for (const auto& key : captured) BOOST_TEST(!sticking.contains(key), "neither body has " << key);
}

BOOST_AUTO_TEST_CASE(every_quantity_says_what_it_is_once) {
  const auto examine = [](const auto& list) {
    Keys keys;
    for (const auto& one : list) {
      BOOST_TEST(keys.emplace(one.is.key).second, one.is.key);
      BOOST_TEST(!one.is.meaning.empty(), one.is.key);
      BOOST_TEST((one.read || one.count), one.is.key);
      BOOST_TEST((one.count != nullptr) == one.is.key.ends_with("[]"), one.is.key);
      const auto outer = one.is.key.substr(0, one.is.key.rfind("[]", one.is.key.size() - 3) + 2);
      if (one.is.key.find("[]") < one.is.key.size() - 2)
        BOOST_TEST(keys.contains(std::string(outer)), one.is.key);
    }
  };
  examine(impact::quantities<impact::ChainImpact>());
  examine(impact::quantities<impact::NetworkImpact>());
  examine(impact::quantities<impact::MicrobodyImpact>());
}

namespace {

/// Every brief quantity, at every index, equals the whole run's.
template <class Impact, class Model>
int compare_brief(const Run<Impact>& run, const Model& model, double relative, double absolute) {
  typename impact::Brief<Impact>::Solver solver;
  const impact::Brief<Impact> brief{model, solver.solve(model, run.scene.run)};
  int compared = 0;
  for (const auto& quantity : impact::quantities<Impact>()) {
    if (!quantity.brief) continue;
    for (Index i = 0; i < 5; ++i) {
      auto key = std::string(quantity.is.key);
      if (!quantity.read) key.replace(key.size() - 2, 2, ".count");
      if (const auto open = key.find("[]"); open != key.npos) key.insert(open + 1, std::to_string(i));
      const auto entry = *impact::find_entry<Impact>(*impact::parse_key(key));
      BOOST_TEST(is_brief(entry), key);
      const double quick = number(entry, brief), whole = number(entry, run.impact);
      BOOST_TEST(std::isnan(quick) == std::isnan(whole), key);
      if (!std::isnan(whole))
        BOOST_TEST(std::abs(quick - whole) <= absolute + relative * std::abs(whole), key);
      compared += !std::isnan(whole);
    }
  }
  return compared;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_the_quickest_solver_knows_equals_the_whole_run) {
  const auto balls = chain(5);
  // 5 velocities, 4 impulses, counts and directions, 3 ratios; time, energy and its ratio five times each
  BOOST_TEST(compare_brief(balls, std::get<model::Chain>(balls.scene.model), 1e-10, 1e-10) ==
             5 + 4 * 3 + 3 + 3 * 5);
  auto rod = body("microrod.toml");
  auto& one = std::get<model::Microbody>(rod.scene.model);
  one.impacts = 1;
  rod.impact = impact::simulate(one, rod.scene.run);
  // the two run with different sets of integrals, so steps differ; the impact magnifies their errors
  BOOST_TEST(compare_brief(rod, one, 1e-9, 1e-12) == 3 + 3 + 3 * 5);
}
