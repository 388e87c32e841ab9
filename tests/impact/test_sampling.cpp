#define BOOST_TEST_MODULE sampling
#include <boost/test/unit_test.hpp>
#include <numeric>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/island_scenes.hpp"
#include "support/reference.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

using impact::RunObserver;
using impact::Sample;
using impact::Sampling;

std::vector<Index> all(std::size_t count) {
  std::vector<Index> places(count);
  std::iota(places.begin(), places.end(), 0);
  return places;
}

/// Samples of all balls and contacts at one interval.
std::vector<Sample> sampled(const model::Chain& chain, const hybrid::Options& options, double interval) {
  std::vector<Sample> samples;
  const Sampling sampling{.velocities = all(chain.mass.size()),
                          .contacts = all(chain.law.size()),
                          .take =
                              [&](const Sample& sample) {
                                samples.push_back(sample);
                                return interval;
                              },
                          .restart = [&] { samples.clear(); }};
  impact::simulate(chain, options, RunObserver{.samplings = {sampling}});
  return samples;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sample_is_what_a_run_until_then_ends_with) {
  IslandSceneMaker maker(1834);
  for (int i = 0; i < 3 * island_scene_kinds; ++i) {
    const auto chain = maker.make(static_cast<IslandScene>(i % island_scene_kinds));
    const auto samples = sampled(chain, {.accuracy = 1e-10, .max_time = 12}, 2.5);
    BOOST_TEST_CONTEXT("scene " << i << ", " << chain.mass.size() << " balls") {
      BOOST_TEST(samples.front().time == 0);
      BOOST_TEST(difference(samples.front().velocity, chain.velocity) < 1e-15);
      for (std::size_t k = 1; k < samples.size(); ++k) {
        const auto run = impact::simulate(
            chain, {.accuracy = 1e-10, .max_time = samples[k].time, .islands = hybrid::Islands::never});
        BOOST_TEST(difference(samples[k].velocity, run.velocity) < 1e-7);
        BOOST_TEST(difference(samples[k].gap, run.gap) < 1e-6);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(forces_of_samples_accelerate_the_balls) {
  auto chain = equal_chain(100);
  chain.velocity[99] = -0.5;
  constexpr double interval = 1e-3;
  const auto samples = sampled(chain, {.accuracy = 1e-12, .max_time = 20}, interval);
  for (std::size_t k = 1; k + 2 < samples.size(); k += 100)
    for (std::size_t i = 1; i < 99; ++i) {
      const double acceleration = (samples[k + 1].velocity[i] - samples[k - 1].velocity[i]) / (2 * interval);
      BOOST_TEST(std::abs(acceleration - (samples[k].force[i - 1] - samples[k].force[i])) < 1e-5);
    }
}

// Nesterenko's wave by its fastest ball; the top of a parabola through three samples.
BOOST_AUTO_TEST_CASE(the_peak_velocity_of_a_solitary_wave) {
  std::vector<double> v;
  const Sampling sampling{.velocities = {500}, .contacts = {}, .take = [&](const Sample& sample) {
                            v.push_back(sample.velocity[0]);
                            return 0.01;
                          }};
  impact::simulate(equal_chain(600), {.accuracy = 1e-10}, RunObserver{.samplings = {sampling}});
  const auto top = std::max_element(v.begin(), v.end());
  const double rise = top[0] - top[-1], fall = top[0] - top[1];
  const double peak = top[0] + (rise - fall) * (rise - fall) / (8 * (rise + fall));
  BOOST_TEST(std::abs(peak - 0.681632) < 6e-7);
  constexpr double speed = 0.840508772850721;  // contacts per unit of time
  BOOST_TEST(std::abs(speed / std::pow(peak, 0.2) - 0.907470) < 6e-7);
}

BOOST_AUTO_TEST_CASE(each_sampling_has_its_own_times_and_the_ending) {
  std::vector<double> often, seldom;
  const auto every = [](std::vector<double>& times, double interval) {
    return Sampling{.velocities = {0}, .contacts = {}, .take = [&times, interval](const Sample& sample) {
                      times.push_back(sample.time);
                      return interval;
                    }};
  };
  const auto impact =
      impact::simulate(equal_chain(3), {}, RunObserver{.samplings = {every(often, 1), every(seldom, 3)}});
  BOOST_TEST(often.size() == 1 + std::ceil(impact.time));
  BOOST_TEST(seldom.size() == 1 + std::ceil(impact.time / 3));
  BOOST_TEST(often.back() == impact.time);
  BOOST_TEST(seldom.back() == impact.time);
}

// A chain's samples come from its islands, a network's from the steps of one system.
BOOST_AUTO_TEST_CASE(a_chain_has_the_same_samples_as_a_network) {
  const auto chain = equal_chain(5);
  const auto take = [](std::vector<Sample>& samples) {
    return RunObserver{
        .samplings = {{.velocities = all(5), .contacts = all(4), .take = [&](const Sample& one) {
                         samples.push_back(one);
                         return 0.37;
                       }}}};
  };
  std::vector<Sample> expected, found;
  impact::simulate(chain, {.accuracy = 1e-12}, take(expected));
  const auto impact = impact::simulate(model::as_network(chain), {.accuracy = 1e-12}, take(found));
  BOOST_REQUIRE(found.size() == expected.size());
  BOOST_TEST(found.back().time == impact.time);
  for (std::size_t k = 0; k < found.size(); ++k) {
    BOOST_TEST(std::abs(found[k].time - expected[k].time) < 1e-9);
    BOOST_TEST(difference(found[k].velocity, expected[k].velocity) < 1e-10);
    BOOST_TEST(difference(found[k].gap, expected[k].gap) < 1e-9);
    BOOST_TEST(difference(found[k].force, expected[k].force) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(a_sample_of_a_body_is_what_a_run_until_then_ends_with) {
  const auto body = microbody(body_cases("rod_tilt.json")[3]);
  const double duration = impact::simulate(body).final.time;
  std::vector<Sample> samples;
  impact::simulate(
      body, {.accuracy = 1e-12},
      RunObserver{.samplings = {{.velocities = all(3), .contacts = {0}, .take = [&](const Sample& one) {
                                   samples.push_back(one);
                                   return duration / 7.5;
                                 }}}});
  BOOST_REQUIRE(samples.size() == 9u);
  double strongest = 0;
  for (const auto& sample : samples) {
    strongest = std::max(strongest, sample.force[0]);
    if (sample.time == 0) continue;
    const auto run = impact::simulate(body, {.accuracy = 1e-12, .max_time = sample.time});
    const auto& v = run.final.velocity;
    BOOST_TEST(difference(sample.velocity, {v.e1, v.e2, v.e3}) < 1e-10 * norm(body.velocity));
  }
  BOOST_TEST(strongest > 0);
}

BOOST_AUTO_TEST_CASE(samplings_without_sense_are_refused) {
  const auto take = [](const Sample&) { return 1.0; };
  const auto chain = equal_chain(3);
  const auto run = [&](const Sampling& sampling) {
    impact::simulate(chain, {}, RunObserver{.samplings = {sampling}});
  };
  BOOST_CHECK_THROW(run({.velocities = {3}, .contacts = {}, .take = take}), InvalidParameter);
  BOOST_CHECK_THROW(run({.velocities = {}, .contacts = {-1}, .take = take}), InvalidParameter);
  BOOST_CHECK_THROW(run({.velocities = {}, .contacts = {}, .take = [](const Sample&) { return 0.0; }}),
                    InvalidParameter);
}

BOOST_AUTO_TEST_CASE(a_long_chain_tells_how_far_it_is) {
  double time = 0;
  Index events = 0;
  const auto impact =
      impact::simulate(equal_chain(60), {}, RunObserver{.progress = [&](const auto& progress) {
                         BOOST_TEST(progress.time >= time);
                         time = progress.time;
                         events = progress.events;
                       }});
  BOOST_TEST(time > 0.9 * impact.time);
  BOOST_TEST(events > 50);
}

BOOST_AUTO_TEST_CASE(the_trace_of_a_long_chain_is_sampled) {
  const auto impact = impact::simulate(equal_chain(60), {}, {.trace = true});
  const auto& trace = impact.trace;
  BOOST_TEST(trace.time.size() > 200u);
  BOOST_TEST(trace.time.back() == impact.time);
  BOOST_TEST(difference(trace.velocity.back(), impact.velocity) < 1e-12);
  BOOST_TEST(difference(trace.gap.back(), impact.gap) < 1e-9);
  double peak = 0;
  for (const auto& row : trace.force) peak = std::max(peak, row[30]);
  BOOST_TEST(peak > 0.95 * impact.contacts[30].peak_force);
  BOOST_TEST(peak < impact.contacts[30].peak_force * (1 + 1e-9));
}
