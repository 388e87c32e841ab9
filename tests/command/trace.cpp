// The traces that `mariotte run --trace` writes.
#define BOOST_TEST_MODULE command_trace
#include <boost/test/unit_test.hpp>
#include <sstream>

#include "long_chain.hpp"
#include "session.hpp"

using support::content;
using support::has;
using support::lines;
using support::Session;
using support::sixty_balls;
namespace fs = std::filesystem;

// The pair meets after 10^8 s, and its contact lasts for some seconds.
constexpr const char* far_apart =
    "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\ngap = 1e8\nlaw = 'linear'\nstiffness = 1\n";

BOOST_FIXTURE_TEST_CASE(a_trace_holds_what_was_asked_for, Session) {
  write("sixty.toml", sixty_balls);
  const auto run = mariotte("run sixty.toml --trace wave.csv --every 0.5 --balls 1,20:60:20 --contacts 59");
  BOOST_TEST(run.code == 0);
  const auto trace = content(folder / "wave.csv");
  BOOST_TEST(
      trace.starts_with("time [s],v1 [m/s],v20 [m/s],v40 [m/s],v60 [m/s],gap59 [m],force59 [N]\n0,1,0,"));
  BOOST_TEST(lines(trace) == 146u);  // the last force ends at 71.6385 s
  BOOST_TEST(entries() == 4);
  const auto about = nlohmann::json::parse(content(folder / "wave.csv-metadata.json"));
  BOOST_TEST(about["notes"][0]["scene"] == "sixty.toml");
}

// Contacts close again and again, so that the scene is run at tighter accuracies.
BOOST_FIXTURE_TEST_CASE(a_trace_is_that_of_the_result, Session) {
  write("rattle.toml",
        "[chain]\nmass = [20, 0.3, 2, 0.7, 20]\nvelocity = [0.5, 0, 0.2, 0, -0.5]\n"
        "gap = [0.1, 0.7, 0.4, 0.9]\nlaw = 'hertz'\nstiffness = 1\n");
  const auto run = mariotte("run rattle.toml --accuracy 1e-7 --json --trace wave.csv --contacts 1");
  const auto result = nlohmann::json::parse(run.out);
  BOOST_TEST(result["accuracy"]["estimated"].get<double>() <= 1e-7);
  const auto trace = content(folder / "wave.csv");
  BOOST_TEST(trace.find("time") == trace.rfind("time"));
  std::istringstream last(trace.substr(trace.rfind('\n', trace.size() - 2) + 1));
  std::string cell;
  std::getline(last, cell, ',');
  for (const double velocity : result["final"]["velocity"]) {
    std::getline(last, cell, ',');
    BOOST_TEST(std::stod(cell) == velocity);
  }
}

BOOST_FIXTURE_TEST_CASE(a_trace_can_be_hdf5, Session) {
  const auto run = mariotte("run three.toml --trace wave.h5");
  if (has(run.err, "built without HDF5")) {
    BOOST_TEST(run.code == 6);
    return;
  }
  BOOST_TEST(run.code == 0);
  BOOST_TEST(content(folder / "wave.h5").starts_with("\x89HDF"));
  BOOST_TEST(entries() == 2);
}

BOOST_FIXTURE_TEST_CASE(a_run_that_reaches_a_limit_keeps_its_trace, Session) {
  const auto run = mariotte("run three.toml --trace wave.csv --every \"1 s\" --set run.max_time=2");
  BOOST_TEST(run.code == 5);
  BOOST_TEST(lines(content(folder / "wave.csv")) == 4u);
}

BOOST_FIXTURE_TEST_CASE(a_trace_without_sense_gives_code_2, Session) {
  for (const char* arguments :
       {"--trace w.csv --balls 4", "--trace w.csv --balls 0", "--trace w.csv --contacts 1:2:0",
        "--trace w.csv --balls 3:1", "--trace w.csv --contacts 1,2:1", "--trace w.csv --every 0",
        "--trace w.csv --every \"1 m\"", "--every 1", "--balls 1"}) {
    BOOST_TEST(support::is_refused(mariotte(std::string("run three.toml ") + arguments)), arguments);
    BOOST_TEST(entries() == 1);
  }
}

BOOST_FIXTURE_TEST_CASE(a_range_that_runs_backwards_is_told_so, Session) {
  BOOST_TEST(
      has(mariotte("run three.toml --trace w.csv --balls 2,1:3").err, "--balls 2,1:3: 2 stands in it twice"));
  BOOST_TEST(has(mariotte("run three.toml --trace w.csv --balls 1,3:2").err,
                 "--balls 1,3:2: '3:2' names nothing: it runs backwards"));
  BOOST_TEST(has(mariotte("run three.toml --trace w.csv --contacts 4").err,
                 "--contacts 4: '4' is no number from 1 to 2"));
}

BOOST_FIXTURE_TEST_CASE(a_trace_is_named_by_what_it_is, Session) {
  for (const std::string name : {"w.json", "w.H5", "w", "-"}) {
    const auto run = mariotte("run three.toml --trace " + name);
    BOOST_TEST(support::is_refused(run), name);
    BOOST_TEST(has(run.err, "'" + name + "' does not end in .csv, .h5 or .hdf5"), run.err);
    BOOST_TEST(entries() == 1);
  }
}

BOOST_FIXTURE_TEST_CASE(a_trace_of_absurd_size_is_refused_before_it_is_written, Session) {
  write("far.toml", far_apart);
  const auto run = mariotte("run far.toml --trace wave.csv --every \"1 ms\"");
  BOOST_TEST(run.code == 2);
  BOOST_TEST(run.out == "");
  BOOST_TEST(has(run.err, "wave.csv would have at least 1e+11 rows over 1e+08 s, about 1e+04 GB"));
  BOOST_TEST(entries() == 2);
  BOOST_TEST(mariotte("run far.toml --trace wave.csv --every \"1e5 s\"").code == 0);
  BOOST_TEST(lines(content(folder / "wave.csv")) == 1003u);
}

BOOST_FIXTURE_TEST_CASE(a_large_trace_tells_its_size, Session) {
  const auto run = mariotte("run three.toml --trace wave.csv --every \"20 us\"");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.err, "mariotte: wave.csv: 1.8"));
  BOOST_TEST(has(run.err, "e+05 rows over "));
  const double rows = std::stod(run.err.substr(run.err.find(": 1.8") + 2));
  const auto trace = content(folder / "wave.csv");
  BOOST_TEST(std::abs(static_cast<double>(lines(trace)) / rows - 1) < 1e-3);
  BOOST_TEST(mariotte("run three.toml --trace wave.csv --every \"20 us\" -q --force").err == "");
}

BOOST_FIXTURE_TEST_CASE(a_trace_is_not_overwritten_unless_forced, Session) {
  write("wave.csv", "mine");
  BOOST_TEST(mariotte("run three.toml --trace wave.csv").code == 6);
  BOOST_TEST(content(folder / "wave.csv") == "mine");
  BOOST_TEST(mariotte("run three.toml --trace wave.csv --force").code == 0);
  BOOST_TEST(content(folder / "wave.csv").starts_with("time [s]"));
}
