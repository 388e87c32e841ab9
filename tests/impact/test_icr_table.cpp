#define BOOST_TEST_MODULE icr table
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <random>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/laws/icr_table.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::impact;
using test::Numbers;

namespace {

using Spacing = TableAxis::Spacing;

/// Hertz triplets of stiffness ratio κ and third velocity, by simulation.
const BriefImpact& simulated(double kappa, double v_3) {
  static ChainSolver solver;
  return solver.solve(test::equal_masses({contact::Hertz{1}, contact::Hertz{kappa}}, {1, 0, v_3}),
                      {.accuracy = 1e-11});
}

TablePoint point(double kappa, double v_3) {
  const auto& run = simulated(kappa, v_3);
  const double sum = std::accumulate(run.impulse.begin(), run.impulse.end(), 0.0);
  TablePoint point{.energy_ratio = 1, .share = run.impulse};
  for (double& p : point.share) p /= sum;
  return point;
}

Numbers range(double from, double to, int count, bool log) {
  Numbers values;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    values.push_back(log ? from * std::pow(to / from, share) : from + share * (to - from));
  }
  return values;
}

/// A rectangle of the plane of κ and v₃.
struct Plane {
  double kappa_from, kappa_to, v_from, v_to;
};
constexpr Plane smooth{1, 3, -0.7, -0.1};
constexpr Plane with_kinks{0.2, 5, -0.9, 0.3};  // contacts that just close again, or late

IcrTable table_of(const Plane& plane, int count) {
  IcrTable table{.about = "triplets",
                 .accuracy = 1e-11,
                 .axis = {{"kappa", Spacing::log, range(plane.kappa_from, plane.kappa_to, count, true)},
                          {"v-3", Spacing::linear, range(plane.v_from, plane.v_to, count, false)}},
                 .point = {}};
  for (const double kappa : table.axis[0].values)
    for (const double v : table.axis[1].values) table.point.push_back(point(kappa, v));
  return table;
}

/// Worst error of velocities at random places, and how often the bound is exceeded.
struct Found {
  double worst = 0, widest = 0;
  int outside_bound = 0;
};

Found compare(const Plane& plane, int count) {
  const auto table = table_of(plane, count);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  Found found;
  for (int i = 0; i < 2000; ++i) {
    const double kappa = plane.kappa_from * std::pow(plane.kappa_to / plane.kappa_from, unit(random));
    const double v_3 = plane.v_from + (plane.v_to - plane.v_from) * unit(random);
    const auto answer = look_up(table, {kappa, v_3});
    const auto bounded = multiple_impact(chain_configuration({1, 1, 1}, {1, 0, v_3}), answer);
    const double error = test::difference(bounded.outcome.velocity, simulated(kappa, v_3).velocity);
    found.worst = std::max(found.worst, error);
    found.widest = std::max(found.widest, bounded.velocity_error);
    found.outside_bound += error > bounded.velocity_error;
  }
  return found;
}

const IcrTable small{.about = "by hand",
                     .accuracy = 1e-12,
                     .axis = {{"x", Spacing::linear, {0, 1, 3}}, {"n", Spacing::exact, {3, 4}}},
                     .point = {{1, {0.5, 0.5}},
                               {1, {0.5, 0.5}},
                               {0.8, {0.6, 0.4}},
                               {0.9, {0.5, 0.5}},
                               {0.4, {0.8, 0.2}},
                               {0.7, {0.5, 0.5}}}};

}  // namespace

BOOST_AUTO_TEST_CASE(interpolated_laws_stay_within_their_bound) {
  for (const auto& plane : {smooth, with_kinks})
    for (const int count : {9, 17, 33}) {
      const auto found = compare(plane, count);
      BOOST_TEST(found.outside_bound == 0);
      BOOST_TEST(found.widest < 50 * found.worst);  // a bound worth having
    }
}

BOOST_AUTO_TEST_CASE(error_falls_with_the_square_of_the_spacing_where_there_are_no_kinks) {
  const double coarse = compare(smooth, 9).worst, fine = compare(smooth, 33).worst;
  BOOST_TEST(coarse / fine > 12);  // 16 for a quarter of the spacing
}

BOOST_AUTO_TEST_CASE(points_of_the_table_are_answered_as_they_are) {
  const auto table = table_of(with_kinks, 9);
  const auto answer = look_up(table, {table.axis[0].values[4], table.axis[1].values[2]});
  BOOST_TEST(answer.parameters.direction == table.point[4 * 9 + 2].share, boost::test_tools::per_element());
  for (const double error : answer.share_error) BOOST_TEST(error == table.accuracy);
}

BOOST_AUTO_TEST_CASE(linear_functions_are_interpolated_without_error) {
  const auto answer = look_up(small, {2, 3});
  BOOST_TEST(answer.parameters.direction[0] == 0.7, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(answer.parameters.energy_ratio == 0.6, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(answer.energy_error < 1e-11);
}

BOOST_AUTO_TEST_CASE(outside_the_table_there_is_no_answer) {
  for (const Numbers& at :
       {Numbers{-0.1, 3}, Numbers{3.1, 3}, Numbers{1, 5}, Numbers{1, 3.5}, Numbers{std::nan(""), 3}})
    BOOST_CHECK_THROW(look_up(small, at), OutsideTable);
  BOOST_CHECK_THROW(look_up(small, {1}), InvalidParameter);
  auto hole = small;
  hole.point[2].share.clear();
  BOOST_CHECK_THROW(look_up(hole, {0.5, 3}), OutsideTable);
  BOOST_CHECK_NO_THROW(look_up(hole, {0.5, 4}));
}

BOOST_AUTO_TEST_CASE(tables_survive_being_written_and_read) {
  for (const auto& table : {table_of(smooth, 5), small}) {
    const auto again = parse_icr_table(write(table));
    BOOST_TEST(again.about == table.about);
    BOOST_TEST(again.accuracy == table.accuracy);
    for (std::size_t a = 0; a < table.axis.size(); ++a) {
      BOOST_TEST(again.axis[a].name == table.axis[a].name);
      BOOST_TEST((again.axis[a].spacing == table.axis[a].spacing));
      BOOST_TEST(again.axis[a].values == table.axis[a].values, boost::test_tools::per_element());
    }
    for (std::size_t i = 0; i < table.point.size(); ++i) {
      BOOST_TEST(again.point[i].energy_ratio == table.point[i].energy_ratio);
      BOOST_TEST(again.point[i].share == table.point[i].share, boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(broken_tables_are_refused_with_their_line) {
  const auto good = write(small);
  const auto refusal = [](std::string text, const std::string& part, const std::string& other) {
    text.replace(text.find(part), part.size(), other);
    try {
      parse_icr_table(text);
    } catch (const InvalidParameter& problem) {
      return std::string(problem.what());
    }
    return std::string("accepted");
  };
  BOOST_TEST(refusal(good, "icr-table 1", "icr-table 9").starts_with("icr table, line 1: "));
  BOOST_TEST(refusal(good, "x:linear", "x:cubic").starts_with("icr table, line 3: 'x:cubic'"));
  BOOST_TEST(refusal(good, "0,3,1,", "0,3,one,").starts_with("icr table, line 4: 'one'"));
  BOOST_TEST(refusal(good, "1,3,0.8,0.6,0.4\n", "").find("number of points") != std::string::npos);
  BOOST_TEST(refusal(good, "1,3,0.8,0.6,0.4\n1,4,0.9", "1,4,0.9,0.6,0.4\n1,3,0.8") != "accepted");
  BOOST_TEST(refusal(good, "0.8,0.6,0.4", "0.8,0.6").find("differ in their contacts") != std::string::npos);
}
