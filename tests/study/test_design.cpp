#define BOOST_TEST_MODULE study_design
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "mariotte/study/sweep/design_reader.hpp"
#include "mariotte/study/sweep/random.hpp"
#include "study/sweep_scenes.hpp"

using namespace mariotte;
using study::number;

namespace {

study::Design design_of(const std::string& sweeps) {
  auto document = scene::parse_document(test::three_balls + sweeps, "test.toml");
  return study::read_design(document);
}

std::vector<double> all(const study::Design& design, std::size_t parameter) {
  std::vector<double> values;
  for (Index point = 0; point < design.points(); ++point) values.push_back(number(design, parameter, point));
  return values;
}

}  // namespace

BOOST_AUTO_TEST_CASE(axes_make_a_grid_whose_last_axis_is_the_fastest) {
  const auto design = design_of(R"(
[[sweep]]
key = "chain.velocity[1]"
values = [0, 0.5]
[[sweep]]
key = "chain.velocity[2]"
values = [-1, -2, -3]
)");
  BOOST_TEST(design.points() == 6);
  BOOST_TEST(all(design, 0) == (std::vector<double>{0, 0, 0, 0.5, 0.5, 0.5}),
             boost::test_tools::per_element());
  BOOST_TEST(all(design, 1) == (std::vector<double>{-1, -2, -3, -1, -2, -3}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_range_meets_both_ends_exactly) {
  const auto linear = all(design_of("[[sweep]]\nkey='chain.mass[0]'\nfrom=0.1\nto=0.7\ncount=7\n"), 0);
  BOOST_TEST((linear.front() == 0.1 && linear.back() == 0.7));
  BOOST_TEST(linear[3] == 0.4, boost::test_tools::tolerance(1e-15));
  const auto log =
      all(design_of("[[sweep]]\nkey='chain.mass[0]'\nfrom=0.01\nto=100\ncount=5\nscale='log'\n"), 0);
  BOOST_TEST((log.front() == 0.01 && log.back() == 100));
  BOOST_TEST(log[1] == 0.1, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_step_that_misses_the_end_warns) {
  const auto warnings_of = [](const std::string& to) {
    auto document = scene::parse_document(
        test::three_balls + "[[sweep]]\nkey='chain.velocity[2]'\nfrom=0\nto=" + to + "\nstep=0.1\n",
        "s.toml");
    study::read_design(document);
    return document.source.warnings;
  };
  BOOST_TEST(warnings_of("0.3").empty());
  BOOST_REQUIRE(warnings_of("0.35").size() == 1u);
  BOOST_TEST(warnings_of("0.35")[0].ends_with("does not lead to 'to' in whole steps; the last value is 0.3"));
}

BOOST_AUTO_TEST_CASE(a_step_counts_its_values_and_may_go_down) {
  BOOST_TEST(all(design_of("[[sweep]]\nkey='chain.velocity[2]'\nfrom=0\nto=0.3\nstep=0.1\n"), 0).size() == 4);
  BOOST_TEST(
      all(design_of("[[sweep]]\nkey='chain.velocity[2]'\nfrom=0\nto=0.35\nstep=0.1\n"), 0).back() == 0.3,
      boost::test_tools::tolerance(1e-15));
  BOOST_TEST(all(design_of("[[sweep]]\nkey='chain.velocity[2]'\nfrom=0\nto=-1\nstep=-0.5\n"), 0) ==
                 (std::vector<double>{0, -0.5, -1}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(zipped_tables_move_along_one_axis) {
  const auto design = design_of(R"(
[[sweep]]
key = "chain.velocity[0]"
values = [1, 2, 3]
[[sweep]]
key = "chain.velocity[1]"
from = 0
to = 1
count = 3
zip = true
)");
  BOOST_TEST(design.points() == 3);
  BOOST_TEST(all(design, 1) == (std::vector<double>{0, 0.5, 1}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(units_become_si) {
  const auto design = design_of("[[sweep]]\nkey='chain.velocity[0]'\nfrom='1 mm/s'\nto='1 m/s'\ncount=2\n");
  BOOST_TEST(all(design, 0) == (std::vector<double>{1e-3, 1}), boost::test_tools::per_element());
  const auto listed = design_of("[[sweep]]\nkey='run.max_time'\nvalues=['1 ms', 2]\n");
  BOOST_TEST(all(listed, 0) == (std::vector<double>{1e-3, 2}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_random_value_depends_on_its_seed_and_position_alone) {
  const std::string range = "key='chain.velocity[1]'\nfrom=-1\nto=0\n";
  const auto few = all(design_of("[[sweep]]\n" + range + "count=10\nrandom=7\n"), 0);
  const auto many = all(design_of("[[sweep]]\n" + range + "count=1000\nrandom=7\n"), 0);
  BOOST_TEST(std::equal(few.begin(), few.end(), many.begin()));
  const auto other = all(design_of("[[sweep]]\n" + range + "count=10\nrandom=8\n"), 0);
  BOOST_TEST(few != other);
  BOOST_TEST(std::set<double>(many.begin(), many.end()).size() == 1000);
}

BOOST_AUTO_TEST_CASE(zipped_random_values_are_independent_of_each_other) {
  const auto design = design_of(R"(
[[sweep]]
key = "chain.velocity[1]"
from = 0
to = 1
count = 1000
random = 1
[[sweep]]
key = "chain.velocity[2]"
from = 0
to = 1
count = 1000
random = 1
zip = true
)");
  const auto x = all(design, 0), y = all(design, 1);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - 0.5) * (y[i] - 0.5);
  BOOST_TEST(std::abs(sum / 1000) < 4 / 12.0 / std::sqrt(1000.0));  // four standard errors
}

BOOST_AUTO_TEST_CASE(uniform_numbers_fill_their_interval_evenly) {
  std::vector<int> counts(16);
  double mean = 0;
  constexpr int draws = 16000;
  for (int i = 0; i < draws; ++i) {
    const double u = study::uniform(3, 0, static_cast<std::uint64_t>(i));
    BOOST_TEST_REQUIRE((u >= 0 && u < 1));
    ++counts[static_cast<std::size_t>(16 * u)];
    mean += u / draws;
  }
  double chi2 = 0;
  for (const int count : counts) chi2 += (count - 1000.0) * (count - 1000.0) / 1000;
  BOOST_TEST(chi2 < 37.7);  // 15 degrees of freedom: exceeded once in a thousand
  BOOST_TEST(std::abs(mean - 0.5) < 4 / std::sqrt(12.0 * draws));
}

BOOST_AUTO_TEST_CASE(splitmix_gives_its_published_numbers) {
  // First outputs of SplitMix64 started at 0: its state grows by the constant that `mix` adds itself.
  BOOST_TEST(study::mix(0) == 0xe220a8397b1dcdafu);
  BOOST_TEST(study::mix(0x9e3779b97f4a7c15u) == 0x6e789e6aa1b965f4u);
}
