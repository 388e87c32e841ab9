// What commands print with --json, and what the page of results says of it.
#define BOOST_TEST_MODULE command_keys
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>

#include "mariotte/report/json/command_keys.hpp"
#include "mariotte/report/json/labels.hpp"
#include "session.hpp"

using namespace mariotte;
using support::Session;
using Json = nlohmann::json;
using Keys = std::set<std::string>;

namespace {

const std::string scenes = MARIOTTE_SCENES "/";

bool is_label(const std::string& key) {
  return key.starts_with("provenance.") && std::any_of(report::labels.begin(), report::labels.end(),
                                                       [&](const auto& one) { return one.key == key; });
}

/// The keys that lead to what is no object; each index is [], and each key of the user's is KEY.
void collect(const Json& value, const std::string& key, Keys& keys) {
  if (value.is_array()) {
    if (value.empty()) keys.insert(key + "[]");
    for (const auto& one : value) collect(one, key + "[]", keys);
  } else if (value.is_object()) {
    for (const auto& [name, one] : value.items())
      collect(one, key.ends_with("settings") ? key + ".KEY" : key.empty() ? name : key + "." + name, keys);
  } else if (!is_label(key)) {
    keys.insert(key);
  }
}

/// Without the arrays of objects that are empty in one line and not in another.
Keys without_empty_arrays(const Keys& keys) {
  Keys kept;
  for (auto one = keys.begin(); one != keys.end(); ++one)
    if (const auto next = std::next(one);
        next == keys.end() || !one->ends_with("[]") || !next->starts_with(*one))
      kept.insert(*one);
  return kept;
}

Keys documented(const std::string& command) {
  Keys keys;
  for (const auto& result : report::command_results)
    if (result.command == command)
      for (const auto& one : result.keys) keys.insert(std::string(one.key));
  return keys;
}

/// Each key of these lines is on the page, and each of the page is in one of them.
void check(const Session& session, const std::string& command, const std::vector<std::string>& lines) {
  Keys keys;
  for (const auto& line : lines) {
    const auto run = session.mariotte(line + " --json");
    BOOST_TEST_REQUIRE(!run.out.empty(), line << ": " << run.err);
    collect(Json::parse(run.out), "", keys);
  }
  keys = without_empty_arrays(keys);
  const auto expected = documented(command);
  BOOST_CHECK_EQUAL_COLLECTIONS(keys.begin(), keys.end(), expected.begin(), expected.end());
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(of_law, Session) {
  const std::string balls = " --mass 1,1,1 --velocity 1,0,0";
  write("rows.csv", mariotte("study icr-table --balls 3:4").out);
  check(*this, "`mariotte law`",
        {"law three.toml --rivals", "law" + balls + " --icr 0.5 --energy-ratio 0.1 --rivals",
         "law" + balls + " --icr -2 --energy-ratio 1 --rivals", "law --table rows.csv --at balls=3" + balls});
}

BOOST_FIXTURE_TEST_CASE(of_law_with_friction, Session) {
  check(*this, "`mariotte law` of bodies with friction", {"law " + scenes + "thrown_rod.toml"});
}

BOOST_FIXTURE_TEST_CASE(of_modes, Session) {
  check(*this, "`mariotte modes`",
        {"modes three.toml --force 1 --shapes", "modes three.toml --force 1 --set 'chain.mass=[1, 2, 1]'"});
}

BOOST_FIXTURE_TEST_CASE(of_restitution, Session) {
  check(*this, "`mariotte restitution`",
        {"restitution " + scenes + "steel_pair.toml --count 2 --from 0.1 --to 1"});
}

BOOST_FIXTURE_TEST_CASE(of_capture, Session) {
  check(*this, "`mariotte capture`", {"capture " + scenes + "captured_sphere.toml"});
}

BOOST_FIXTURE_TEST_CASE(of_fit, Session) {
  check(*this, "`mariotte fit`", {"fit " + scenes + "sphere_fit.toml " + scenes + "sphere_fit.csv"});
}

BOOST_FIXTURE_TEST_CASE(of_uncertainty, Session) {
  check(*this, "`mariotte uncertainty`",
        {"uncertainty three.toml --set 'chain.velocity[0]=1 ± 1 %' --samples 10"});
}
