// Runs that are sampled are as accurate as others, and their samples are those of the run that stays.
#define BOOST_TEST_MODULE the promise of an accuracy where runs are sampled
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <random>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/meeting_bodies.hpp"
#include "support/random_bodies.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

std::vector<Index> all(Index count) {
  std::vector<Index> places(count);
  std::iota(places.begin(), places.end(), 0);
  return places;
}

/// Light balls between heavy ones: each contact closes again and again.
model::Chain rattling() {
  return {.mass = {20, 0.3, 2, 0.7, 20},
          .law = std::vector<contact::Law>(4, contact::Hertz{1}),
          .gap = {0.1, 0.7, 0.4, 0.9},
          .velocity = {0.5, 0, 0.2, 0, -0.5}};
}

Numbers velocities(const impact::ContactImpact& impact) {
  return impact.velocity;
}
Numbers velocities(const impact::MicrobodyImpact& impact) {
  const auto& v = impact.final.velocity;
  return {v.e1, v.e2, v.e3};
}
Numbers velocities(const impact::BodiesImpact& impact) {
  Numbers all;
  for (const auto& body : impact.body) all.insert(all.end(), {body.velocity.e1, body.velocity.e2});
  return all;
}

/// A run and the samples of its velocities.
template <class Impact>
struct Sampled {
  Impact impact;
  std::vector<impact::Sample> samples;
  int restarts = 0;
};

template <class Model>
auto sampled(const Model& model, const hybrid::Options& options, Index velocities, double interval) {
  Sampled<decltype(impact::simulate(model))> run;
  const impact::Sampling sampling{.velocities = all(velocities),
                                  .take =
                                      [&](const impact::Sample& sample) {
                                        run.samples.push_back(sample);
                                        return interval;
                                      },
                                  .restart =
                                      [&] {
                                        run.samples.clear();
                                        ++run.restarts;
                                      }};
  run.impact = impact::simulate(model, options, {.samplings = {sampling}});
  return run;
}

/// `unsampled` is a result of the same scene and options.
template <class Impact>
void samples_belong_to_the_run_that_stays(const Sampled<Impact>& run, const Impact& unsampled) {
  BOOST_TEST_REQUIRE(unsampled.estimated_accuracy.has_value());
  BOOST_TEST(run.restarts == 1);
  BOOST_TEST(run.impact.requested_accuracy == unsampled.requested_accuracy);
  BOOST_TEST_REQUIRE(run.impact.estimated_accuracy.has_value());
  BOOST_TEST(*run.impact.estimated_accuracy <= run.impact.requested_accuracy);
  const auto last = velocities(run.impact), expected = velocities(unsampled);
  const double speed = std::abs(*std::max_element(
      expected.begin(), expected.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  BOOST_TEST(difference(last, expected) <= 2 * run.impact.requested_accuracy * speed);
  BOOST_TEST(difference(run.samples.back().velocity, last) <= 4 * epsilon * speed);
  BOOST_TEST(run.samples.front().time == 0);
  for (std::size_t k = 1; k < run.samples.size(); ++k)
    BOOST_TEST(run.samples[k].time > run.samples[k - 1].time);
}

constexpr hybrid::Options loose{.accuracy = 1e-7};

}  // namespace

BOOST_AUTO_TEST_CASE(samples_of_a_rattling_chain_are_as_accurate_as_asked) {
  samples_belong_to_the_run_that_stays(sampled(rattling(), loose, 5, 1), impact::simulate(rattling(), loose));
}

BOOST_AUTO_TEST_CASE(so_are_those_of_one_that_flies_as_a_whole) {
  auto chain = rattling();
  for (double& v : chain.velocity) v += 30;
  samples_belong_to_the_run_that_stays(sampled(chain, loose, 5, 1), impact::simulate(chain, loose));
}

BOOST_AUTO_TEST_CASE(so_are_those_of_a_network) {
  const auto network = model::as_network(rattling());
  samples_belong_to_the_run_that_stays(sampled(network, loose, 5, 1), impact::simulate(network, loose));
}

BOOST_AUTO_TEST_CASE(so_are_those_of_a_body_that_strikes_twice) {
  std::mt19937 random(5);
  int checked = 0;
  while (checked < 3) {
    const auto body = random_body(random);
    const auto impact = impact::simulate(body, loose);
    if (!impact.estimated_accuracy || *impact.estimated_accuracy > loose.accuracy) continue;
    samples_belong_to_the_run_that_stays(sampled(body, loose, 3, impact.final.time / 9.5), impact);
    ++checked;
  }
}

BOOST_AUTO_TEST_CASE(so_are_those_of_bodies) {
  support::Scenes scenes(7);
  int checked = 0;
  while (checked < 3) {
    const auto bodies = scenes.heap();
    const auto impact = impact::simulate(bodies, loose);
    if (!impact.estimated_accuracy || *impact.estimated_accuracy > loose.accuracy) continue;
    samples_belong_to_the_run_that_stays(sampled(bodies, loose, 8, impact.time / 9.5), impact);
    ++checked;
  }
}

BOOST_AUTO_TEST_CASE(a_single_wave_is_sampled_once) {
  const auto run = sampled(equal_chain(5), {}, 5, 0.1);
  BOOST_TEST(run.restarts == 0);
  BOOST_TEST(!run.impact.estimated_accuracy);
}

BOOST_AUTO_TEST_CASE(a_sampling_that_is_not_told_sees_the_runs_one_after_the_other) {
  int starts = 0;
  const impact::Sampling sampling{.take = [&](const impact::Sample& sample) {
    if (sample.time == 0) ++starts;
    return infinity;
  }};
  impact::simulate(rattling(), loose, {.samplings = {sampling}});
  BOOST_TEST(starts == 2);
}
