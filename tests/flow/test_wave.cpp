#define BOOST_TEST_MODULE waves
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/flow/roots/enclosure.hpp"

using namespace mariotte;
using flow::NaturalMode;
using flow::Wave;
using flow::Weight;
using Form = NaturalMode::Form;

namespace {

NaturalMode undamped(double frequency) {
  return {Form::oscillating, 0, frequency};
}
/// R sin(ω t + φ).
Weight sine(double radius, double frequency, double phase) {
  return {radius * std::sin(phase), radius * std::cos(phase) * frequency};
}

/// Modes of every form, with rates over 2 decades.
NaturalMode random_mode(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double rate = std::pow(10, 2 * uniform(random) - 0.5);
  switch (std::uniform_int_distribution(0, 4)(random)) {
    case 0:
      return undamped(rate);
    case 1:
      return {Form::oscillating, 0.3 * uniform(random) * rate, rate};
    case 2:
      return {Form::oscillating, 0.02 * rate, 1e-3 * uniform(random)};
    case 3:
      return {Form::creeping, 0.05 * rate, 0.05 * rate * (1 + uniform(random))};
    default:
      return {Form::separate, 0.02 * uniform(random), rate};
  }
}

/// Four modes that start large and a straight line, positive at the start.
struct RandomWave {
  std::vector<NaturalMode> modes;
  Wave wave{1, 0, {}};

  explicit RandomWave(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    wave.slope = 0.03 * uniform(random);
    for (int k = 0; k < 4; ++k) {
      modes.push_back(random_mode(random));
      const double size = modes[k].form == Form::separate ? 1 : modes[k].fastest();
      wave.weight.push_back({0.8 * uniform(random), 0.8 * uniform(random) * size});
    }
  }
  double operator()(double time) const { return wave.at(modes, time); }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_first_root_of_a_wave_is_found_however_short_its_visit) {
  // 1 − depth − cos t falls below zero for 2√(2 depth) only, once per turn.
  for (const double depth : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    const Wave wave{1 - depth, 0, {{-1, 0}}};
    const auto root = flow::first_fall(wave, {undamped(1)}, 0.5, 30);
    BOOST_REQUIRE(root.has_value());
    BOOST_TEST(std::abs(*root - (2 * std::acos(-1.0) - std::acos(1 - depth))) < 1e-9);
  }
}

// It falls all along an interval that is ten million times as long as the time to its root, where Newton's
// steps change little from one to the next.
BOOST_AUTO_TEST_CASE(a_root_is_found_early_in_an_interval_however_long) {
  const std::vector<NaturalMode> modes = {{Form::separate, 7.12285e-07, 0.0663098},
                                          {Form::oscillating, 0.0505483, 1.06559}};
  const Wave wave{-0.6, -1.2, {{2.75e-05, 0.82}, {-0.187, 0.9}}};
  for (const double end : {0.5, 50.0, 4.5e6, 4.5e12}) {
    const auto root = flow::first_fall(wave, modes, 0, end);
    BOOST_REQUIRE(root.has_value());
    BOOST_TEST(std::abs(wave.at(modes, *root)) < 1e-15, end);
  }
}

BOOST_AUTO_TEST_CASE(a_wave_that_only_comes_near_zero_has_no_root) {
  for (const double distance : {1e-1, 1e-4, 1e-8, 1e-12}) {
    const Wave wave{1 + 1e-3 + distance, 0, {sine(1, 1, 0.3), sine(1e-3, 977, 0)}};
    BOOST_TEST(!flow::first_fall(wave, {undamped(1), undamped(977)}, 0, 300).has_value());
  }
}

BOOST_AUTO_TEST_CASE(the_earliest_of_many_roots_is_found) {
  std::mt19937_64 random(11);
  int found = 0;
  for (int i = 0; i < 600; ++i) {
    const RandomWave wave(random);
    if (wave(0) <= 0) continue;
    const double end = 20;
    std::optional<double> sampled;
    double last = wave(0);
    for (int k = 1; k <= 50000 && !sampled; ++k) {
      const double value = wave(end * k / 50000);
      if (last > 0 && value <= 0) sampled = end * k / 50000;
      last = value;
    }
    const auto root = flow::first_fall(wave.wave, wave.modes, 0, end);
    if (sampled) BOOST_REQUIRE(root.has_value());
    if (!root) continue;
    ++found;
    BOOST_TEST(std::abs(wave(*root)) < 1e-12);
    if (sampled) BOOST_TEST(*root <= *sampled);
  }
  BOOST_TEST(found > 100);
}

BOOST_AUTO_TEST_CASE(the_highest_of_many_summits_is_found) {
  std::mt19937_64 random(12);
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    const RandomWave wave(random);
    const double end = 20;
    double sampled = std::max(wave(0), wave(end));
    for (int k = 1; k < 20000; ++k) sampled = std::max(sampled, wave(end * k / 20000));
    const auto summit = flow::highest(wave.wave, wave.modes, 0, end);
    const double found = summit ? wave(summit->time) : std::max(wave(0), wave(end));
    inside += summit.has_value();
    BOOST_TEST_CONTEXT("wave " << i) BOOST_TEST(found >= sampled - 1e-13);
    if (summit) BOOST_TEST(std::abs(wave.wave.slope_at(wave.modes, summit->time).rate) < 1e-5);
  }
  BOOST_TEST(inside > 100);
}

BOOST_AUTO_TEST_CASE(bounds_of_a_wave_hold_over_any_interval) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const RandomWave wave(random);
    const double from = 10 * uniform(random), length = std::pow(10, 4 * uniform(random) - 3);
    const flow::Enclosure enclosure(wave.wave, wave.modes, from, from + length);
    const auto value = enclosure.value(), rate = enclosure.rate(), bend = enclosure.bend();
    for (int k = 0; k <= 50; ++k) {
      const double time = from + length * k / 50;
      const double v = wave(time), slope = wave.wave.slope_at(wave.modes, time).rate * length;
      double curve = 0;
      for (std::size_t m = 0; m < wave.modes.size(); ++m) {
        const auto& mode = wave.modes[m];
        const auto twice = flow::derivative(mode, flow::derivative(mode, wave.wave.weight[m]));
        curve += length * length * flow::dot(twice, flow::swing(mode, time).value);
      }
      BOOST_TEST(v >= value.low - 1e-12);
      BOOST_TEST(v <= value.high + 1e-12);
      BOOST_TEST(slope >= rate.low - 1e-12 * (1 + length));
      BOOST_TEST(slope <= rate.high + 1e-12 * (1 + length));
      const double noise = 1e-10 * (1 + length * length);
      BOOST_TEST(curve >= bend.low - noise);
      BOOST_TEST(curve <= bend.high + noise);
    }
  }
}

BOOST_AUTO_TEST_CASE(overlaps_are_the_integrals_of_products) {
  std::mt19937_64 random(14);
  for (int i = 0; i < 200; ++i) {
    const NaturalMode left = random_mode(random), right = i % 5 == 0 ? left : random_mode(random);
    for (const double end : {1e-3, 0.1, 3.0}) {
      const auto exact = flow::overlap(flow::progress(left, end), flow::progress(right, end), end);
      flow::Overlap sum{};
      const int pieces = 4000;  // Simpson's rule
      for (int k = 0; k <= pieces; ++k) {
        const double share = end / pieces / 3 * (k == 0 || k == pieces ? 1 : k % 2 == 0 ? 2 : 4);
        const auto l = flow::swing(left, end * k / pieces).value,
                   r = flow::swing(right, end * k / pieces).value;
        sum.even_even += share * l.even * r.even;
        sum.even_odd += share * l.even * r.odd;
        sum.odd_even += share * l.odd * r.even;
        sum.odd_odd += share * l.odd * r.odd;
      }
      BOOST_TEST_CONTEXT("pair " << i << " to " << end) {
        BOOST_TEST(std::abs(exact.even_even - sum.even_even) < 1e-8 * end);
        BOOST_TEST(std::abs(exact.even_odd - sum.even_odd) < 1e-8 * end);
        BOOST_TEST(std::abs(exact.odd_even - sum.odd_even) < 1e-8 * end);
        BOOST_TEST(std::abs(exact.odd_odd - sum.odd_odd) < 1e-8 * end);
      }
    }
  }
}
