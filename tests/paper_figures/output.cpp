#define BOOST_TEST_MODULE paper_figures_output
#include "output.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "picture.hpp"

using namespace mariotte::paper_figures;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const Figure figure{"one", "A figure", {}};

}  // namespace

BOOST_AUTO_TEST_CASE(a_number_that_is_off_or_not_finite_fails) {
  BOOST_TEST(holds({"", 1, 1 + 1e-10, 1e-9}));
  BOOST_TEST(!holds({"", 1, 1 + 1e-8, 1e-9}));
  BOOST_TEST(!holds({"", std::numeric_limits<double>::quiet_NaN(), 1, 1e-9}));
  BOOST_TEST(!holds({"", std::numeric_limits<double>::infinity(), 1, 1e-9}));
}

BOOST_AUTO_TEST_CASE(a_summary_shows_what_fails_and_counts_what_passes) {
  const Reproduction result{{}, {{"speed", 1, 1, 0}, {"time", 2, 3, 0.5}}, {}, ""};
  const auto text = summary(figure, result);
  BOOST_TEST(has(text, "1 of 2 checks pass"));
  BOOST_TEST(has(text, "FAIL"));
  BOOST_TEST(has(text, "time"));
  BOOST_TEST(!has(text, "speed"));
  BOOST_TEST(has(details(figure, result), "speed"));
}

BOOST_AUTO_TEST_CASE(claims_are_true_partly_or_false) {
  const Reproduction result{
      {}, {}, {{"a", Verdict::yes, "x"}, {"b", Verdict::partly, "y"}, {"c", Verdict::no, "z"}}, "remark"};
  const auto text = summary(figure, result);
  BOOST_TEST(has(text, "true: a (x)"));
  BOOST_TEST(has(text, "partly: b (y)"));
  BOOST_TEST(has(text, "false: c (z)"));
  BOOST_TEST(has(text, "remark"));
}

BOOST_AUTO_TEST_CASE(data_have_a_named_block_per_curve_in_full_precision) {
  const Picture picture{
      "t", "x", "y", "", {{"a", Style::line, {0, 1}, {0.1, 0.2}}, {"b", Style::points, {2}, {3}}}};
  BOOST_TEST(
      plot_data(picture) ==
      "# x, y; a block per curve\n# a\n0,0.10000000000000001\n1,0.20000000000000001\n\n\n# b\n2,3\n\n\n");
  const auto script = plot_script(picture, "one");
  BOOST_TEST(has(script, "'plot.csv' index 1 using 1:2 with points"));
  BOOST_TEST(has(script, "set output folder.'one.svg'"));
}

BOOST_AUTO_TEST_CASE(lines_of_a_family_have_marks_beside_their_colours) {
  const Picture picture{"t",
                        "x",
                        "y",
                        "",
                        {{"42", Style::line, {0, 1}, {0, 1}, 0.42},
                         {"", Style::dashed, {0, 1}, {0, 1}, 0.42},
                         {"45", Style::line, {0, 1}, {0, 1}, 0.45}}};
  const auto script = plot_script(picture, "one");
  BOOST_TEST(has(
      script,
      "index 0 using 1:2 with linespoints lt 1 pi 1 ps 1.4 lc palette fraction 0.370 dt solid title '42'"));
  BOOST_TEST(
      has(script,
          "index 1 using 1:2 with linespoints lt 1 pi 1 ps 1.4 lc palette fraction 0.370 dt (12,4) notitle"));
  BOOST_TEST(has(
      script,
      "index 2 using 1:2 with linespoints lt 2 pi 1 ps 1.4 lc palette fraction 0.396 dt solid title '45'"));
}
