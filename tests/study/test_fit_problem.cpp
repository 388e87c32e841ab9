#define BOOST_TEST_MODULE study_fit_problem
#include <boost/test/unit_test.hpp>

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
std::vector<double> slopes(const study::FitProblem& problem) {
  std::vector<double> columns(2 * problem.count());
  problem.slopes(std::vector<double>{1, 1}, columns);
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

// Smaller steps between more accurate runs are another estimate of the same slopes.
BOOST_AUTO_TEST_CASE(slopes_have_six_digits) {
  auto usual = model_of(truth, speeds(2, 20, 6)),
       fine = model_of(truth + "[run]\naccuracy = 1e-13\n", speeds(2, 20, 6));
  const auto found = slopes(study::FitProblem(usual)), expected = slopes(study::FitProblem(fine));
  for (std::size_t i = 0; i < found.size(); ++i) BOOST_TEST(std::abs(found[i] / expected[i] - 1) < 1e-6);
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
    const auto start = study::FitProblem(model).best_start();
    BOOST_TEST(std::abs(start[0] - (1 + std::log(factor))) < 1e-14);
    BOOST_TEST(start[1] == 1.0);
  }
}
