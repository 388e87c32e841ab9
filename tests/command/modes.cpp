#define BOOST_TEST_MODULE command_modes
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "session.hpp"

using support::has;
using support::Session;
using Json = nlohmann::json;

namespace {

constexpr const char* row = "[chain]\nballs = 3\nmass = 1\nlaw = \"hertz\"\nstiffness = 1\n";

}  // namespace

BOOST_FIXTURE_TEST_CASE(modes_of_a_pressed_row_need_no_end, Session) {
  write("row.toml", std::string(row) + "wall = \"both\"\nprecompression = \"1 mN\"\n");
  const auto found = mariotte("modes row.toml --json --shapes");
  BOOST_TEST(found.code == 0);
  BOOST_TEST(found.err == "");
  const auto modes = Json::parse(found.out);
  BOOST_TEST(modes["angular_frequency"].size() == 3);
  BOOST_TEST(std::abs(modes["angular_frequency"][1].get<double>() - std::sqrt(2 * 0.15)) < 1e-15);
  BOOST_TEST(modes["shape"][1].size() == 5);
  BOOST_TEST(std::abs(modes["rest"]["indentation"][0].get<double>() - 0.01) < 1e-16);
  BOOST_TEST(std::abs(modes["band_edges"]["acoustic_top"].get<double>() - 2 * std::sqrt(0.15)) < 1e-15);
  BOOST_TEST(mariotte("run row.toml").code == 3);
}

BOOST_FIXTURE_TEST_CASE(a_force_stands_for_walls_at_free_ends, Session) {
  write("row.toml", row);
  const auto found = mariotte("modes row.toml --force \"1 mN\"");
  BOOST_TEST(found.code == 0);
  BOOST_TEST(has(found.out, "and 1 without frequency"));
  BOOST_TEST(has(found.out, "passes waves up to"));
  const auto nothing = mariotte("modes row.toml");
  BOOST_TEST(nothing.code == 3);
  BOOST_TEST(has(nothing.err, "contact 1 is pressed by nothing"));
  const auto metres = mariotte("modes row.toml --force \"1 mm\"");
  BOOST_TEST(metres.code == 2);
  BOOST_TEST(has(metres.err, "--force: "));
  const auto endless = mariotte("modes row.toml --force inf");
  BOOST_TEST(endless.code == 2);
  BOOST_TEST(has(endless.err, "--force: must be positive and finite, not inf [U003]"));
}

BOOST_FIXTURE_TEST_CASE(a_body_has_no_modes, Session) {
  const auto found = mariotte("modes " MARIOTTE_SCENES "/microsphere.toml");
  BOOST_TEST(found.code == 3);
  BOOST_TEST(has(found.err, "only a [chain] or a [network] has modes"));
}
