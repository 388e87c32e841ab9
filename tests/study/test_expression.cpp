#define BOOST_TEST_MODULE study_expression
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "mariotte/study/sweep/batch.hpp"
#include "mariotte/study/sweep/normal.hpp"
#include "mariotte/study/sweep/random.hpp"
#include "mariotte/study/sweep/sobol.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"
#include "mariotte/study/sweep/variation.hpp"
#include "study/sweep_scenes.hpp"

using namespace mariotte;
using boost::test_tools::tolerance;

namespace {

study::SweepPlan plan(const std::string& sweeps, const std::vector<std::string>& columns = {},
                      const std::string& scene = test::three_balls) {
  return study::read_sweep(scene::parse_document(scene + sweeps, "s.toml"), columns);
}

std::string rejection(const std::string& sweeps, const std::vector<std::string>& columns = {}) {
  try {
    plan(sweeps, columns);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

bool has(const std::string& text, const std::string& part) {
  BOOST_TEST_INFO(text);
  return text.find(part) != std::string::npos;
}

const std::string kappa =
    "[[sweep]]\nvariable = 'kappa'\nfrom = 0.1\nto = 10\ncount = 3\nscale = 'log'\n"
    "[[sweep]]\nkey = 'chain.contact[1].stiffness'\nexpression = 'kappa * chain.contact[0].stiffness'\n";

/// The columns of one point.
std::vector<double> row(const study::SweepPlan& plan, Index point) {
  study::Variation points(plan.document, plan.design, std::nullopt);
  study::PointEvaluation evaluation(plan);
  study::Batch batch;
  evaluate(points, evaluation, plan.columns.size(), point, 1, batch);
  return batch.numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_expression_reads_keys_as_names) {
  const study::Expression one("2 * chain.contact[1].stiffness / chain.mass[0] ^ 2 + sqrt(x) - pi");
  BOOST_TEST(one.names() == (std::vector<std::string>{"chain.contact[1].stiffness", "chain.mass[0]", "x"}),
             boost::test_tools::per_element());
  const double numbers[] = {3, 2, 16};
  BOOST_TEST(one(numbers) == 2 * 3 / 4.0 + 4 - std::numbers::pi);
  const auto copy = one;
  const double others[] = {0, 1, 0};
  BOOST_TEST(copy(others) == -std::numbers::pi);
  const double two[] = {2};
  for (const char* compares : {"x == 2 ? 1 : 0", "x >= 2", "x <= 2", "x != 3"})
    BOOST_TEST(study::Expression{compares}(two) == 1);
  const study::Expression last("final.velocity[-1] - final.velocity[-2]");
  BOOST_TEST(last.names() == (std::vector<std::string>{"final.velocity[-1]", "final.velocity[-2]"}),
             boost::test_tools::per_element());
  const double of_last[] = {5, 3};
  BOOST_TEST(last(of_last) == 2);
  for (const char* wrong : {"", "1 +", "a b", "f(1)", "1, 2", "chain.contact[1].stiffness * (", "x = 7",
                            "(x=2) ? 1 : 2", "x === 2"})
    BOOST_CHECK_THROW(study::Expression{wrong}, study::ExpressionError);
}

BOOST_AUTO_TEST_CASE(names_mean_one_thing) {
  const auto named = [](const std::string& name) {
    return rejection("[[sweep]]\nvariable = '" + name + "'\nvalues = [1]\n");
  };
  for (const char* name : {"pi", "_e", "_pi"}) BOOST_TEST(has(named(name), "is no name"));
  for (const char* name : {"ending", "reason"}) BOOST_TEST(has(named(name), "is a column of every sweep"));
  BOOST_TEST(has(rejection(kappa, {"kappa = final.time"}), "there are two columns 'kappa'"));
  BOOST_TEST(has(rejection(kappa, {"ending = final.time"}), "there are two columns 'ending'"));
  BOOST_TEST(has(rejection(kappa, {"q = final.velocity[*]"}), "[*] stands for several numbers"));
}

BOOST_AUTO_TEST_CASE(a_key_follows_from_a_variable_and_other_keys) {
  const auto sweep = plan("[[sweep]]\nkey = 'chain.contact[0].stiffness'\nvalues = [1, 8]\n" + kappa);
  BOOST_TEST(sweep.design.points() == 6);
  study::Variation points(sweep.document, sweep.design, study::find_slots(sweep.document, sweep.design));
  const double expected[] = {0.1, 1, 10, 0.8, 8, 80};
  for (Index point = 0; point < 6; ++point) {
    const auto& chain = std::get<model::Chain>(points.at(point).model);
    BOOST_TEST(contact::stiffness(chain.law[1]) == expected[point], tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(constants_and_variables_may_have_units) {
  const auto sweep = plan(
      "[[sweep]]\nvariable = 'thickness'\nfrom = '1 mm'\nto = '3 mm'\nstep = '1 mm'\n"
      "[[sweep]]\nkey = 'chain.velocity[0]'\nexpression = 'thickness / (2 * chain.radius)'\n",
      {}, test::steel_balls);
  study::Variation points(sweep.document, sweep.design, std::nullopt);
  BOOST_TEST(std::get<model::Chain>(points.at(2).model).velocity[0] == 3e-3 / 0.02, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(what_is_infinite_has_no_number) {
  const auto numbers = row(plan(kappa, {"a = icr[0] / chain.velocity[1]", "b = ln(chain.velocity[1])"}), 0);
  BOOST_TEST(std::isnan(numbers[0]));
  BOOST_TEST(std::isnan(numbers[1]));
}

BOOST_AUTO_TEST_CASE(columns_are_expressions_of_results_and_inputs) {
  const auto sweep = plan(kappa, {"alpha = contacts[0].impulse / contacts[1].impulse", "icr[0]",
                                  "k = chain.contact[1].stiffness / kappa", "twice = 2 * icr[0]"});
  BOOST_TEST(sweep.results.size() == 3);  // both impulses and the ratio, each once
  const auto numbers = row(sweep, 2);
  BOOST_TEST(numbers[0] == numbers[1], tolerance(1e-12));
  BOOST_TEST(numbers[2] == 1.0, tolerance(1e-14));
  BOOST_TEST(numbers[3] == 2 * numbers[1]);
}

BOOST_AUTO_TEST_CASE(what_an_expression_cannot_mean_is_refused_where_it_stands) {
  const std::string derive = "[[sweep]]\nkey = 'chain.contact[1].stiffness'\nexpression = ";
  const std::string axis = "[[sweep]]\nkey = 'chain.velocity[0]'\nvalues = [1, 2]\n";
  BOOST_TEST(
      has(rejection(axis + derive + "'2 * ('\n"), "s.toml:15:14: sweep[1].expression: cannot read '2 * ('"));
  BOOST_TEST(has(rejection(axis + derive + "'2 * chain.mas[0]'\n"),
                 "'chain.mas[0]' is no number that the scene gives (did you mean 'chain.mass[0]'?)"));
  BOOST_TEST(has(rejection("[[sweep]]\nvariable = 'kappa'\nvalues = [1]\n" + derive + "'kapa'\n"),
                 "did you mean 'kappa'?"));
  BOOST_TEST(has(rejection(derive + "'2'\n"), "no table says what is varied"));
  BOOST_TEST(has(rejection(axis + derive + "'2'\nfrom = 1\n"), "does not go with 'expression'"));
  BOOST_TEST(has(rejection("[[sweep]]\nvariable = '2x'\nvalues = [1]\n"), "letters, digits"));
  BOOST_TEST(has(rejection("[[sweep]]\nvariable = 'x'\nkey = 'chain.gap'\nvalues = [1]\n"), "either"));
  BOOST_TEST(has(rejection(axis + "[[sweep]]\nkey = 'chain.contact[0].damping'\nexpression = '1'\n"),
                 "needs a value in the scene"));
  BOOST_TEST(has(rejection(axis, {"a = icrs[0]"}), "no result has 'icrs[0]'"));
  BOOST_TEST(has(rejection(axis, {"a = icr[0"}), "needs an index"));
  BOOST_TEST(has(rejection(axis, {"= icr[0]"}), "needs a name"));
  BOOST_TEST(has(rejection(axis, {"a = icr[0]", "a = icr[0]"}), "two columns"));
}

BOOST_AUTO_TEST_CASE(a_shuffle_is_a_permutation_that_depends_on_its_seed) {
  for (const std::uint64_t count : {1, 2, 3, 17, 64, 1000}) {
    std::set<std::uint64_t> places;
    for (std::uint64_t i = 0; i < count; ++i) places.insert(study::shuffled(7, 1, count, i));
    BOOST_TEST(places.size() == count);
    BOOST_TEST(*places.rbegin() == count - 1);
  }
  int same = 0;
  for (std::uint64_t i = 0; i < 1000; ++i)
    same += study::shuffled(7, 1, 1000, i) == study::shuffled(8, 1, 1000, i);
  BOOST_TEST(same < 10);  // one on average
}

BOOST_AUTO_TEST_CASE(every_dyadic_interval_has_its_share_of_sobol_s_points) {
  for (const std::size_t coordinate : {0, 1, 5, 40})
    for (const std::uint64_t from : {0, 64}) {
      std::set<int> intervals;
      for (std::uint64_t k = from; k < from + 64; ++k)
        intervals.insert(static_cast<int>(64 * study::sobol(3, coordinate, k)));
      BOOST_TEST(intervals.size() == 64);
    }
  // in the plane of the first two: 64 points, one in each of 8 × 8 squares
  std::set<std::pair<int, int>> squares;
  for (std::uint64_t k = 0; k < 64; ++k)
    squares.insert(
        {static_cast<int>(8 * study::sobol(3, 0, k)), static_cast<int>(8 * study::sobol(3, 1, k))});
  BOOST_TEST(squares.size() == 64);
}

BOOST_AUTO_TEST_CASE(a_latin_design_has_one_value_in_each_part_of_its_range) {
  for (const char* design : {"latin", "sobol"}) {
    const auto sweep = plan(
        std::string(
            "[[sweep]]\nkey = 'chain.velocity[0]'\nfrom = 1\nto = 2\ncount = 32\nrandom = 5\ndesign = '") +
        design + "'\n[[sweep]]\nkey = 'chain.mass[0]'\nfrom = 1\nto = 100\nscale = 'log'\ncount = 32\n" +
        "random = 5\nzip = true\ndesign = '" + design + "'\n");
    std::set<int> velocities, masses;
    for (Index k = 0; k < 32; ++k) {
      velocities.insert(static_cast<int>(32 * (study::number(sweep.design, 0, k) - 1)));
      masses.insert(static_cast<int>(32 * std::log(study::number(sweep.design, 1, k)) / std::log(100.0)));
    }
    BOOST_TEST(velocities.size() == 32, design);
    BOOST_TEST(masses.size() == 32, design);
  }
}

BOOST_AUTO_TEST_CASE(a_design_without_a_seed_is_refused) {
  BOOST_TEST(
      has(rejection("[[sweep]]\nkey = 'chain.mass[0]'\nfrom = 1\nto = 2\ncount = 2\ndesign = 'latin'\n"),
          "needs 'random'"));
}

BOOST_AUTO_TEST_CASE(normal_values_have_their_mean_and_deviation) {
  for (const char* design : {"random", "latin", "sobol"}) {
    const Index count = 4096;
    const auto sweep = plan(std::string("[[sweep]]\nkey = 'chain.velocity[0]'\nmean = '3 m/s'\ndeviation = "
                                        "'20 cm/s'\ncount = 4096\nrandom = 5\ndesign = '") +
                            design + "'\n");
    double sum = 0, squares = 0, within = 0;
    for (Index k = 0; k < count; ++k) {
      const double z = (study::number(sweep.design, 0, k) - 3) / 0.2;
      sum += z;
      squares += z * z;
      within += std::abs(z) < 1;
    }
    const double error = 4 / std::sqrt(double(count));  // four standard errors of chance
    BOOST_TEST(std::abs(sum / count) < error, design);
    BOOST_TEST(std::abs(squares / count - 1) < std::sqrt(2.0) * error, design);
    BOOST_TEST(std::abs(within / count - std::erf(std::sqrt(0.5))) < error / 2, design);
  }
}

BOOST_AUTO_TEST_CASE(a_latin_design_has_one_normal_value_in_each_part_of_equal_probability) {
  const auto sweep = plan(
      "[[sweep]]\nkey = 'chain.velocity[0]'\nmean = 3\ndeviation = 0.2\ncount = 32\n"
      "random = 5\ndesign = 'latin'\n");
  std::set<int> parts;
  for (Index k = 0; k < 32; ++k) {
    const double z = (study::number(sweep.design, 0, k) - 3) / 0.2;
    parts.insert(static_cast<int>(16 * std::erfc(-z * std::sqrt(0.5))));
  }
  BOOST_TEST(parts.size() == 32);
}

BOOST_AUTO_TEST_CASE(quantiles_are_finite_and_those_of_the_error_function) {
  for (const double z : {-6.0, -1.0, 0.0, 0.5, 3.0})
    BOOST_TEST(std::abs(study::normal_quantile(0.5 * std::erfc(-z * std::sqrt(0.5))) - z) < 1e-11);
  BOOST_TEST(std::isfinite(study::normal_quantile(0)));
  BOOST_TEST(std::isfinite(study::normal_quantile(1)));
}

BOOST_AUTO_TEST_CASE(a_normal_distribution_needs_all_of_its_keys_and_no_ends) {
  const std::string head = "[[sweep]]\nkey = 'chain.velocity[0]'\nmean = 1\n";
  BOOST_TEST(has(rejection(head + "count = 2\nrandom = 1\n"), "'deviation' is missing"));
  BOOST_TEST(has(rejection(head + "deviation = 1\ncount = 2\n"), "'random' is missing"));
  const std::string all = head + "count = 2\nrandom = 1\n";
  BOOST_TEST(has(rejection(all + "deviation = 1\nfrom = 1\n"), "does not go with 'mean'"));
  BOOST_TEST(has(rejection(all + "deviation = 0\n"), "must be positive"));
  BOOST_TEST(has(rejection(all + "deviation = '1 kg'\n"), "expected a velocity"));
}

BOOST_AUTO_TEST_CASE(parameters_have_the_unit_of_their_key) {
  const auto sweep = plan(
      "[[sweep]]\nkey = 'chain.velocity[0]'\nfrom = '1 cm/s'\nto = 1\ncount = 2\n"
      "[[sweep]]\nkey = 'chain.contact[0].stiffness'\nvalues = [1]\n"
      "[[sweep]]\nkey = 'chain.contact[0].law'\nvalues = ['hertz']\n"
      "[[sweep]]\nvariable = 'width'\nvalues = ['3 mm']\n"
      "[[sweep]]\nvariable = 'factor'\nvalues = [1, 2]\n");
  std::vector<std::string> units;
  for (const auto& one : sweep.design.parameters) units.push_back(one.unit);
  const std::vector<std::string> expected = {"m/s", "N/m^1.5", "", "m", "1"};
  BOOST_TEST(units == expected, boost::test_tools::per_element());
}
