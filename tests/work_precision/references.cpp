#define BOOST_TEST_MODULE work precision references
#include <boost/test/unit_test.hpp>

#include "measuring/reference_table.hpp"
#include "support/reference.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::measuring;

namespace {

constexpr long double rounding = 2e-17L;  // of decimal strings to long doubles, of three squares

std::vector<Fields> table(const std::string& name) {
  std::ifstream in(std::string(WORK_PRECISION_DATA) + "/" + name);
  return rows(std::string(std::istreambuf_iterator<char>(in), {}));
}

long double sum(const std::vector<long double>& values, int power) {
  long double total = 0;
  for (const auto value : values) total += power == 1 ? value : value * value;
  return total;
}

void check_conservation(const std::vector<long double>& before, const std::vector<long double>& after) {
  BOOST_TEST(std::abs(sum(after, 1) - sum(before, 1)) < rounding);
  BOOST_TEST(std::abs(sum(after, 2) - sum(before, 2)) < rounding);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_point_of_the_map_keeps_momentum_and_energy) {
  const auto points = table("map.csv");
  BOOST_TEST(points.size() == 64 * 64);
  for (const auto& row : points) check_conservation({1, 0, number(row[1])}, numbers(row, 5));
}

BOOST_AUTO_TEST_CASE(undamped_impacts_keep_momentum_and_energy) {
  for (const auto& row : table("impacts.csv"))
    if (row[1] != "viscoelastic") check_conservation({1, number(row[4])}, numbers(row, 6));
}

BOOST_AUTO_TEST_CASE(impacts_are_those_of_the_reference_chains) {
  const auto rounded = [](const Fields& row) {
    test::Numbers values;
    for (const auto value : numbers(row, 6)) values.push_back(static_cast<double>(value));
    return values;
  };
  const auto impacts = table("impacts.csv");
  const auto named = [&](const std::string& name) {
    const auto at =
        std::find_if(impacts.begin(), impacts.end(), [&](const auto& row) { return row[0] == name; });
    BOOST_TEST_REQUIRE((at != impacts.end()));
    return rounded(*at);
  };
  for (const auto& c : test::cases("equal_chains.json"))
    if (c.at("n") == 3 || c.at("n") == 21)
      BOOST_TEST(test::difference(named(c.at("n") == 3 ? "P1" : "P4"), c.at("final")) <= epsilon);
  for (const auto& c : test::cases("linear_triplets.json"))
    for (const auto& [name, ratio] : {std::pair{"P3-1", 1.0}, {"P3-1e4", 1e4}, {"P3-1e8", 1e8}})
      if (c.at("kappa") == ratio) BOOST_TEST(test::difference(named(name), c.at("final")) <= epsilon);
  for (const auto& c : test::cases("triplets.json"))
    for (const auto& [name, ratio] : {std::pair{"P2-0.1", 0.1}, {"P2-10", 10.0}})
      if (c.at("law") == "hertz" && c.at("kappa") == ratio && c.at("velocity")[2] == -0.5)
        BOOST_TEST(test::difference(named(name), c.at("final")) <= epsilon);
  for (const auto& c : test::cases("viscoelastic.json"))
    if (c.contains("final") && c.at("exponent") == 1.5 && c.at("damping") == 0.1)
      BOOST_TEST(test::difference(named("V-0.1"), c.at("final")) <= epsilon);
}

// name, shape, radius, length ratio, two dampings, friction, angles, velocity, spin, end, final velocity and
// spin
BOOST_AUTO_TEST_CASE(bodies_are_those_of_the_reference_cases) {
  const auto same = [](const Fields& row, const nlohmann::json& c) {
    test::Numbers stated = {c.at("radius"), c.value("length_ratio", 0.0), c.at("damping_hertz"),
                            c.at("damping_adhesion"), c.at("friction")};
    for (const char* part : {"angles", "velocity", "spin"})
      for (const double x : c.value(part, test::Numbers(3, 0.0))) stated.push_back(x);
    const auto end = c.value("final", test::Numbers(14, 0.0));
    stated.insert(stated.end(), {end[0], end[4], end[5], end[6], end[11], end[12], end[13]});
    const auto found = numbers(row, 2);
    return row[1] == c.at("shape") && c.value("lever", "") == "" &&
           std::equal(found.begin(), found.end(), stated.begin(), stated.end(),
                      [](long double a, double b) { return static_cast<double>(a) == b; });
  };
  const auto bodies = table("bodies.csv");
  BOOST_TEST(bodies.size() == 4);
  for (const auto& row : bodies) {
    bool found = false;
    for (const char* file : {"sphere_normal.json", "rod_events.json", "spatial.json"})
      for (const auto& c : test::body_cases(file)) found = found || same(row, c);
    BOOST_TEST(found, row[0]);
  }
}
