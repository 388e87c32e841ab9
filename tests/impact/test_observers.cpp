#define BOOST_TEST_MODULE impact_observers
#include <boost/test/unit_test.hpp>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/networks.hpp"
#include "support/reference.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

double end(const impact::ContactImpact& impact) {
  return impact.time;
}
double end(const impact::MicrobodyImpact& impact) {
  return impact.final.time;
}

/// What is told in the course of a run: times in order up to the ending, as many events as the result has.
void tells_its_way(const auto& model) {
  std::vector<impact::Progress> told;
  const auto result = impact::simulate(
      model, {}, {.progress = [&](const impact::Progress& progress) { told.push_back(progress); }});
  BOOST_REQUIRE(told.size() > 1U);
  BOOST_TEST(
      std::is_sorted(told.begin(), told.end(), [](const auto& a, const auto& b) { return a.time < b.time; }));
  BOOST_TEST(told.front().time == 0);
  BOOST_TEST(told.back().time == end(result));
  BOOST_TEST(told.back().events >= std::ssize(result.events) - 1);
}

struct GivenUp {};

void can_be_given_up(const auto& model) {
  Index told = 0;
  const impact::RunObserver observers{.progress = [&](const impact::Progress&) {
    if (++told == 2) throw GivenUp();
  }};
  BOOST_CHECK_THROW(impact::simulate(model, {}, observers), GivenUp);
  BOOST_TEST(told == 2);
}

void keeps_what_it_has_when_interrupted(const auto& model) {
  Index asked = 0;
  const impact::RunObserver observers{.gives_up = [&] { return ++asked == 2; }};
  const auto impact = impact::simulate(model, {}, observers);
  const auto whole = impact::simulate(model);
  BOOST_TEST((impact.ending == hybrid::Ending::interrupted));
  BOOST_TEST(asked == 2);  // not run again at a tighter accuracy
  BOOST_TEST(end(impact) < end(whole));
  BOOST_TEST(impact.events.front().time == whole.events.front().time);
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-8 * impact.energy.initial);
}

model::Microbody body() {
  return microbody(body_cases("rod_tilt.json")[3]);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_model_tells_how_far_it_is) {
  tells_its_way(equal_chain(5));
  tells_its_way(one_on_two());
  tells_its_way(body());
}

BOOST_AUTO_TEST_CASE(every_run_can_be_given_up) {
  can_be_given_up(equal_chain(5));
  can_be_given_up(equal_chain(60));  // in islands
  can_be_given_up(one_on_two());
  can_be_given_up(body());
}

BOOST_AUTO_TEST_CASE(a_run_that_is_given_up_by_asking_ends_interrupted_with_what_it_has) {
  keeps_what_it_has_when_interrupted(equal_chain(5));
  keeps_what_it_has_when_interrupted(equal_chain(60));
  keeps_what_it_has_when_interrupted(one_on_two());
  keeps_what_it_has_when_interrupted(body());
}

BOOST_AUTO_TEST_CASE(places_that_do_not_exist_cannot_be_sampled) {
  const auto at = [](Index velocity, Index contact) {
    return impact::RunObserver{.samplings = {{.velocities = {velocity},
                                              .contacts = {contact},
                                              .take = [](const impact::Sample&) { return 1.0; }}}};
  };
  BOOST_CHECK_THROW(impact::simulate(one_on_two(), {}, at(60, 0)), InvalidParameter);
  BOOST_CHECK_THROW(impact::simulate(one_on_two(), {}, at(0, 60)), InvalidParameter);
  BOOST_CHECK_THROW(impact::simulate(body(), {}, at(3, 0)), InvalidParameter);
  BOOST_CHECK_THROW(impact::simulate(body(), {}, at(0, 2)), InvalidParameter);
}
