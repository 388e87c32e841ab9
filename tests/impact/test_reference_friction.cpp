// Bodies with friction beside reference numbers of two independent methods.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/friction_cases.hpp"

using namespace mariotte;
using test::vector_of;

namespace {

constexpr std::array kinds = {"close",   "open", "touch",  "part",  "stick", "slip",
                              "reverse", "load", "unload", "slack", "grip"};

/// Kinds of events of each contact in order of time.
std::map<Index, std::vector<std::string>> kinds_of(const impact::BodiesImpact& impact) {
  std::map<Index, std::vector<std::string>> all;
  for (const auto& event : impact.events)
    for (std::size_t k = 0; k < kinds.size(); ++k)
      for (const Index contact : event.all[k]) all[contact].push_back(kinds[k]);
  return all;
}
std::map<Index, std::vector<std::string>> kinds_of(const test::Json& events) {
  std::map<Index, std::vector<std::string>> all;
  for (const auto& event : events) all[event[0]].push_back(event[1]);
  return all;
}

struct Errors {
  double velocity = 0, spin = 0, impulse = 0, loss = 0;
};

Errors errors_of(const impact::BodiesImpact& impact, const test::Json& one) {
  const auto& expected = one["expected"];
  const double v = one["scales"]["V"], m = one["scales"]["M"], r = one["scales"]["r"];
  const bool plane = impact.dimension == 2;
  Errors errors;
  for (std::size_t i = 0; i < impact.body.size(); ++i) {
    const auto& body = expected["bodies"][i];
    const Vector3 spin = plane ? Vector3{0, 0, body["spin"]} : vector_of(body["spin"]);
    errors.velocity =
        std::max(errors.velocity, norm(impact.body[i].velocity - vector_of(body["velocity"])) / v);
    errors.spin = std::max(errors.spin, norm(impact.body[i].spin - spin) * r / v);
  }
  for (std::size_t c = 0; c < impact.contacts.size(); ++c) {
    const auto& contact = expected["contacts"][c];
    const auto& mine = impact.contacts[c];
    const auto& tangential = contact["tangential_impulse"];
    const Vector3 along = plane ? Vector3{tangential, 0, 0} : vector_of(tangential);
    errors.impulse =
        std::max({errors.impulse, norm(mine.tangential_impulse - along) / (m * v),
                  std::abs(mine.normal_impulse - contact["normal_impulse"].get<double>()) / (m * v)});
    for (const auto& [loss, key] :
         {std::pair{mine.losses.friction, "friction_loss"}, std::pair{mine.losses.rescale, "rescale_loss"},
          std::pair{mine.losses.damper, "damper_loss"}})
      errors.loss = std::max(errors.loss, std::abs(loss - contact[key].get<double>()) / (m * v * v));
  }
  return errors;
}

void check(double accuracy) {
  for (const auto& one : test::friction_cases()) {
    BOOST_TEST_CONTEXT(one["id"].get<std::string>() << " at " << accuracy) {
      hybrid::Options options{.accuracy = accuracy};
      if (one["stop"]["kind"] == "time") options.max_time = one["stop"]["time"], options.flies_on = true;
      const auto impact = impact::simulate(test::bodies_of(one), options);
      const auto errors = errors_of(impact, one);
      const auto bound = [&](const char* key) {
        return std::max(accuracy, one["error_bound"][key].get<double>());
      };
      BOOST_TEST(errors.velocity <= bound("velocity"));
      BOOST_TEST(errors.spin <= bound("spin_times_r"));
      BOOST_TEST(errors.impulse <= bound("impulse"));
      BOOST_TEST(errors.loss <= bound("loss"));
      // Of one instant the order of kinds is that of the list above: sorted, both say the same.
      auto mine = kinds_of(impact), theirs = kinds_of(one["expected"]["events"]);
      for (auto* all : {&mine, &theirs})
        for (auto& [contact, list] : *all) std::sort(list.begin(), list.end());
      BOOST_TEST((mine == theirs));
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_reference_cases_are_met_at_1e_6) {
  check(1e-6);
}
BOOST_AUTO_TEST_CASE(all_reference_cases_are_met_at_1e_8) {
  check(1e-8);
}
BOOST_AUTO_TEST_CASE(all_reference_cases_are_met_at_1e_10) {
  check(1e-10);
}
