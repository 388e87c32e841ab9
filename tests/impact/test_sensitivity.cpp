// Slopes of the outcome by every parameter, against numbers computed elsewhere in extended precision, against
// differences of runs, and against what follows from symmetry and dimensions alone.
#define BOOST_TEST_MODULE sensitivity
#include <boost/test/unit_test.hpp>
#include <numbers>
#include <random>

#include "mariotte/contact/uncut.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/sensitivity/push_expansion.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "support/reference_laws.hpp"

using namespace mariotte;
using impact::parameters;
using impact::Sensitivity;
using impact::sensitivity;

namespace {

std::vector<nlohmann::json> cases(const std::string& file) {
  std::ifstream in(std::string(MARIOTTE_TEST_DATA) + "/sensitivity/" + file);
  return nlohmann::json::parse(in).get<std::vector<nlohmann::json>>();
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

std::vector<double> expected(const nlohmann::json& derivative, const impact::OutcomeSlopes& outcome) {
  const auto& list = derivative.at(outcome.name);
  return test::sizes(outcome.index ? list.at(*outcome.index) : list);
}

double slope(const Sensitivity& s, const std::string& outcome, Index index, const std::string& parameter) {
  for (const auto& one : s.outcome)
    for (std::size_t c = 0; c < s.parameter.size(); ++c)
      if (one.name == outcome && one.index.value_or(0) == index && s.parameter[c].name == parameter)
        return one.slope[c].value();
  throw std::runtime_error("no slope of " + outcome + " by " + parameter);
}

/// A row of linear and Hertz contacts whose slopes are power series: some Hertz contacts touch, some are
/// damped, some rows end at a wall.
model::Chain random_row(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const int balls = 3 + static_cast<int>(random() % 3);
  const bool damped = random() % 2, ends_at_wall = random() % 3 == 0;
  model::Chain chain;
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(between(0.4, 2.5));
    chain.velocity.push_back(i == 0 ? between(0.8, 1.5) : 0);
    if (i == 0) continue;
    const bool touches = random() % 2;
    const double exponent = touches || random() % 2 ? 1.5 : 1;
    chain.gap.push_back(touches ? 0 : between(0.02, 0.3));
    chain.law.push_back(contact::PowerLaw{between(0.5, 4), damped ? between(0.02, 0.3) : 0, exponent});
  }
  if (ends_at_wall) chain.mass.back() = infinity;
  if (!ends_at_wall && random() % 2) chain.gravity = 0.05;
  return chain;
}

/// Random masses, speeds and gaps; laws without branches.
model::Chain random_chain(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const int balls = 3 + static_cast<int>(random() % 3);
  model::Chain chain;
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(between(0.4, 2.5));
    chain.velocity.push_back(i == 0 ? between(0.8, 1.5) : between(-0.3, 0.3));
    if (i == 0) continue;
    chain.gap.push_back(between(0.02, 0.3));
    const double exponent = std::vector{1.0, 1.5, 1.25}[random() % 3];
    const double damping = random() % 2 ? between(0.02, 0.3) : 0;
    chain.law.push_back(contact::PowerLaw{between(0.5, 4), damping, exponent});
  }
  return chain;
}

}  // namespace

BOOST_AUTO_TEST_CASE(slopes_of_chains_are_those_of_the_references) {
  for (const auto& c : cases("chains.json")) {
    const auto chain = test::chain_of(c.at("inputs"));
    const auto found = sensitivity(chain, parameters(chain), {.accuracy = 1e-10});
    const auto names = c.at("parameters").get<std::vector<std::string>>();
    BOOST_TEST_REQUIRE(found.parameter.size() == names.size());
    for (std::size_t k = 0; k < names.size(); ++k) BOOST_TEST(found.parameter[k].name == names[k]);
    for (const auto& outcome : found.outcome) {
      if (outcome.name == "dissipated") continue;  // has a test of its own
      const auto reference = expected(c.at("derivative"), outcome);
      for (std::size_t k = 0; k < names.size(); ++k)
        BOOST_TEST_CONTEXT(outcome.name << outcome.index.value_or(0) << " by " << names[k])
      // Relative to the largest slope of the outcome: velocities at which adhesion lets go are good to 1e-9.
      BOOST_TEST(std::abs(outcome.slope[k].value() - reference[k]) <= 1e-8 * largest(reference));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_row_that_moves_as_a_whole_only_moves) {
  std::mt19937 random(7);
  for (int n = 0; n < 20; ++n) {
    const auto chain = random_chain(random);
    const auto found = sensitivity(chain, parameters(chain));
    for (std::size_t i = 0; i < chain.mass.size(); ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < chain.mass.size(); ++k)
        sum += slope(found, "velocity", static_cast<Index>(i), "velocity[" + std::to_string(k) + "]");
      BOOST_TEST(std::abs(sum - 1) <= 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(slopes_obey_the_units_of_mass_length_and_time) {
  std::mt19937 random(11);
  for (int n = 0; n < 20; ++n) {
    const auto chain = random_chain(random);
    const auto found = sensitivity(chain, parameters(chain));
    // Exponents of mass, length and time of each parameter; c δⁿ⁻¹ δ̇ and k δⁿ are forces.
    const auto dimension = [&](const std::string& name) -> std::array<double, 3> {
      if (name.starts_with("mass")) return {1, 0, 0};
      if (name.starts_with("velocity")) return {0, 1, -1};
      if (name.starts_with("gap")) return {0, 1, 0};
      const auto& law = std::get<contact::PowerLaw>(chain.law[name[8] - '0']);
      if (name.ends_with("stiffness")) return {1, 1 - law.exponent, -2};
      return {1, 1 - law.exponent, -1};
    };
    for (const auto& outcome : found.outcome) {
      const std::array<double, 3> own = outcome.name == "velocity"  ? std::array<double, 3>{0, 1, -1}
                                        : outcome.name == "impulse" ? std::array<double, 3>{1, 1, -1}
                                        : outcome.name == "icr"     ? std::array<double, 3>{0, 0, 0}
                                        : outcome.name == "time"    ? std::array<double, 3>{0, 0, 1}
                                                                    : std::array<double, 3>{1, 2, -2};
      if (!outcome.value) continue;
      for (int unit = 0; unit < 3; ++unit) {
        double sum = 0, size = std::abs(*outcome.value);
        for (std::size_t k = 0; k < found.parameter.size(); ++k) {
          const auto& [name, value] = found.parameter[k];
          if (name.ends_with("exponent")) continue;
          const double term = dimension(name)[unit] * value * outcome.slope[k].value();
          sum += term;
          size += std::abs(term);
        }
        BOOST_TEST(std::abs(sum - own[unit] * *outcome.value) <= 1e-10 * size);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(slopes_are_those_of_differences_of_runs) {
  std::mt19937 random(3);
  impact::ChainSolver solver;
  double worst = 0;
  for (int n = 0; n < 40; ++n) {
    const auto chain = random_chain(random);
    const auto by = parameters(chain);
    const auto found = sensitivity(chain, by);
    for (std::size_t k = 0; k < by.size(); ++k) {
      // Differences of order four: their own error is 1e-9 where no event comes or goes between.
      const double h = 2e-4;
      const auto at = [&](double offset) {
        return solver.solve(by[k].model(by[k].value + offset * h), {.accuracy = 1e-14}).velocity;
      };
      const auto a = at(-2), b = at(-1), c = at(1), d = at(2);
      for (std::size_t i = 0; i < chain.mass.size(); ++i) {
        const double expected = ((a[i] - d[i]) + 8 * (c[i] - b[i])) / (12 * h);
        const double error = std::abs(found.outcome[i].slope[k].value() - expected);
        worst = std::max(worst, error);
        BOOST_TEST(error <= 1e-7 * (1 + std::abs(expected)),
                   "velocity " << i << " by " << by[k].name << " of chain " << n << ": "
                               << found.outcome[i].slope[k].value() << ", differences " << expected);
      }
    }
  }
  BOOST_TEST_MESSAGE("largest difference " << worst);
}

BOOST_AUTO_TEST_CASE(a_pair_with_a_gap_has_the_slopes_of_the_page) {
  const model::Chain pair{.mass = {2, 3}, .law = {contact::Linear(5)}, .gap = {0.3}, .velocity = {1.5, 0}};
  const auto found = sensitivity(pair, parameters(pair));
  BOOST_TEST(std::abs(slope(found, "velocity", 0, "velocity[0]") + 0.2) < 1e-12);
  BOOST_TEST(std::abs(slope(found, "time", 0, "velocity[0]") + 0.3 / 2.25) < 1e-12);
  BOOST_TEST(std::abs(slope(found, "time", 0, "gap[0]") - 1 / 1.5) < 1e-12);
  BOOST_TEST(std::abs(slope(found, "time", 0, "contact[0].stiffness") +
                      std::numbers::pi * std::sqrt(1.2 / 5) / 10) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_pair_has_the_slopes_of_its_closed_form) {
  // v₁⁺ = v (m₁ − m₂)/(m₁ + m₂), and time t = π √(m*/k).
  const model::Chain pair{.mass = {2, 3}, .law = {contact::Linear(5)}, .gap = {0}, .velocity = {1.5, 0}};
  const auto found = sensitivity(pair, parameters(pair));
  BOOST_TEST(std::abs(slope(found, "velocity", 0, "mass[0]") - 1.5 * 6 / 25.0) < 1e-12);
  BOOST_TEST(std::abs(slope(found, "velocity", 0, "velocity[0]") + 0.2) < 1e-12);
  BOOST_TEST(std::abs(slope(found, "velocity", 0, "contact[0].stiffness")) < 1e-12);
  const double time = std::numbers::pi * std::sqrt(1.2 / 5);
  BOOST_TEST(std::abs(slope(found, "time", 0, "contact[0].stiffness") + time / 10) < 1e-12);
  BOOST_TEST(std::abs(slope(found, "time", 0, "gap[0]") - 1 / 1.5) < 1e-12);
}

// With e = √(k₁/k₂) the second of two equal balls gets (1 + e)/2. A hundredth of k₂ would bring it below k₁;
// where they are equal the law ends, and there is no slope.
BOOST_AUTO_TEST_CASE(unloading_may_be_hardly_stiffer_than_loading) {
  const double loading = 1e6;
  for (const double more : {1e-1, 1e-2, 1e-3, 1e-4, 0.0}) {
    const double unloading = loading * (1 + more), e = std::sqrt(loading / unloading);
    const model::Chain pair{.mass = {1, 1},
                            .law = {contact::state(contact::WaltonBraun(loading, unloading))},
                            .gap = {0},
                            .velocity = {1, 0}};
    const auto all = parameters(pair);
    const auto found = sensitivity(pair, all, {.accuracy = 1e-12});
    BOOST_TEST(found.parameter.size() == (more > 0 ? 7u : 5u));
    if (more == 0) continue;
    BOOST_TEST(slope(found, "velocity", 1, "contact[0].loading_stiffness") * 4 * loading / e == 1,
               boost::test_tools::tolerance(1e-9));
    BOOST_TEST(slope(found, "velocity", 1, "contact[0].unloading_stiffness") * 4 * unloading / e == -1,
               boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(power_series_have_the_slopes_of_collocation) {
  std::mt19937 random(23);
  int compared = 0;
  for (int n = 0; n < 16; ++n) {
    const auto chain = random_row(random);
    const auto by = parameters(chain);
    // Steps of CVODE have no series.
    const auto found = sensitivity(chain, by, {.accuracy = 1e-10, .max_time = 6});
    const auto other =
        sensitivity(chain, by, {.accuracy = 1e-11, .max_time = 6, .flow = flow::Kind::cvode_adams});
    BOOST_TEST_REQUIRE(found.outcome.size() == other.outcome.size());
    if (found.ending != other.ending) continue;
    for (std::size_t k = 0; k < found.outcome.size(); ++k) {
      if (found.outcome[k].name != "velocity") continue;
      const auto &own = found.outcome[k].slope, &reference = other.outcome[k].slope;
      double most = 1;
      for (const auto& one : reference) most = std::max(most, std::abs(one.value_or(0)));
      for (std::size_t c = 0; c < by.size(); ++c) {
        BOOST_TEST(own[c].has_value() == reference[c].has_value(),
                   "slope of " << k << " by " << by[c].name << " of row " << n);
        if (!own[c] || !reference[c]) continue;
        ++compared;
        BOOST_TEST(std::abs(*own[c] - *reference[c]) <= 1e-8 * most,
                   "velocity " << k << " by " << by[c].name << " of row " << n << ": " << *own[c] << " and "
                               << *reference[c]);
      }
    }
  }
  BOOST_TEST(compared > 300);
}

BOOST_AUTO_TEST_CASE(series_know_exponents_of_damped_hertz_contacts) {
  impact::ContactSlope by_exponent;
  by_exponent.law.push_back({.column = 0, .points = {}, .power = {0, 0, 1}, .shifted = {}});
  BOOST_TEST(impact::PushExpansion::knows({1, 0.1, 1.5}, by_exponent));
  BOOST_TEST(!impact::PushExpansion::knows({1, 0, 1.5}, by_exponent));
  BOOST_TEST(!impact::PushExpansion::knows({1, 0.1, 1}, by_exponent));
}

/// Largest difference of velocity slopes of three balls from those of a much better run.
double error_of_three(double damping, double gap, double accuracy) {
  const contact::PowerLaw law{1, damping, 1.5};
  const model::Chain chain{.mass = {1, 1, 1}, .law = {law, law}, .gap = {0, gap}, .velocity = {1, 0, 0}};
  const auto found = sensitivity(chain, parameters(chain), {.accuracy = accuracy});
  const auto right = sensitivity(chain, parameters(chain), {.accuracy = 1e-13});
  double most = 0;
  for (std::size_t i = 0; i < chain.mass.size(); ++i)
    for (std::size_t c = 0; c < found.parameter.size(); ++c)
      most = std::max(most, std::abs(*found.outcome[i].slope[c] - *right.outcome[i].slope[c]));
  return most;
}

// Near the end of a contact its root is in the slopes long before it is in the motion.
BOOST_AUTO_TEST_CASE(slopes_are_as_right_as_is_asked_through_the_ends_of_contacts) {
  for (const double damping : {0.0, 0.04})
    for (const double gap : {0.0, 0.4})
      for (const double accuracy : {1e-6, 1e-8, 1e-10})
        BOOST_TEST(error_of_three(damping, gap, accuracy) < accuracy,
                   "damping " << damping << ", gap " << gap << ", accuracy " << accuracy);
}

BOOST_AUTO_TEST_CASE(two_models_tell_slopes_by_what_is_linear) {
  const contact::PowerLaw law{1, 0.04, 1.5};
  const model::Chain chain{.mass = {1, 2, 1}, .law = {law, law}, .gap = {0, 0.1}, .velocity = {1, 0, 0}};
  auto by = parameters(chain);
  std::vector<int> models(by.size());
  for (std::size_t c = 0; c < by.size(); ++c)
    by[c].set = [&models, c, made = by[c].set](double to, model::Chain& moved) {
      ++models[c];
      made(to, moved);
    };
  sensitivity(chain, by);
  for (std::size_t c = 0; c < by.size(); ++c) {
    const bool is_curved = by[c].name.starts_with("mass") || by[c].name.ends_with("exponent");
    BOOST_TEST(models[c] == (is_curved ? 8 : 2), by[c].name);
  }
}

// Newton's cradle: balls that stay at rest touch again as soon as their masses differ.
BOOST_AUTO_TEST_CASE(balls_that_go_on_together_have_slopes_of_one_side) {
  const auto strike = [](double mass) {
    const model::Chain row{.mass = {1, mass, 1},
                           .law = {contact::Hertz(1), contact::Hertz(1)},
                           .gap = {0.5, 5},
                           .velocity = {1, 0, 0}};
    return sensitivity(row, parameters(row));
  };
  const auto equal = strike(1), nearly_equal = strike(1 + 1e-5), other = strike(0.8);
  const auto tells = [](const Sensitivity& one) {
    return std::any_of(one.notes.begin(), one.notes.end(), [](const impact::SlopeNote& note) {
      return note.text.find("slopes hold on the side where they part") != std::string::npos;
    });
  };
  BOOST_TEST(tells(equal));
  BOOST_TEST(tells(nearly_equal));
  BOOST_TEST(!tells(other));
}

// The first two balls part after they have pushed once.
BOOST_AUTO_TEST_CASE(balls_that_may_meet_again_are_named_by_their_numbers) {
  const model::Chain row{.mass = {1, 1, 1},
                         .law = {contact::Hertz(1), contact::Hertz(1)},
                         .gap = {0.5, 5},
                         .velocity = {1, 0, 0}};
  std::vector<std::string> named;
  for (const auto& note : sensitivity(row, parameters(row)).notes)
    if (note.text.starts_with("contact 1 ends with"))
      for (const auto& outcome : note.outcomes)
        if (outcome.starts_with("velocity")) named.push_back(outcome);
  BOOST_TEST(named == (std::vector<std::string>{"velocity[0]", "velocity[1]"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(notes_name_the_slopes_that_they_are_about) {
  // Two contacts end at one instant; the last ball flies away.
  const model::Chain row{.mass = {1, 1, 1, 1},
                         .law = {contact::Hertz(1), contact::Hertz(1), contact::Hertz(1)},
                         .gap = {0, 0, 1},
                         .velocity = {1, 0, -1, 5}};
  const auto found = sensitivity(row, parameters(row));
  BOOST_TEST_REQUIRE(!found.notes.empty());
  const auto told = [&](const std::string& outcome, const std::string& parameter) {
    return std::any_of(found.notes.begin(), found.notes.end(), [&](const impact::SlopeNote& note) {
      return note.error > 0 && concerns(note, outcome, parameter);
    });
  };
  BOOST_TEST(told("time", "mass[1]"));
  BOOST_TEST(!told("time", "mass[0]"));
  for (const auto& outcome : found.outcome)
    if (outcome.name == "velocity") BOOST_TEST(!told(name_of(outcome), "mass[1]"));
}

BOOST_AUTO_TEST_CASE(a_damper_that_pulls_to_the_end_has_a_note_that_is_large_enough) {
  for (const double exponent : {1.01, 1.05, 1.1, 1.2, 1.25}) {
    model::Chain chain{.mass = {1, 1},
                       .law = {std::make_shared<contact::Uncut>(contact::PowerLaw{1, 0.1, exponent})},
                       .gap = {0},
                       .velocity = {1, 0}};
    const auto found = sensitivity(chain, parameters(chain));
    const auto velocity = [&](double change) {
      auto other = chain;
      other.mass[0] += change;
      return impact::simulate(other, {.accuracy = 1e-13}).velocity[0];
    };
    constexpr double h = 1e-3;
    const double difference =
        (8 * (velocity(h) - velocity(-h)) - (velocity(2 * h) - velocity(-2 * h))) / (12 * h);
    double allowed = 1e-10;
    for (const auto& note : found.notes) allowed = std::max(allowed, note.error);
    BOOST_TEST_CONTEXT("exponent " << exponent) {
      if (const auto& own = found.outcome[0].slope[0])
        BOOST_TEST(std::abs(*own - difference) < allowed + 1e-9);
      else
        BOOST_TEST(allowed > 0.1);  // left out
      BOOST_TEST(allowed < 3);
    }
  }
}
