#define BOOST_TEST_MODULE stiffness_study_usage
#include <boost/test/unit_test.hpp>

#include "command/session.hpp"

using support::content;
using support::has;
using support::Session;

// What a user types after the program's name; the session knows it as $mariotte.
BOOST_FIXTURE_TEST_CASE(a_command_line_without_sense_gives_code_2, Session) {
  for (const char* arguments :
       {"--study jump", "--study", "--flow jump", "--accuracy 0", "--accuracy 1", "jump"}) {
    const auto run = mariotte(arguments);
    BOOST_TEST(run.code == 2, arguments);
    BOOST_TEST(run.out == "");
    BOOST_TEST(run.err.starts_with("stiffness_study: error: "));
  }
}

BOOST_FIXTURE_TEST_CASE(help_shows_examples, Session) {
  const auto help = mariotte("--help");
  BOOST_TEST(help.code == 0);
  BOOST_TEST(has(help.out, "stiffness_study --quick"));
}

BOOST_FIXTURE_TEST_CASE(only_the_study_and_the_flow_asked_for_are_run, Session) {
  const auto run = mariotte("--quick --study stiffness --flow modal --csv study.csv");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.out, "linear triplet, κ = 2, modal"));
  BOOST_TEST(!has(run.out, "Hertz triplet"));
  BOOST_TEST(!has(run.out, "Damping"));
  BOOST_TEST(has(run.out, "theorem holds"));
  const auto csv = content(folder / "study.csv");
  BOOST_TEST(csv.starts_with("study,series,family,law,balls,stiffness [N/m^n],"));
  BOOST_TEST(has(csv, "\nstiffness,\"linear triplet, κ = 2\",\"k [N/m^n]\",linear,3,1,2,1,1,0,1,0,modal,"));
  BOOST_TEST(entries() == 2);  // the scene that every session starts with, and the file asked for
}

BOOST_FIXTURE_TEST_CASE(a_file_that_cannot_be_written_gives_code_6, Session) {
  const auto run = mariotte("--quick --study stiffness --flow modal --csv missing/study.csv");
  BOOST_TEST(run.code == 6);
  BOOST_TEST(has(run.err, "missing/study.csv"));
}

BOOST_FIXTURE_TEST_CASE(a_packing_tells_in_how_many_parts_it_pushes, Session) {
  const auto run = mariotte("--quick --study packing --flow auto");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.out, "a hexagonal packing of Hertz disks, struck at a corner, auto"));
  BOOST_TEST(has(run.out, "16 disks: what pushes is in 1.0 parts, with what it moves in 1.0"));
}
