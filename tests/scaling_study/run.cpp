#define BOOST_TEST_MODULE scaling_study_run
#include <boost/test/unit_test.hpp>
#include <sstream>

#include "command/session.hpp"

using support::content;
using support::has;
using support::Session;

namespace {

struct Point {
  std::string method;
  double balls, accuracy, error, seconds, steps, widest, bytes, own_seconds, followed_seconds;
};

std::vector<Point> points(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);
  std::vector<Point> list;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    auto& p = list.emplace_back();
    std::getline(cells, p.method, ',');
    for (double* value : {&p.balls, &p.accuracy, &p.error, &p.seconds, &p.steps, &p.widest, &p.bytes,
                          &p.own_seconds, &p.followed_seconds}) {
      std::getline(cells, cell, ',');
      *value = std::stod(cell);
    }
  }
  return list;
}

}  // namespace

// What a user types after the program's name; the session knows it as $mariotte.
BOOST_FIXTURE_TEST_CASE(each_length_is_as_accurate_as_asked_and_its_waves_are_narrow, Session) {
  const auto run = mariotte("--accuracy 1e-8 --longest 10000 --patience 0 --csv own.csv");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.out, "time grows like n^"));
  const auto list = points(content(folder / "own.csv"));
  BOOST_TEST(list.size() == 6u);
  BOOST_TEST(list[2].steps < 0.1 * list[2].balls);  // moved on
  for (const auto& p : list) {
    BOOST_TEST(p.method == (&p < &list[3] ? "mariotte" : "mariotte (followed)"));
    BOOST_TEST(p.error < 1e-8);
    BOOST_TEST(p.widest < 40);
    BOOST_TEST(p.steps < 8 * p.balls);
  }
}

BOOST_FIXTURE_TEST_CASE(rivals_integrate_all_balls_and_know_the_same_answer, Session) {
  const auto run = mariotte("--accuracy 1e-8 --longest 125 --patience 100 --csv all.csv");
  BOOST_TEST(run.code == 0);
  const auto list = points(content(folder / "all.csv"));
  BOOST_TEST(list.size() == 5u);
  for (std::size_t i = 2; i < list.size(); ++i) {
    BOOST_TEST(list[i].widest == 124);
    BOOST_TEST(list[i].error < 3e-6);
    BOOST_TEST(list[i].own_seconds > 0);
    BOOST_TEST(list[i].followed_seconds > 0);
    BOOST_TEST(has(run.out, list[i].method));
  }
}

BOOST_FIXTURE_TEST_CASE(a_command_line_without_sense_gives_code_2, Session) {
  for (const char* arguments : {"--longest 10", "--accuracy 2", "--patience -1", "jump"}) {
    const auto run = mariotte(arguments);
    BOOST_TEST(run.code == 2, arguments);
    BOOST_TEST(run.err.starts_with("scaling_study: error: "));
  }
}

BOOST_FIXTURE_TEST_CASE(an_existing_file_is_kept, Session) {
  const auto run = mariotte("--longest 100 --patience 0 --csv three.toml");
  BOOST_TEST(run.code == 6);
  BOOST_TEST(has(run.err, "three.toml"));
}
