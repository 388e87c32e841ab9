#define BOOST_TEST_MODULE scene_figure
#include <boost/test/unit_test.hpp>

#include "mariotte/scene/scene.hpp"

using namespace mariotte;

namespace {

scene::Figure figure_of(const std::string& figure) {
  return scene::parse(
             "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = 'hertz'\nstiffness = 1\n[figure]\n" + figure,
             "f.toml")
      .figure;
}

std::string problem_of(const std::string& figure) try {
  figure_of(figure);
  return "";
} catch (const scene::SceneError& error) {
  return error.what();
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_figure_is_plain_unless_asked_otherwise) {
  const auto figure = figure_of("");
  BOOST_TEST((!figure.window && !figure.logarithmic && figure.contours == 0));
}

BOOST_AUTO_TEST_CASE(window_colours_and_contours_are_read) {
  const auto figure = figure_of("window = ['30 us', 9e-5]\nlogarithmic = true\ncontours = 7");
  BOOST_TEST_REQUIRE(figure.window.has_value());
  BOOST_TEST((*figure.window)[0] == 3e-5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((*figure.window)[1] == 9e-5);
  BOOST_TEST((figure.logarithmic && figure.contours == 7));
}

BOOST_AUTO_TEST_CASE(balls_and_contacts_are_chosen_by_their_numbers) {
  const auto figure = figure_of("balls = [2, 1]\ncontacts = [1]");
  BOOST_TEST(figure.balls == (std::vector<Index>{2, 1}), boost::test_tools::per_element());
  BOOST_TEST(figure.contacts == std::vector<Index>{1}, boost::test_tools::per_element());
  for (const char* wrong : {"balls = []", "balls = 2", "balls = [0]", "balls = [1.5]", "contacts = [3, 3]",
                            "balls = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13]"})
    BOOST_TEST(problem_of(wrong).find("f.toml:7:") == 0u, wrong);
}

BOOST_AUTO_TEST_CASE(what_makes_no_figure_is_refused_where_it_stands) {
  BOOST_TEST(problem_of("window = [2, 1]").find("f.toml:7:") == 0u);
  BOOST_TEST(problem_of("window = [2, 1]").find("must end after it begins") != std::string::npos);
  BOOST_TEST(problem_of("window = [1]").find("figure.window") != std::string::npos);
  BOOST_TEST(problem_of("contours = -1") != "");
  BOOST_TEST(problem_of("contours = 1.5") != "");
  BOOST_TEST(problem_of("colour = 'red'").find("colour") != std::string::npos);
}
