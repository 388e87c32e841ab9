// Runs that are killed while they write.
#define BOOST_TEST_MODULE command_kills
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>
#include <sstream>

#include "session.hpp"

using support::content;
using support::Session;
namespace fs = std::filesystem;

namespace {

/// Whether a file of a run is there to its end.
bool is_whole(const fs::path& path) {
  const auto text = content(path);
  const auto kind = path.extension();
  if (kind == ".json") return nlohmann::json::accept(text);
  if (kind == ".svg") return text.ends_with("</svg>\n\n") || text.ends_with("</svg>\n");
  if (kind == ".png") return text.find("IEND") != std::string::npos;
  if (kind == ".html") return text.ends_with("</html>\n");
  return text.ends_with('\n');
}

fs::path part_of_trace(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".part") return entry.path();
  return {};
}

/// Every row but the last has a value in each column. The last may be cut short: a kill can stop the system
/// within a write, where a page of the file ends.
void expect_whole_rows(const std::string& table) {
  const auto end_of_header = table.find('\n');
  BOOST_TEST_REQUIRE(end_of_header != std::string::npos);
  const auto commas = std::count(table.begin(), table.begin() + static_cast<long>(end_of_header), ',');
  std::istringstream rows(table);
  for (std::string row; std::getline(rows, row) && !rows.eof();)
    BOOST_TEST(std::count(row.begin(), row.end(), ',') == commas, row);
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(a_run_killed_at_any_moment_leaves_whole_files, Session) {
  const std::string run = "run three.toml --out out --report --force -q";
  std::mt19937 random(1);
  int kills = 0, files = 0;
  for (int i = 0; i < 30; ++i) {
    const double after = std::uniform_real_distribution<double>(0.0, 0.6)(random);
    kills += shell("timeout -s KILL " + std::to_string(after) + " \"$mariotte\" " + run).code == 137;
    if (!fs::exists(folder / "out")) continue;
    for (const auto& entry : fs::directory_iterator(folder / "out"))
      if (const auto name = entry.path().filename().string(); !name.starts_with(".")) {
        BOOST_TEST(is_whole(entry.path()), name << " after " << after << " s");
        ++files;
      }
  }
  BOOST_TEST(kills > 0);
  BOOST_TEST(files > 30);
  BOOST_TEST(mariotte(run).code == 0);
  for (const auto& entry : fs::directory_iterator(folder / "out"))
    BOOST_TEST(!entry.path().filename().string().starts_with("."));
}

BOOST_FIXTURE_TEST_CASE(a_killed_trace_leaves_the_rows_it_had, Session) {
  const auto killed = shell(
      "\"$mariotte\" run three.toml --trace wave.csv --every 1e-7 -q --force & run=$!; "
      "until [ -s wave.csv.$run.part ]; do kill -0 $run || exit 9; done; kill -s KILL $run; wait $run");
  BOOST_TEST(killed.code == 137);
  BOOST_TEST(!fs::exists(folder / "wave.csv"));
  const auto rows = content(part_of_trace(folder));
  BOOST_TEST(rows.starts_with("time [s],v1 [m/s]"));
  expect_whole_rows(rows);
}

BOOST_FIXTURE_TEST_CASE(an_interrupted_trace_names_the_file_with_its_rows, Session) {
  for (const std::string trace : {"wave.csv", "wave.h5"}) {
    const auto stopped = shell("\"$mariotte\" run three.toml --force --trace " + trace +
                               " --every 1e-7 & run=$!; until [ -s " + trace +
                               ".$run.part ]; do kill -0 $run || exit 9; done; kill -s INT $run; wait $run");
    if (support::has(stopped.err, "built without HDF5")) return;
    BOOST_TEST(stopped.code == 130);
    BOOST_TEST(support::has(stopped.out, "interrupted at "));
    BOOST_TEST(!fs::exists(folder / trace));
    const auto left = part_of_trace(folder);
    BOOST_TEST(support::has(
        stopped.err, "mariotte: the rows until the interruption are in " + left.filename().string() + "\n"));
    BOOST_TEST(content(left).starts_with(trace == "wave.csv" ? "time [s],v1 [m/s]" : "\x89HDF"));
    fs::remove(left);
  }
}

BOOST_FIXTURE_TEST_CASE(an_interrupted_run_keeps_what_it_has, Session) {
  for (const auto& [signal, code] : {std::pair("INT", 130), {"TERM", 143}}) {
    const auto stopped = shell(std::string("\"$mariotte\" run " MARIOTTE_SCENES
                                           "/heavy_striker.toml --flow cvode-adams --force --out out "
                                           "> table & run=$!; sleep 1; kill -s ") +
                               signal + " $run; wait $run");
    BOOST_TEST(stopped.code == code);
    BOOST_TEST(support::has(stopped.err, "warning: interrupted"));
    BOOST_TEST(support::has(content(folder / "table"), "interrupted at "));
    const auto result = nlohmann::json::parse(content(folder / "out/result.json"));
    BOOST_TEST(result["ending"] == "interrupted");
    BOOST_TEST(result["final"]["velocity"].size() == 200);
    BOOST_TEST(std::abs(result["energy"]["residual"].get<double>()) < 1e-8);
    BOOST_TEST(fs::file_size(folder / "out/trace.csv") > 0);
  }
}

BOOST_FIXTURE_TEST_CASE(an_interrupted_check_of_the_accuracy_is_no_success, Session) {
  for (const std::string seconds : {"1", "3"}) {  // of about ten, during the run and during its check
    const auto stopped = shell("\"$mariotte\" run " MARIOTTE_SCENES
                               "/heavy_striker.toml --set chain.balls=400 > table & run=$!; sleep " +
                               seconds + "; kill -s INT $run; wait $run");
    BOOST_TEST(stopped.code == 130);
    BOOST_TEST(support::has(stopped.err, "warning: interrupted"));
  }
}

BOOST_FIXTURE_TEST_CASE(a_run_is_interrupted_within_a_phase_without_events, Session) {
  write("cage.toml",
        "[chain]\nmass = [inf, 1, inf]\nvelocity = [0, 0.01, 0]\nlaw = 'hertz'\nstiffness = 1\ngap = -0.1\n"
        "precompressed = true\n[run]\nuntil = 1e9\n");
  const auto stopped =
      shell("\"$mariotte\" run cage.toml > table & run=$!; sleep 1; kill -s INT $run; wait $run");
  BOOST_TEST(stopped.code == 130);
  BOOST_TEST(support::has(content(folder / "table"), "interrupted at "));
}

BOOST_FIXTURE_TEST_CASE(a_disk_that_is_full_leaves_the_files_of_the_run_before, Session) {
  BOOST_TEST(mariotte("run three.toml --out out").code == 0);
  const auto before = content(folder / "out/trace.csv");
  const auto full = shell("ulimit -f 4; \"$mariotte\" run three.toml --out out --force --accuracy 1e-6");
  BOOST_TEST(full.code == 6);
  BOOST_TEST((content(folder / "out/trace.csv") == before));
}
