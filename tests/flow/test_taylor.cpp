#define BOOST_TEST_MODULE the Taylor flow
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "mariotte/flow/taylor/taylor_lanes.hpp"
#include "mariotte/flow/taylor/taylor_start.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;
using namespace mariotte::flow::taylor;

namespace {

impact::ChainImpact by_taylor(const model::Chain& chain, double accuracy) {
  return impact::simulate(chain, {.accuracy = accuracy, .flow = flow::Kind::taylor});
}

bool used(const impact::ChainImpact& impact, const std::string& flow) {
  return std::any_of(impact.flows.begin(), impact.flows.end(), [&](const auto& f) { return f.name == flow; });
}

/// What loads have beside k δ: nothing, c δ̇, or other dampers as well, without and with powers of δ.
enum class Load { elastic, viscous, multiplied, steep };
constexpr Load loads[] = {Load::elastic, Load::viscous, Load::multiplied, Load::steep};

/// Dampers of every kind, one after the other.
void mix_dampers(Lanes& lanes, Load load) {
  lanes.mixed = true;
  lanes.general = load == Load::steep;
  for (int j = 0; j < lanes.count; ++j) {
    if (j % 3 == 0) std::swap(lanes.damping[j], lanes.stiffening[j]);
    if (j % 3 != 1 || load != Load::steep) continue;
    std::swap(lanes.stiffness[j], lanes.steepening[j]);
    lanes.power[j] = 0.25;
  }
}

/// Contacts of any law, indentation and rate, all pushing.
Lanes random_lanes(int count, std::mt19937& random, Load load) {
  std::uniform_real_distribution<double> unit(0, 1);
  Lanes lanes;
  lanes.resize(count);
  lanes.damped = load != Load::elastic;
  for (int j = 0; j < count; ++j) {
    lanes.indentation[j] = 0.1 + unit(random);
    lanes.rate[j] = 2 * unit(random) - 1;
    lanes.active[j] = lanes.weight[j] = lanes.side[j] = lanes.load_side[j] = 1;
    lanes.stiffness[j] = 0.5 + unit(random);
    lanes.damping[j] = lanes.damped ? unit(random) : 0;
    lanes.power[j] = unit(random) < 0.7 ? 0.5 : 0;
    lanes.left[j] = 0.5 + unit(random);
    lanes.right[j] = 0.5 + unit(random);
  }
  if (load == Load::multiplied || load == Load::steep) mix_dampers(lanes, load);
  return lanes;
}

double polynomial(const Expansion& series, Quantity quantity, int lane, int order, double place) {
  double c[order_limit + 1], sum = 0;
  series.coefficients(quantity, lane, c);
  for (int k = order; k >= 0; --k) sum = sum * place + c[k];
  return sum;
}

/// What the rounding of a polynomial is relative to.
double size_of_terms(const Expansion& series, Quantity quantity, int lane, int order, double place) {
  double c[order_limit + 1], sum = 0;
  series.coefficients(quantity, lane, c);
  for (int k = order; k >= 0; --k) sum = sum * place + std::abs(c[k]);
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_series_satisfies_the_equations_of_motion) {
  std::mt19937 random(7);
  for (const auto load : loads) {
    const auto lanes = random_lanes(7, random, load);
    for (const int clock : {Expansion::plain, 3}) {
      if (clock >= 0 && (lanes.power[clock] == 0 || lanes.general)) continue;
      const auto series = make_expansion(1);
      constexpr int order = 18;
      series->expand(lanes, order, clock);
      // At a small place, dδ/dσ = g δ̇ and dδ̇/dσ = g (…), by central differences of the polynomials.
      const double at = 0.02, step = 1e-4;
      double force[9] = {};
      for (int j = 0; j < 7; ++j) {
        const double depth = polynomial(*series, Quantity::indentation, j, order, at);
        const double rate = polynomial(*series, Quantity::rate, j, order, at),
                     root = std::pow(depth, lanes.power[j]);
        force[j + 1] = root * ((lanes.stiffness[j] + lanes.steepening[j] * root) * depth +
                               (lanes.damping[j] + lanes.stiffening[j] * depth) * rate);
      }
      const double g = polynomial(*series, Quantity::clock, 0, order, at);
      for (int j = 0; j < 7; ++j) {
        const auto slope = [&](Quantity q) {
          return (polynomial(*series, q, j, order, at + step) - polynomial(*series, q, j, order, at - step)) /
                 (2 * step);
        };
        const double push =
            lanes.left[j] * (force[j] - force[j + 1]) + lanes.right[j] * (force[j + 2] - force[j + 1]);
        BOOST_TEST(std::abs(slope(Quantity::indentation) -
                            g * polynomial(*series, Quantity::rate, j, order, at)) < 1e-6);
        BOOST_TEST(std::abs(slope(Quantity::rate) - g * push) < 1e-6);
      }
    }
  }
}

/// For each instruction set of this machine. Long rows are expanded in blocks.
std::vector<std::unique_ptr<Expansion>> expansions(std::size_t size) {
  std::vector<std::unique_ptr<Expansion>> all;
  all.push_back(make_expansion(size));
#ifdef __x86_64__
  if (mariotte::flow::has_avx2()) all.push_back(avx2::make_expansion(size));
#endif
  all.push_back(baseline::make_expansion(size));
  all.push_back(baseline::make_expansion(lane_sizes.size()));
  return all;
}

BOOST_AUTO_TEST_CASE(every_instruction_set_gives_the_same_series) {
  std::mt19937 random(3);
  for (std::size_t size = 0; size < lane_sizes.size(); ++size) {
    const int count = lane_sizes[size] - 1;
    for (const auto load : loads) {
      const auto lanes = random_lanes(count, random, load);
      const auto all = expansions(size);
      Values a, b;
      a.resize(count);
      b.resize(count);
      for (const auto& one : all)
        for (const int clock :
             {Expansion::plain, lanes.power[1] > 0 && !lanes.general ? 1 : Expansion::plain}) {
          one->expand(lanes, 16, clock);
          all.back()->expand(lanes, 16, clock);
          one->evaluate(0.1, a);
          all.back()->evaluate(0.1, b);
          BOOST_TEST(std::abs(a.time - b.time) < 1e-15);
          for (int j = 0; j < count; ++j) {
            BOOST_TEST(std::abs(a.indentation[j] - b.indentation[j]) < 1e-14);
            BOOST_TEST(std::abs(a.impulse[j] - b.impulse[j]) < 1e-14);
            BOOST_TEST(std::abs(a.margin[j] - b.margin[j]) < 1e-12);
          }
        }
    }
  }
}

BOOST_AUTO_TEST_CASE(margins_are_lower_bounds) {
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    const auto lanes = random_lanes(4, random, loads[1 + i % 3]);
    const auto series = make_expansion(0);
    series->expand(lanes, 14, Expansion::plain);
    const double end = 0.01 * (1 + i % 60);
    Values values;
    values.resize(4);
    series->evaluate(end, values);
    for (int j = 0; j < 4; ++j)
      for (int part = 0; part <= 50; ++part) {
        const double place = end * part / 50;
        for (const auto& [margin, quantity] : {std::pair(values.margin[j], Quantity::indentation),
                                               std::pair(values.load_margin[j], Quantity::load)})
          BOOST_TEST(margin <= polynomial(*series, quantity, j, 14, place) +
                                   1e-14 * std::max(1.0, size_of_terms(*series, quantity, j, 14, place)));
      }
  }
}

BOOST_AUTO_TEST_CASE(a_single_contact_agrees_with_its_closed_form) {
  for (const double ratio : {1.0, 1e-3, 1e3}) {
    auto chain = equal_masses({contact::Hertz{2}}, {1, -0.5});
    chain.mass = {1, ratio};
    const auto series = by_taylor(chain, 1e-14), exact = impact::simulate(chain, {.accuracy = 1e-14});
    BOOST_TEST(used(series, "taylor"));
    BOOST_TEST(used(exact, "pair"));
    BOOST_TEST(difference(series.velocity, exact.velocity) < 1e-14);
    BOOST_TEST(std::abs(series.time / exact.time - 1) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(asked_is_got_on_the_reference_triplets) {
  for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14})
    for (const auto& c : cases("triplets.json")) {
      const auto impact = by_taylor(triplet(c), accuracy);
      BOOST_TEST(difference(impact.velocity, c.at("final").get<Numbers>()) <= accuracy);
      BOOST_TEST(used(impact, "taylor"));
    }
}

BOOST_AUTO_TEST_CASE(asked_is_got_on_the_reference_chains) {
  for (const double accuracy : {1e-6, 1e-10, 1e-14})
    for (const auto& c : cases("equal_chains.json")) {
      const auto impact = by_taylor(equal_chain(c.at("n")), accuracy);
      BOOST_TEST(difference(impact.velocity, c.at("final").get<Numbers>()) <= accuracy);
    }
}

// What is struck hardly, and presses its neighbour hardly, while another one presses it hard a little later:
// the series of its first moments hold for very short times only.
BOOST_AUTO_TEST_CASE(a_row_that_is_struck_hard_at_one_end_and_hardly_at_the_other) {
  const Numbers mass{0.047957042224623915, 0.3584383742558255, 0.340463246512923, 22.79295389470362,
                     0.05735043339431001};
  const std::vector<contact::Law> law = {contact::Hertz{63.503042175936855},
                                         contact::Hertz{784.0461689108267}, contact::Hertz{20.02931214235928},
                                         contact::Hertz{7.926153784416003}};
  for (const double last : {-1e-3, -1e-5, -1e-7, -1e-10}) {
    const model::Chain chain{
        .mass = mass, .law = law, .gap = Numbers(4, 0.0), .velocity = {1, 0, 0, 0, last}};
    const auto cvode = impact::simulate(chain, {.accuracy = 1e-10, .flow = flow::Kind::cvode_adams});
    for (const double accuracy : {1e-4, 3e-5, 1e-5, 1e-7, 1e-9})
      BOOST_TEST_CONTEXT(last << " at " << accuracy)
    BOOST_TEST(difference(by_taylor(chain, accuracy).velocity, cvode.velocity) < accuracy);
  }
}

BOOST_AUTO_TEST_CASE(any_exponent_and_any_mixture_agrees_with_cvode) {
  const contact::Law laws[] = {contact::Hertz{1},
                               contact::Linear{2},
                               contact::Viscoelastic{.stiffness = 1, .damping = 0.3, .exponent = 1},
                               contact::Viscoelastic{.stiffness = 1.5, .damping = 0.2, .exponent = 1.5},
                               contact::Viscoelastic{.stiffness = 1, .damping = 0.1, .exponent = 2},
                               contact::Viscoelastic{.stiffness = 1, .damping = 0, .exponent = 1.75}};
  for (const auto& first : laws)
    for (const auto& second : laws) {
      auto chain = equal_masses({first, second, contact::Hertz{0.7}}, {1, 0.1, 0, -0.4});
      chain.gap = {0, 0.2, 0.1};
      const auto series = by_taylor(chain, 1e-9),
                 cvode = impact::simulate(chain, {.accuracy = 1e-10, .flow = flow::Kind::cvode_adams});
      BOOST_TEST(used(series, "taylor"));
      BOOST_TEST(difference(series.velocity, cvode.velocity) < 2e-9);
      BOOST_TEST(period_counts(series) == period_counts(cvode), boost::test_tools::per_element());
    }
}

BOOST_AUTO_TEST_CASE(a_contact_that_sinks_and_comes_back_is_felt) {
  // Gravity draws the ball off the wall that it is thrown against: without its force the contact would open
  // again within the first step.
  int dampers = 0;
  for (const double exponent : {1.2, 1.5, 1.77, 2.5})
    for (const double damping : {0.0, 1e-3, 2.7})
      for (const double speed : {1e-3, 0.1, 1.0}) {
        model::Chain chain{.mass = {0.9, infinity},
                           .law = {contact::Viscoelastic{1, damping, exponent}},
                           .gap = {0},
                           .velocity = {speed, 0},
                           .gravity = 1};
        const auto impact = impact::simulate(chain);
        const auto cvode = impact::simulate(chain, {.flow = flow::Kind::cvode_adams});
        BOOST_TEST_CONTEXT("exponent " << exponent << " damping " << damping << " speed " << speed) {
          BOOST_TEST((impact.ending == hybrid::Ending::separated));
          BOOST_TEST(std::abs(impact.contacts[0].impulse - cvode.contacts[0].impulse) < 1e-7 * speed);
          BOOST_TEST(std::abs(impact.velocity[0] - cvode.velocity[0]) < 1e-8 * speed);
        }
        dampers += used(impact, "taylor");
      }
  BOOST_TEST(dampers > 30);
}

BOOST_AUTO_TEST_CASE(a_contact_that_sinks_before_a_ball_comes_from_outside_is_felt) {
  // The last contact opens and would then pull, so that the third, whose force is left out at first, would
  // have opened again at the end of the first step; that step is cut where the first two balls meet.
  for (const double depth : {1e-13, 1e-10})
    for (const double accuracy : {1e-6, 1e-8, 1e-10}) {
      auto chain =
          equal_masses({contact::Hertz{1}, contact::Linear{1e-3}, contact::Hertz{2}, contact::Linear{1e-4}},
                       {3, 1, 1, 0.9, 30});
      chain.gap = {2, 1000, -depth, -70};
      chain.precompressed = true;
      const auto impact = impact::simulate(chain, {.accuracy = accuracy});
      const auto cvode = impact::simulate(chain, {.accuracy = 1e-12, .flow = flow::Kind::cvode_adams});
      BOOST_TEST(used(impact, "taylor"));
      BOOST_TEST(difference(impact.velocity, cvode.velocity) < 29 * accuracy);
    }
}

BOOST_AUTO_TEST_CASE(a_root_without_a_branch_point_does_not_spoil_a_step) {
  // Behind a damped linear contact a ball is pressed as t²: the root of its depth is a power of t but for
  // rounding, which long steps would magnify. Some accuracies have steps in which the last orders hide it.
  for (const double damping : {0.1, 0.3, 0.5, 1.0, 3.0}) {
    const model::Chain chain{.mass = {8, 0.6, 5},
                             .law = {contact::Viscoelastic{15, damping, 1}, contact::Hertz{90}},
                             .gap = {0, 0},
                             .velocity = {1, 0, 0}};
    const auto cvode = impact::simulate(chain, {.accuracy = 1e-13, .flow = flow::Kind::cvode_adams});
    double worst = 0;
    for (int i = 0; i < 100; ++i) {
      const auto series = impact::simulate(chain, {.accuracy = 1e-14 * std::pow(1.03, i)});
      BOOST_REQUIRE(used(series, "taylor"));
      worst = std::max(worst, difference(series.velocity, cvode.velocity));
    }
    BOOST_TEST(worst < 3e-12, "damping " << damping << ": " << worst);
  }
}
