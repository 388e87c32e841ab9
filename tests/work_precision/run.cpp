#define BOOST_TEST_MODULE work precision run
#include <array>
#include <boost/test/unit_test.hpp>
#include <map>
#include <sstream>
#include <vector>

#include "command/session.hpp"
#include "support/lines.hpp"

using support::fields;
using support::has;
using support::Session;
namespace fs = std::filesystem;

namespace {

using Rows = std::vector<std::map<std::string, std::string>>;  // by the name of the column

Rows rows(const fs::path& csv) {
  std::istringstream in(support::content(csv));
  std::string line;
  std::getline(in, line);
  const auto names = fields(line);
  Rows table;
  while (std::getline(in, line)) {
    const auto values = fields(line);
    BOOST_TEST_REQUIRE(values.size() == names.size());
    auto& row = table.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values[i];
  }
  return table;
}

/// What each method can reach.
std::map<std::string, double> least_errors(const fs::path& csv) {
  std::map<std::string, double> best;
  for (const auto& row : rows(csv)) {
    const double error = std::stod(row.at("error"));
    const auto [at, first] = best.emplace(row.at("method"), error);
    if (!first) at->second = std::min(at->second, error);
  }
  return best;
}

/// The first numbers of each row of a table, which follow its name; the first line is the header.
template <std::size_t count>
std::vector<std::array<double, count>> numbers_of_rows(const std::string& table) {
  std::istringstream lines(table);
  std::string line;
  std::vector<std::array<double, count>> rows;
  for (std::getline(lines, line); std::getline(lines, line);) {
    std::istringstream numbers(line.substr(line.find("  ")));
    auto& row = rows.emplace_back();
    for (double& one : row) numbers >> one;
    BOOST_TEST_REQUIRE(!numbers.fail(), line);
  }
  return rows;
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(csv_has_a_row_per_method_and_tolerance, Session) {
  const auto run =
      mariotte("--quick --problem P1 --method auto --method odeint --method rk-gill --csv points.csv");
  BOOST_TEST(run.code == 0);
  const auto text = support::content(folder / "points.csv");
  BOOST_TEST(text.starts_with("problem,method,tolerance,error,seconds,rhs,steps,events\n"));
  for (const char* method : {"auto", "odeint-rkf78", "odeint-bulirsch-stoer", "rk-gill"})
    BOOST_TEST(has(text, std::string("\nP1,") + method + ","), method);
}

BOOST_FIXTURE_TEST_CASE(auto_keeps_the_accuracy_it_is_asked_for, Session) {
  mariotte(
      "--quick --problem P1 --problem P2 --problem P3 --problem V --problem B --method auto --csv "
      "points.csv");
  std::size_t seen = 0;
  for (const auto& row : rows(folder / "points.csv")) {
    if (row.at("tolerance") != "1e-10") continue;
    BOOST_TEST(std::stod(row.at("error")) < 1e-10, row.at("problem"));
    ++seen;
  }
  BOOST_TEST(seen == 13);
}

// The references are no one's own: methods that share nothing meet there. A cut-off force costs those that
// locate no events some digits; the tightest rungs of the ladders still reach this.
BOOST_FIXTURE_TEST_CASE(every_method_converges_to_the_reference, Session) {
  for (const std::string problem : {"P1", "B-sphere"}) {
    mariotte("--quick --force --problem " + problem + " --csv points.csv");
    const auto best = least_errors(folder / "points.csv");
    BOOST_TEST(best.size() >= 10);
    for (const auto& [method, error] : best) BOOST_TEST(error < 1e-7, problem << " " << method);
  }
}

// Friction that turns about within a slip of finite width is another problem than Coulomb's: its error stays.
BOOST_FIXTURE_TEST_CASE(smoothed_friction_converges_to_something_else, Session) {
  mariotte(
      "--quick --problem B-rod-0.15 --problem B-space --method auto --method odeint-dopri5 --method "
      "sundials-adams-roots --csv points.csv");
  const auto best = least_errors(folder / "points.csv");
  BOOST_TEST(best.size() == 7);
  for (const auto& [method, error] : best)
    if (method.ends_with("-1e-3"))
      BOOST_TEST((error > 1e-7 && error < 1e-3), method << " " << error);
    else
      BOOST_TEST(error < 1e-9, method << " " << error);
}

// A tip that sticks is beyond methods that follow no events; those of this library meet.
BOOST_FIXTURE_TEST_CASE(a_tip_that_sticks_needs_events, Session) {
  mariotte("--quick --problem B-rod-0.7 --method auto --method cvode --method odeint-rkf78 --csv points.csv");
  const auto best = least_errors(folder / "points.csv");
  BOOST_TEST(best.size() == 8);
  for (const auto& [method, error] : best)
    if (method.starts_with("odeint"))
      BOOST_TEST((error > 1e-6 && error < 1e-2), method << " " << error);
    else
      BOOST_TEST(error < 1e-11, method << " " << error);
}

BOOST_FIXTURE_TEST_CASE(results_go_to_stdout_and_progress_to_stderr, Session) {
  const auto run = mariotte("--quick --problem P3-1 --method auto");
  BOOST_TEST(has(run.out, "P3-1 "));
  BOOST_TEST(has(run.out, "ratio"));
  BOOST_TEST(run.err == "P3-1 by auto\n");
  BOOST_TEST(entries() == 1);
}

BOOST_FIXTURE_TEST_CASE(an_unknown_problem_or_method_gives_code_2_and_the_known_ones, Session) {
  const auto problem = mariotte("--problem P9");
  BOOST_TEST(problem.code == 2);
  BOOST_TEST(problem.out == "");
  BOOST_TEST(has(problem.err, "unknown problem 'P9' (one of: P1, P2-0.1, "));
  BOOST_TEST(has(problem.err, "map)"));
  const auto method = mariotte("--method euler");
  BOOST_TEST(method.code == 2);
  BOOST_TEST(has(method.err, "unknown method 'euler' (one of: auto, "));
  BOOST_TEST(mariotte("--bogus").code == 2);
}

BOOST_FIXTURE_TEST_CASE(figures_are_drawn_or_their_absence_is_said, Session) {
  const auto run = mariotte("--quick --problem P3-1 --method auto --method verlet --plots figures");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(fs::file_size(folder / "figures/plot.csv") > 0);
  const bool drawn = fs::exists(folder / "figures/P3-1.png") && fs::exists(folder / "figures/P3-1.svg");
  BOOST_TEST(drawn == !has(run.err, "no figures"));
}

BOOST_FIXTURE_TEST_CASE(files_are_not_overwritten_unless_forced, Session) {
  write("points.csv", "mine");
  const std::string arguments = "--quick --problem P3-1 --method auto --csv points.csv";
  BOOST_TEST(mariotte(arguments).code == 6);
  BOOST_TEST(support::content(folder / "points.csv") == "mine");
  BOOST_TEST(mariotte(arguments + " --force").code == 0);
  BOOST_TEST(support::content(folder / "points.csv") != "mine");
}

BOOST_FIXTURE_TEST_CASE(pairs_of_every_law_part_alike_by_either_flow, Session) {
  const auto run = mariotte("--quick --laws");
  BOOST_TEST(run.code == 0);
  const auto rows = numbers_of_rows<5>(run.out);
  for (const auto& [accuracy, time, adams, ratio, difference] : rows)
    BOOST_TEST(difference <= 2 * accuracy, accuracy << " in " << time << ", " << adams << ", " << ratio);
  BOOST_TEST(rows.size() == 26u);
}

BOOST_FIXTURE_TEST_CASE(small_impacts_are_alike_one_by_one_and_side_by_side, Session) {
  const auto run = mariotte("--quick --lanes");
  BOOST_TEST(run.code == 0);
  const auto rows = numbers_of_rows<5>(run.out);
  for (const auto& [accuracy, alone, lanes, ratio, difference] : rows)
    BOOST_TEST(difference <= accuracy, accuracy << " in " << alone << ", " << lanes << ", " << ratio);
  BOOST_TEST(rows.size() == 23u);
}

BOOST_FIXTURE_TEST_CASE(bodies_with_friction_are_as_accurate_as_asked_by_either_flow, Session) {
  const auto run = mariotte("--quick --friction");
  BOOST_TEST(run.code == 0);
  const auto rows = numbers_of_rows<5>(run.out);
  for (const auto& [accuracy, time, error, adams, adams_error] : rows) {
    BOOST_TEST(error <= accuracy, accuracy << " in " << time);
    BOOST_TEST(adams_error <= accuracy, accuracy << " in " << adams);
  }
  BOOST_TEST(rows.size() == 15u);
}

// Two balls that hardly slip need no events; of a rigid stick, or beyond a rival's patience, there is a dash.
BOOST_FIXTURE_TEST_CASE(rivals_without_events_stand_beside_bodies_with_friction, Session) {
  const auto run = mariotte("--quick --friction");
  std::istringstream lines(run.out);
  std::string line;
  std::map<std::string, int> reached;
  while (std::getline(lines, line)) {
    std::istringstream words(line.substr(std::min<std::size_t>(24, line.size())));
    const std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
    BOOST_TEST_REQUIRE(all.size() == 8u, line);
    reached[line.substr(0, 12)] += all[6] != "–";
  }
  BOOST_TEST(reached.at("two balls, M") == 3);
  BOOST_TEST(reached.at("touching 6, ") == 1);
}

// CVODES finds the same slopes to the accuracy, or its time does not stand there.
BOOST_FIXTURE_TEST_CASE(slopes_are_measured_beside_those_of_cvodes, Session) {
  const auto run = mariotte("--quick --slopes");
  BOOST_TEST(run.code == 0);
  std::istringstream lines(run.out);
  std::string line;
  int hertz = 0, rows = 0;
  while (std::getline(lines, line)) {
    std::istringstream numbers(line.substr(std::min<std::size_t>(22, line.size())));
    const std::vector<double> all{std::istream_iterator<double>(numbers), {}};
    hertz += line.starts_with("Hertz") && all.size() == 7;
    rows += line.find(" balls ") < 8 && all.size() == 5;
  }
  BOOST_TEST(hertz == 4);
  BOOST_TEST(rows == 6);
}

// Where both have the same model, LAMMPS comes as near as the order of its steps lets it.
BOOST_FIXTURE_TEST_CASE(lammps_comes_nearer_with_shorter_steps_if_it_is_there, Session) {
  const auto run = mariotte("--quick --lammps");
  BOOST_TEST(run.code == 0);
  if (run.out == "LAMMPS (lmp) is not installed.\n") return;
  std::istringstream lines(run.out);
  std::string line;
  std::map<std::string, double> last;
  for (std::getline(lines, line); std::getline(lines, line);) {
    std::istringstream numbers(line.substr(22));
    double steps = 0, error = 0;
    numbers >> steps >> error;
    last[line.substr(0, line.find("  "))] = error;
  }
  BOOST_TEST(last.size() == 8u);
  for (const auto& [name, most] : std::map<std::string, double>{{"hertz", 1e-11},
                                                                {"hooke, velocity", 3e-5},
                                                                {"hertz, viscoelastic", 1e-7},
                                                                {"hertz, tsuji", 3e-6},
                                                                {"dmt", 1e-5}})
    BOOST_TEST(last.at(name) < most, name << ": " << last.at(name));
}
