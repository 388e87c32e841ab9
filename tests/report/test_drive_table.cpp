// What `mariotte check` shows of drives.
#define BOOST_TEST_MODULE report_drive_table
#include <boost/test/unit_test.hpp>
#include <fstream>

#include "mariotte/report/table/table.hpp"
#include "mariotte/scene/scene.hpp"
#include "support/folder.hpp"

using namespace mariotte;

namespace {

const std::string row = "[chain]\nmass = 1\nballs = 2\nlaw = 'hertz'\nstiffness = 1e9\nwall = 'left'\n";
const std::string until = "[run]\nuntil = 1\n";

/// The table of a scene from the one of its drives on.
std::string drives(const std::string& text, const std::string& name = "s.toml") {
  const auto all = report::table(scene::parse(text, name));
  const auto start = all.find("  drive  ");
  return start == std::string::npos ? "" : all.substr(start, all.find("\n\n", start) + 1 - start);
}

}  // namespace

BOOST_AUTO_TEST_CASE(drives_of_a_row_are_shown_as_formulas) {
  const auto text = row +
                    "[[chain.drive]]\nend = 'left'\nquantity = 'position'\nsignal = 'sine'\n"
                    "amplitude = '20 nm'\nfrequency = '10 kHz'\nphase = -1.5\n"
                    "[[chain.drive]]\nend = 'right'\nquantity = 'force'\nsignal = 'pulse'\n"
                    "amplitude = '-3 N'\nduration = '50 us'\n" +
                    until;
  BOOST_TEST(drives(text) ==
             "  drive  ball  quantity  from [s]      signal [SI], s = t - from\n"
             "      1     1  position         0  2e-08 sin(10000 · 2π t - 1.5)\n"
             "      2     3     force         0           -3 sin(10000 · 2π t)\n"
             "      2     3     force     5e-05                              0\n");
}

BOOST_AUTO_TEST_CASE(a_row_that_nothing_drives_has_no_such_table) {
  BOOST_TEST(drives(row + until) == "");
}

BOOST_AUTO_TEST_CASE(tables_are_shown_piece_by_piece) {
  const test::Folder folder;
  std::ofstream(folder.path / "move.csv") << "time [s], velocity [m/s]\n0, 1\n2, 0\n4, 3\n";
  const auto text = row +
                    "[chain.drive]\nend = 'left'\nquantity = 'velocity'\nsignal = 'table'\n"
                    "table = 'move.csv'\ninterpolation = 'linear'\n" +
                    until;
  BOOST_TEST(drives(text, (folder.path / "s.toml").string()) ==
             "  drive  ball  quantity  from [s]  signal [SI], s = t - from\n"
             "      1     1  velocity         0                  1 - 0.5 s\n"
             "      1     1  velocity         2                      1.5 s\n"
             "      1     1  velocity         4                          3\n");
}

BOOST_AUTO_TEST_CASE(drives_of_networks_name_what_they_move) {
  const std::string shake =
      "[network.drive]\nnumber = 1\nquantity = 'velocity'\nsignal = 'sine'\namplitude = 1\nfrequency = 2\n";
  const std::string dofs =
      "[network]\nmass = [inf, 1]\nvelocity = [0, 0]\nlaw = 'linear'\nstiffness = 1\ngap = 1\n"
      "[[network.contact]]\ndirection = [-1, 1]\n";
  BOOST_TEST(drives(dofs + shake + until) ==
             "  drive  degree of freedom  quantity  from [s]  signal [SI], s = t - from\n"
             "      1                  1  velocity         0            1 sin(2 · 2π t)\n");
  const std::string balls =
      "[network]\nradius = 1\nlaw = 'linear'\nstiffness = 1\n"
      "[[network.ball]]\nposition = [0, 0]\nmass = inf\n[[network.ball]]\nposition = [2, 0]\nmass = 1\n";
  BOOST_TEST(drives(balls + shake + "direction = [3, 4]\n" + until) ==
             "  drive  ball (direction)  quantity  from [s]  signal [SI], s = t - from\n"
             "      1      1 (0.6, 0.8)  velocity         0            1 sin(2 · 2π t)\n");
}
