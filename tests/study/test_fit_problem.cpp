#define BOOST_TEST_MODULE study_fit_problem
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/sensitivity/stencil.hpp"
#include "mariotte/study/fit/fit_problem.hpp"
#include "support/measured_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

const std::string truth =
    with(with(sphere, "zeta_hertz = 1", "zeta_hertz = 1.5"), "zeta_adhesion = 1", "zeta_adhesion = 0.5");

study::FitModel model_of(const std::string& scene, const std::vector<double>& at) {
  return {scene::parse_document(scene, "scene.toml"), dampings,
          study::parse_measurements(table_of({4.9}, at), "data.csv")};
}

/// At the start, a column of `count` after the other.
std::vector<double> slopes(const study::FitProblem& problem, std::size_t keys = 2) {
  std::vector<double> columns(keys * problem.count());
  problem.slopes(std::vector<double>(keys, 1.0), columns);
  return columns;
}

/// The same by differences of order eight, with steps of a hundredth.
std::vector<double> differences(const study::FitProblem& problem, std::size_t keys) {
  constexpr double step = 0.01;
  std::vector<double> columns(keys * problem.count());
  for (std::size_t j = 0; j < keys; ++j)
    for (const auto& point : impact::stencil) {
      std::vector<double> x(keys, 1.0);
      x[j] += step * point.offset;
      const auto predicted = problem.predicted(x);
      for (std::size_t row = 0; row < problem.count(); ++row)
        columns[j * problem.count() + row] -= point.weight / step * predicted[row].value;
    }
  return columns;
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_are_positive_and_start_at_one) {
  auto model = model_of(truth, {3, 5});
  const study::FitProblem problem(model);
  BOOST_TEST(problem.values(std::vector<double>{1, 1}) == (std::vector<double>{1.5, 0.5}));
  BOOST_TEST(std::abs(problem.values(std::vector<double>{1 + std::log(2), -9})[0] - 3) < 1e-14);
  BOOST_TEST(problem.values(std::vector<double>{1, -9})[1] > 0);
}

// Exact slopes of runs at 1e-15 are another estimate of the same.
BOOST_AUTO_TEST_CASE(slopes_of_the_search_have_six_digits) {
  auto usual = model_of(truth, speeds(2, 20, 6)),
       fine = model_of(truth + "[run]\naccuracy = 1e-13\n", speeds(2, 20, 6));
  const study::FitProblem problem(usual);
  std::vector<double> found(2 * problem.count());
  problem.search_slopes(std::vector<double>{1, 1}, found);
  BOOST_TEST(usual.runs_with_slopes() == 0);
  const auto expected = slopes(study::FitProblem(fine));
  BOOST_TEST(fine.runs_with_slopes() == fine.runs());
  for (std::size_t i = 0; i < found.size(); ++i) BOOST_TEST(std::abs(found[i] / expected[i] - 1) < 1e-6);
}

BOOST_AUTO_TEST_CASE(slopes_are_exact) {
  for (const char* quantity : {"restitution.tip", "restitution.centre"}) {
    auto table = table_of({4.9}, speeds(2, 20, 6));
    table.replace(table.find("restitution"), 11, quantity);
    study::FitModel model(scene::parse_document(rod + "[run]\naccuracy = 1e-13\n", "scene.toml"), dampings,
                          study::parse_measurements(table, "data.csv"));
    const study::FitProblem problem(model);
    const auto found = slopes(problem), expected = differences(problem, 2);
    for (std::size_t i = 0; i < found.size(); ++i) BOOST_TEST(std::abs(found[i] - expected[i]) < 1e-9);
  }
}

// The capture velocity is 1.31035940 m/s: a little more damping captures the first body, and it takes much
// less to let the second one go.
BOOST_AUTO_TEST_CASE(slopes_do_not_reach_over_the_edge_of_capture) {
  auto model = model_of(truth, {1.3104, 1.2});
  const study::FitProblem problem(model);
  const auto predicted = problem.predicted(std::vector<double>{1, 1});
  BOOST_TEST(!predicted[0].captured);
  BOOST_TEST(predicted[1].captured);
  BOOST_TEST(problem.predicted(std::vector<double>{1.001, 1})[0].captured);
  const auto columns = slopes(problem);
  for (const std::size_t key : {0u, 1u}) {
    BOOST_TEST(columns[2 * key] > 10 * predicted[0].value);  // of (0 − e): e falls as damping grows
    BOOST_TEST(columns[2 * key + 1] == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_best_of_the_neighbours_is_where_the_search_starts) {
  const auto measured = exact(truth, {}, table_of({4.9}, speeds(2, 20, 6)));
  for (const double factor : {0.25, 1.0, 4.0}) {
    const auto scene = with(truth, "zeta_hertz = 1.5", fmt::format("zeta_hertz = {}", 1.5 / factor));
    study::FitModel model(scene::parse_document(scene, "scene.toml"), dampings, measured);
    const auto start = study::FitProblem(model).starts().front();
    BOOST_TEST(std::abs(start[0] - (1 + std::log(factor))) < 1e-14);
    BOOST_TEST(start[1] == 1.0);
  }
}

namespace {

const std::string row = R"([chain]
mass = [1, 1.2, 0.9]
velocity = [1, 0, 0]
gap = 0.01
law = "viscoelastic"
stiffness = 1
damping = 0.2
exponent = 1.5
[run]
accuracy = 1e-13
)";
const std::vector<std::string> of_row = {"chain.stiffness", "chain.damping", "chain.mass[1]"};

study::FitModel model_of_row(const std::string& scene, const std::string& setting,
                             const std::string& quantity, const std::vector<std::string>& free) {
  const auto table = setting + "," + quantity + "\n1,0.5\n1.5,0.5\n2,0.5\n";
  return {scene::parse_document(scene, "scene.toml"), free, study::parse_measurements(table, "data.csv")};
}

/// That the slopes are those of differences; returns how many of the runs carried them.
Index expect_slopes(study::FitModel&& model, std::size_t keys, double tolerance) {
  const study::FitProblem problem(model);
  const auto found = slopes(problem, keys);
  const auto runs = model.runs_with_slopes();
  const auto expected = differences(problem, keys);
  for (std::size_t i = 0; i < found.size(); ++i) BOOST_TEST(std::abs(found[i] - expected[i]) < tolerance);
  return runs;
}

}  // namespace

BOOST_AUTO_TEST_CASE(slopes_of_rows_are_exact_by_one_run_each) {
  for (const auto* quantity : {"final.velocity[2]", "contacts[1].impulse", "icr[0]", "final.time"})
    BOOST_TEST_CONTEXT(quantity)
  BOOST_TEST(expect_slopes(model_of_row(row, "speed", quantity, of_row), 3, 1e-8) == 3);
}

BOOST_AUTO_TEST_CASE(restitution_of_pairs_has_exact_slopes_but_by_start_velocities) {
  const auto pair = with(with(row, "[1, 1.2, 0.9]", "[1, 1.2]"), "[1, 0, 0]", "[1, 0]");
  BOOST_TEST(expect_slopes(model_of_row(pair, "speed", "restitution", of_row), 3, 1e-8) == 3);
  auto model = model_of_row(pair, "chain.mass[0]", "restitution", {"chain.velocity[0]"});
  BOOST_TEST(!model.slopes_of_row(0, std::vector<double>{1})[0].has_value());
  BOOST_TEST(expect_slopes(std::move(model), 1, 1e-6) == 4);
}

BOOST_AUTO_TEST_CASE(what_has_no_exact_slopes_is_asked_by_differences) {
  const auto driven = with(row, "[run]",
                           "[chain.drive]\nend = \"left\"\nquantity = \"force\"\nsignal = \"sine\"\n"
                           "amplitude = 0.01\nfrequency = 0.1\n[run]\nuntil = 4");
  const auto& by = of_row;
  BOOST_TEST(expect_slopes(model_of_row(row, "speed", "contacts[1].peak_force", by), 3, 1e-6) == 0);
  BOOST_TEST(expect_slopes(model_of_row(driven, "speed", "final.velocity[2]", by), 3, 1e-6) == 0);
}

// As many balls as a row of the table says.
BOOST_AUTO_TEST_CASE(long_rows_are_asked_by_differences) {
  const auto scene = with(with(row, "[1, 1.2, 0.9]", "1\nballs = 3"), "velocity = [1, 0, 0]\n", "") +
                     "[[chain.ball]]\nnumber = 1\nvelocity = 1\n";
  study::FitModel model(
      scene::parse_document(scene, "scene.toml"), {"chain.stiffness"},
      study::parse_measurements("chain.balls,final.velocity[2]\n3,0.5\n100,0.5\n", "data.csv"));
  BOOST_TEST(model.slopes_of_row(0, std::vector<double>{1})[0].has_value());
  BOOST_TEST(!model.slopes_of_row(1, std::vector<double>{1})[0].has_value());
  BOOST_TEST(model.runs() == 1);
}

BOOST_AUTO_TEST_CASE(slopes_that_may_be_wrong_or_are_rounding_are_not_taken) {
  impact::Sensitivity found{.ending = hybrid::Ending::separated,
                            .message = {},
                            .parameter = {{"a", 2}, {"b", 3}},
                            .outcome = {{"icr", 0, "1", 0.5, {1e-14, 0.1}}},
                            .notes = {}};
  BOOST_TEST((study::slopes_of(found, "icr[0]") == study::Slopes{0.0, 0.1}));
  BOOST_TEST((study::slopes_of(found, "icr[1]") == study::Slopes(2)));
  found.in_doubt = true;
  BOOST_TEST((study::slopes_of(found, "icr[0]") == study::Slopes(2)));
  found.in_doubt = false;
  found.ending = hybrid::Ending::bound;  // whose numbers are those of an instant that moves
  BOOST_TEST((study::slopes_of(found, "icr[0]") == study::Slopes(2)));
}

BOOST_AUTO_TEST_CASE(restitution_of_what_stays_together_does_not_change) {
  const std::string pair =
      "[chain]\nmass = [1e-12, inf]\nvelocity = [1, 0]\ngap = 1e-9\nlaw = \"jkr\"\neffective_modulus = 1e9\n"
      "effective_radius = 5e-6\nwork_of_adhesion = 0.05\n";
  const auto held = study::parse_measurements("speed,restitution\n1e-3,0\n2e-3,0\n", "data.csv");
  study::FitModel slow(scene::parse_document(pair, "scene.toml"), {"chain.work_of_adhesion"}, held);
  BOOST_TEST(slow.of_row(0, std::vector<double>{0.05}).captured);
  BOOST_TEST((slow.slopes_of_row(0, std::vector<double>{0.05}) == study::Slopes{0.0}));
}
