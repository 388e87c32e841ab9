#define BOOST_TEST_MODULE study_fit
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>

#include "mariotte/study/fit/uncertainty.hpp"
#include "support/measured_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// Of a fit that is refused.
template <class Problem>
std::string refusal(const std::string& scene, const study::Measurements& measured,
                    const std::vector<std::string>& free) {
  try {
    fitted(scene, measured, free);
    return "";
  } catch (const Problem& problem) {
    return problem.what();
  }
}

bool has(const std::string& text, const std::string& part) {
  BOOST_TEST_INFO("says \"" << text << "\"");
  return text.find(part) != std::string::npos;
}

/// The largest relative error of the values.
double error(const study::Fit& fit, const std::vector<double>& truth) {
  double largest = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    largest = std::max(largest, std::abs(fit.estimates[i].value / truth[i] - 1));
  return largest;
}

bool covers(const study::Estimate& one, double truth) {
  return one.lower <= truth && truth <= one.upper;
}

const std::vector<std::string> true_dampings = {"surface.zeta_hertz=1.5", "surface.zeta_adhesion=0.5"};
const std::string speeds_and_diameters = table_of({4.9, 6.89}, speeds(2.5, 20, 12));

}  // namespace

// The data are exact to the accuracy of the simulations, 1e-10, and the values follow them to a factor.
BOOST_AUTO_TEST_CASE(exact_data_give_the_values_back) {
  const auto fit = fitted(sphere, exact(sphere, true_dampings, speeds_and_diameters), dampings);
  BOOST_TEST(error(fit, {1.5, 0.5}) < 1e-8);
  BOOST_TEST(fit.rms < 1e-9);
  BOOST_TEST(fit.degrees_of_freedom == 22);
}

BOOST_AUTO_TEST_CASE(the_start_does_not_matter) {
  const auto measured = exact(sphere, true_dampings, speeds_and_diameters);
  for (const auto* start : {"0.02", "0.3", "6"}) BOOST_TEST_CONTEXT("from " << start) {
      const auto scene = with(with(sphere, "zeta_hertz = 1", std::string("zeta_hertz = ") + start),
                              "zeta_adhesion = 1", std::string("zeta_adhesion = ") + start);
      BOOST_TEST(error(fitted(scene, measured, dampings), {1.5, 0.5}) < 1e-8);
    }
}

// Where a tip slips and where it sticks are two minima; from some starts the nearest is not the least.
BOOST_AUTO_TEST_CASE(a_minimum_that_is_not_the_least_is_left) {
  const std::vector<std::string> keys = {"surface.friction", "surface.zeta_hertz"};
  std::string table = "incidence.angles[1] [deg],restitution.tip\n";
  for (const int tilt : {10, 20, 30, 42, 50, 60}) table += fmt::format("{},0\n", tilt);
  const auto scene = with(rod, "zeta_adhesion = 1", "zeta_adhesion = 0.5") + "[run]\nimpacts = 1\n";
  const auto measured = exact(scene, {"surface.friction=0.25", "surface.zeta_hertz=1.1"}, table);
  for (const auto* start : {"0.05", "0.15", "0.6"}) BOOST_TEST_CONTEXT("from " << start) {
      const auto from = with(with(scene, "friction = 0.3", std::string("friction = ") + start),
                             "zeta_hertz = 1\n", "zeta_hertz = 1.5\n");
      BOOST_TEST(error(fitted(from, measured, keys), {0.25, 1.1}) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(scenes_may_say_radius_or_diameter) {
  const auto measured = exact(sphere, true_dampings, speeds_and_diameters);
  const auto scene = with(sphere, "radius = \"2.45 um\"", "diameter = \"4.9 um\"");
  BOOST_TEST(error(fitted(scene, measured, dampings), {1.5, 0.5}) < 1e-8);
}

BOOST_AUTO_TEST_CASE(captured_bodies_among_the_measurements_do_no_harm) {
  const auto measured = exact(sphere, true_dampings, table_of({4.9}, speeds(0.8, 20, 20)));
  BOOST_TEST(measured.rows.front().measured == 0);
  const auto fit = fitted(sphere, measured, dampings);
  BOOST_TEST(error(fit, {1.5, 0.5}) < 1e-8);
  BOOST_TEST(fit.predicted.front().captured);
  BOOST_TEST(!fit.predicted.back().captured);
}

// Their residuals are zero whatever the noise: to count them would make errors seem smaller.
BOOST_AUTO_TEST_CASE(captured_bodies_make_no_errors_smaller) {
  const auto rebounds = noisy(exact(sphere, true_dampings, speeds_and_diameters), 0.02, 7);
  auto all = rebounds;
  const auto captured = exact(sphere, true_dampings, table_of({4.9}, speeds(0.2, 0.6, 40)));
  all.rows.insert(all.rows.end(), captured.rows.begin(), captured.rows.end());
  const auto with = fitted(sphere, all, dampings), without = fitted(sphere, rebounds, dampings);
  BOOST_TEST(with.degrees_of_freedom == without.degrees_of_freedom);
  for (std::size_t j = 0; j < 2; ++j) {
    BOOST_TEST(with.estimates[j].standard_error == without.estimates[j].standard_error,
               boost::test_tools::tolerance(1e-6));
    BOOST_TEST(with.estimates[j].upper == without.estimates[j].upper, boost::test_tools::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(captured_bodies_alone_are_too_few) {
  auto measured = exact(sphere, true_dampings, table_of({4.9}, speeds(3, 5, 2)));
  const auto captured = exact(sphere, true_dampings, table_of({4.9}, speeds(0.2, 0.6, 4)));
  measured.rows.insert(measured.rows.end(), captured.rows.begin(), captured.rows.end());
  BOOST_CHECK_EXCEPTION(fitted(sphere, measured, dampings), scene::SceneError, [](const auto& error) {
    return std::string(error.what()).find("2 measurements of what is not captured cannot give 2 values") !=
           std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(adhesion_can_be_found_beside_the_dampings) {
  const auto measured = exact(sphere, true_dampings, speeds_and_diameters);
  const auto scene = with(sphere, "0.38", "0.3");
  auto free = dampings;
  free.push_back("surface.work_of_adhesion");
  BOOST_TEST(error(fitted(scene, measured, free), {1.5, 0.5, 0.38}) < 1e-7);
}

BOOST_AUTO_TEST_CASE(coefficients_that_are_given_directly_can_be_found) {
  const auto scene = with(with(sphere, "zeta_hertz = 1", "damping_hertz = \"0.01 s/m\""), "zeta_adhesion = 1",
                          "damping_adhesion = \"0.01 s/m\"");
  const auto measured = exact(scene, {"surface.damping_hertz=0.0105", "surface.damping_adhesion=0.013"},
                              table_of({4.9}, speeds(2.5, 20, 12)));
  const auto fit = fitted(scene, measured, {"surface.damping_hertz", "surface.damping_adhesion"});
  BOOST_TEST(error(fit, {0.0105, 0.013}) < 1e-8);
}

BOOST_AUTO_TEST_CASE(friction_is_found_from_tilted_rods_by_tip_or_centre) {
  for (const auto* quantity : {"restitution.tip", "restitution.centre"}) BOOST_TEST_CONTEXT(quantity) {
      std::string table = std::string("incidence.angles[1] [deg],speed,") + quantity + "\n";
      for (const double tilt : {10, 20, 35, 60})
        for (const double speed : speeds(3, 15, 4)) table += fmt::format("{},{:.17g},0\n", tilt, speed);
      const auto measured =
          exact(rod, {"surface.zeta_hertz=1.5", "surface.zeta_adhesion=0.5", "surface.friction=0.15"}, table);
      auto free = dampings;
      free.push_back("surface.friction");
      BOOST_TEST(error(fitted(rod, measured, free), {1.5, 0.5, 0.15}) < 1e-7);
    }
}

// 95 of 100 intervals hold the truth, whatever the size of the noise. Of 200 that is 190 ± 3.08; three
// standard deviations are allowed.
BOOST_AUTO_TEST_CASE(intervals_cover_the_truth_as_often_as_they_say) {
  constexpr int seeds = 200;
  constexpr double allowed = 3 * 3.08;
  const auto measured = exact(sphere, true_dampings, table_of({2.58, 4.9, 6.89}, speeds(3, 20, 8)));
  for (const double deviation : {0.01, 0.05}) {
    int hertz = 0, adhesion = 0;
    for (int seed = 0; seed < seeds; ++seed) {
      const auto fit =
          fitted(sphere, noisy(measured, deviation, static_cast<std::uint64_t>(seed)), dampings, true);
      hertz += covers(fit.estimates[0], 1.5);
      adhesion += covers(fit.estimates[1], 0.5);
    }
    BOOST_TEST_CONTEXT("noise of " << deviation) {
      BOOST_TEST(std::abs(hertz - 0.95 * seeds) < allowed);
      BOOST_TEST(std::abs(adhesion - 0.95 * seeds) < allowed);
    }
  }
}

BOOST_AUTO_TEST_CASE(errors_follow_from_exact_slopes_as_from_differences) {
  const auto measured = noisy(exact(sphere, true_dampings, speeds_and_diameters), 0.01, 7);
  const auto exact = fitted(sphere, measured, dampings), other = fitted(sphere, measured, dampings, true);
  BOOST_TEST(exact.runs_with_slopes == 24);
  BOOST_TEST(exact.runs < other.runs);
  BOOST_TEST(other.runs_with_slopes == 0);
  for (std::size_t i = 0; i < 2; ++i) {
    BOOST_TEST(exact.estimates[i].value == other.estimates[i].value);
    BOOST_TEST(std::abs(exact.estimates[i].standard_error / other.estimates[i].standard_error - 1) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(scatter_is_found_whether_deviations_are_given_or_not) {
  auto measured = noisy(exact(sphere, true_dampings, speeds_and_diameters), 0.01, 7);
  const auto plain = fitted(sphere, measured, dampings);
  BOOST_TEST(plain.rms > 0.006);
  BOOST_TEST(plain.rms < 0.014);
  measured.weighted = true;
  for (auto& row : measured.rows) row.deviation = 0.003;  // too small: only ratios count
  const auto weighted = fitted(sphere, measured, dampings);
  for (std::size_t i = 0; i < 2; ++i) {
    BOOST_TEST(std::abs(weighted.estimates[i].value / plain.estimates[i].value - 1) < 1e-7);
    BOOST_TEST(std::abs(weighted.estimates[i].standard_error / plain.estimates[i].standard_error - 1) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(a_measurement_with_a_large_deviation_hardly_counts) {
  auto measured = exact(sphere, true_dampings, speeds_and_diameters);
  measured.rows[3].measured = 0.5;
  measured.rows[3].deviation = 1e4;
  BOOST_TEST(error(fitted(sphere, measured, dampings), {1.5, 0.5}) < 1e-6);
}

// With given damping coefficients, dimensions leave K^{−4/15} w_A^{2/3} of the two. A tilted rod turns while
// it touches, less so the shorter the contact, and knows a little more.
BOOST_AUTO_TEST_CASE(restitution_of_a_sphere_knows_stiffness_and_adhesion_by_one_combination) {
  const auto change = [](const std::string& shape) {
    const auto scene = with(with(shape, "zeta_hertz = 1", "damping_hertz = 0.0105"), "zeta_adhesion = 1",
                            "damping_adhesion = 0.013");
    const auto one = exact(scene, {}, table_of({4.9}, {5}));
    const auto other = exact(scene, {"surface.stiffness=5.568e10", "surface.work_of_adhesion=1.52"},
                             table_of({4.9}, {5}));  // 32 and 4 times as much
    return std::abs(one.rows[0].measured - other.rows[0].measured);
  };
  BOOST_TEST(change(sphere) < 1e-9);
  BOOST_TEST(change(with(rod, "angles = [0, 0, 0]", "angles = [0, 0.4, 0]")) > 1e-4);
}

BOOST_AUTO_TEST_CASE(values_that_can_change_together_are_named) {
  const auto measured = exact(sphere, true_dampings, speeds_and_diameters);
  auto free = dampings;
  free.insert(free.end(), {"surface.stiffness", "surface.work_of_adhesion"});
  const auto why = refusal<study::FitError>(sphere, measured, free);
  for (const auto& key : free) BOOST_TEST(has(why, key));
  BOOST_TEST(has(why, "can change together"));
}

BOOST_AUTO_TEST_CASE(values_without_effect_are_named_alone) {
  const auto measured = exact(sphere, true_dampings, speeds_and_diameters);
  auto free = dampings;
  free.push_back("surface.friction");
  const auto why =
      refusal<study::FitError>(with(sphere, "[incidence]", "friction = 0.2\n[incidence]"), measured, free);
  BOOST_TEST(
      has(why, "do not determine surface.friction (here 0.2): nothing that was measured depends on it"));
}

BOOST_AUTO_TEST_CASE(a_value_that_may_be_zero_is_named) {
  const auto measured = exact(sphere, {"surface.zeta_hertz=1.5", "surface.zeta_adhesion=0"},
                              table_of({4.9}, speeds(2.5, 20, 12)));
  const auto fit = fitted(sphere, measured, dampings);
  BOOST_TEST(fit.estimates[1].lower == 0);
  BOOST_TEST(fit.estimates[1].upper < 1e-3);
  BOOST_TEST(std::abs(fit.estimates[0].value - 1.5) < 1e-4);
  BOOST_TEST_REQUIRE(fit.warnings.size() == 1u);
  BOOST_TEST(has(fit.warnings[0], "surface.zeta_adhesion is not told from zero"));
}

/// With that value given, the others fit so much worse as the confidence allows.
BOOST_AUTO_TEST_CASE(ends_of_wide_intervals_are_where_the_fit_gets_worse) {
  const auto measured = noisy(exact(sphere, true_dampings, speeds_and_diameters), 0.05, 3);
  const auto best = fitted(sphere, measured, dampings);
  const auto& adhesion = best.estimates[1];
  BOOST_TEST(adhesion.standard_error > 0.2 * adhesion.value);
  const double t = study::student_t(0.95, best.degrees_of_freedom);
  const double worse = 1 + t * t / static_cast<double>(best.degrees_of_freedom);
  for (const double end : {adhesion.lower, adhesion.upper}) {
    if (end == 0) continue;
    const auto scene = with(sphere, "zeta_adhesion = 1", fmt::format("zeta_adhesion = {}", end));
    const auto other = fitted(scene, measured, {"surface.zeta_hertz"});
    BOOST_TEST(other.chi_square / best.chi_square == worse, boost::test_tools::tolerance(0.01));
  }
}

BOOST_AUTO_TEST_CASE(a_start_from_which_all_is_captured_is_refused) {
  const auto measured = exact(sphere, true_dampings, speeds_and_diameters);
  const auto scene = with(sphere, "zeta_adhesion = 1", "zeta_adhesion = 1000");
  BOOST_TEST(has(refusal<study::FitError>(scene, measured, dampings), "start from less damping"));
}

BOOST_AUTO_TEST_CASE(too_few_measurements_are_refused) {
  const auto measured = exact(sphere, true_dampings, table_of({4.9}, speeds(2.5, 20, 2)));
  BOOST_TEST(has(refusal<scene::SceneError>(sphere, measured, dampings),
                 "data.csv: 2 measurements cannot give 2 values and their errors; at least 3 are needed"));
}

BOOST_AUTO_TEST_CASE(keys_that_cannot_be_free_are_refused) {
  const auto measured = exact(sphere, true_dampings, speeds_and_diameters);
  const auto why = [&](const char* key) { return refusal<scene::SceneError>(sphere, measured, {key}); };
  BOOST_TEST(why("surface.zeta_herz") ==
             "--free surface.zeta_herz: unknown key 'surface.zeta_herz' (did you mean 'zeta_hertz'?)");
  BOOST_TEST(has(why("surface.friction"), "gives no value to start from"));
  BOOST_TEST(has(why("surface.law"), "is no number of the scene"));
  BOOST_TEST(has(why("body.radius"), "the measurements set it"));
  BOOST_TEST(why("incidence.angles[1]") == "--free incidence.angles[1]: must be positive");
}

BOOST_AUTO_TEST_CASE(a_row_that_is_no_scene_is_refused_at_its_line) {
  const auto why = [](const std::string& text) {
    return refusal<scene::SceneError>(rod, study::parse_measurements(text, "data.csv"), dampings);
  };
  BOOST_TEST(why("speed,restitution\n5,0.8\n-5,0.8\n") ==
             "data.csv:3:1: incidence.normal_speed: must be positive: the body has to approach the plane");
  BOOST_TEST(has(why("speed [kg],restitution\n5,0.8\n"), "data.csv:2:1: incidence.normal_speed: "));
  BOOST_TEST(has(why("speed,body.radios,restitution\n5,1,0.8\n"), "data.csv:2:1: unknown key 'body.radios'"));
  BOOST_TEST(has(why("incidence.angles[1] [deg],restitution\n120,0.8\n"), "data.csv:2:1: "));
}

BOOST_AUTO_TEST_CASE(a_run_that_comes_to_no_end_is_named_by_its_row) {
  const auto scene = sphere + "[run]\nmax_time = \"1 ns\"\n";
  const auto measured = study::parse_measurements(speeds_and_diameters, "data.csv");
  BOOST_TEST(has(refusal<Error>(scene, measured, dampings), "data.csv:2:1: the run ended with time_limit"));
}
