// The list of laws is what scenes accept and what the page of the format shows.
#define BOOST_TEST_MODULE named laws
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <sstream>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/scene/scene.hpp"

using namespace mariotte;

namespace {

const auto every_law = boost::unit_test::data::xrange(std::size(contact::named_laws));

std::string row_of_page(const contact::NamedLaw& law) {
  std::ostringstream row;
  row << "| `" << law.name << "` | " << law.force << " | ";
  law.exponent ? row << *law.exponent : row << "any";
  row << " | " << (law.damping ? law.damping_unit : "–") << " |";
  return row.str();
}

contact::Law read(const contact::NamedLaw& law, const std::string& numbers) {
  const auto text =
      "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = '" + std::string(law.name) + "'\n" + numbers;
  return std::get<model::Chain>(scene::parse(text, "law").model).law[0];
}

}  // namespace

BOOST_DATA_TEST_CASE(the_page_shows_every_law, every_law) {
  std::ifstream file(MARIOTTE_SCENES "/../../doc/scene_format.md");
  const std::string page((std::istreambuf_iterator<char>(file)), {});
  const auto row = row_of_page(contact::named_laws[sample]);
  BOOST_TEST(page.find(row) != std::string::npos, row);
}

BOOST_DATA_TEST_CASE(scenes_name_every_law, every_law) {
  const auto& one = contact::named_laws[sample];
  const auto law = read(one, one.damping ? "stiffness = 3\ndamping = 0.25\n" : "stiffness = 3\n");
  BOOST_TEST(name(law) == one.name);
  const auto numbers = parameters(law);
  BOOST_TEST(numbers.at(0).value == 3);
  BOOST_TEST(numbers.at(1).value == (one.damping ? 0.25 : 0));
  BOOST_TEST(numbers.at(2).value == one.exponent.value_or(1.5));
}

BOOST_DATA_TEST_CASE(units_are_those_of_the_law, every_law) {
  const auto& one = contact::named_laws[sample];
  if (!one.damping) return;
  std::string unit(one.damping_unit);
  if (const auto n = unit.find("^n"); n != std::string::npos) unit.replace(n, 2, "^1.5");
  const auto law = read(one, "stiffness = 3\ndamping = '2 " + unit + "'\n");
  BOOST_TEST(parameters(law).at(1).value == 2);
}
