#define BOOST_TEST_MODULE paper_figures_run
#include <boost/test/unit_test.hpp>

#include "command/session.hpp"

namespace fs = std::filesystem;
using support::content;
using support::has;
using support::Session;

namespace {

/// The line of a picture that says which gnuplot drew it.
std::string version(const std::string& svg) {
  const auto begin = svg.find("Produced by GNUPLOT");
  return begin == svg.npos ? "" : svg.substr(begin, svg.find('<', begin) - begin);
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(every_figure_of_the_papers_passes, Session) {
  const auto run = mariotte("reproduce all --out figures");
  BOOST_TEST(run.code == 0, run.out);
  BOOST_TEST(!has(run.out, "FAIL"));
  for (const char* name : {"acary-1a", "acary-1h", "acary-2a", "acary-2b", "acary-3a", "acary-3b", "cheng-7",
                           "cheng-15", "kharaz-spin"})
    for (const char* file : {"plot.csv", "plot.gp", "checks.csv"})
      BOOST_TEST(fs::is_regular_file(folder / "figures" / name / file), name << "/" << file);
}

BOOST_FIXTURE_TEST_CASE(one_figure_shows_every_check, Session) {
  const auto run = mariotte("reproduce acary-2b");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.out, "α of the triplet 10-50-10"));
  BOOST_TEST(has(run.out, "5 of 5 checks pass; figures are in figures"));
  BOOST_TEST(entries("figures") == 1);
  BOOST_TEST(content(folder / "figures/acary-2b/checks.csv").starts_with("quantity,computed,expected,"));
}

// Byte by byte where the same gnuplot draws.
BOOST_FIXTURE_TEST_CASE(pictures_of_laws_are_those_of_the_pages, Session) {
  for (const char* picture : {"forces-elastic", "forces-damped", "forces-plastic", "forces-adhesive",
                              "restitution-damped", "restitution-plastic", "restitution-adhesive"}) {
    const auto name = std::string("law-") + picture;
    BOOST_TEST(mariotte("reproduce " + name).code == 0);
    const auto shown = content(fs::path(MARIOTTE_IMAGES) / (name + ".svg"));
    BOOST_TEST(!version(shown).empty(), name);
    const auto drawn = folder / "figures" / name / (name + ".svg");
    if (fs::exists(drawn) && version(content(drawn)) == version(shown))
      BOOST_TEST((content(drawn) == shown), name << " has changed");
  }
}

BOOST_FIXTURE_TEST_CASE(figures_of_an_earlier_run_stay_unless_forced, Session) {
  BOOST_TEST(mariotte("reproduce acary-3a").code == 0);
  const auto again = mariotte("reproduce acary-3a");
  BOOST_TEST(again.code == 6);
  BOOST_TEST(has(again.err, "acary-3a"));
  BOOST_TEST(mariotte("reproduce acary-3a --force").code == 0);
}

BOOST_FIXTURE_TEST_CASE(an_unknown_figure_is_refused_with_the_known_ones, Session) {
  const auto run = mariotte("reproduce acary-9");
  BOOST_TEST(run.code == 2);
  BOOST_TEST(has(run.err, "unknown figure 'acary-9' (one of: all, acary-1a"));
  BOOST_TEST(mariotte("reproduce").code == 2);
}
