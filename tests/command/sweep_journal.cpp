// Sweeps that are killed, interrupted and done twice lose nothing.
#define BOOST_TEST_MODULE command_sweep_journal
#include <boost/test/unit_test.hpp>

#include "mariotte/study/journal/crc32.hpp"
#include "support/lines.hpp"
#include "sweep_session.hpp"

using support::content;
using support::few;
using support::has;
using support::lines;
using support::Session;
namespace fs = std::filesystem;

BOOST_FIXTURE_TEST_CASE(kills_lose_nothing_and_leave_the_same_csv, Session) {
  write("map.toml", support::map_scene(100));
  BOOST_TEST(mariotte("sweep map.toml --no-figures --out calm").code == 0);
  const auto result = support::kill_and_go_on(*this, "\"$mariotte\" sweep map.toml --no-figures --out killed",
                                              "killed", 8, 0.05);
  BOOST_TEST(result.kills > 0);
  BOOST_TEST(result.lost == 0);
  BOOST_TEST(result.ended);
  BOOST_TEST((content(folder / "killed/sweep.csv") == content(folder / "calm/sweep.csv")));
}

BOOST_FIXTURE_TEST_CASE(an_interrupted_sweep_says_so_and_goes_on, Session) {
  write("map.toml", support::map_scene(5000));
  for (const auto& [signal, code] : {std::pair("INT", 130), std::pair("TERM", 143)}) {
    const auto stopped = shell("timeout --preserve-status -s " + std::string(signal) +
                               " 0.6 \"$mariotte\" sweep map.toml --no-figures --out out");
    BOOST_TEST(stopped.code == code);
    BOOST_TEST(has(stopped.err, "the same command goes on from there"));
    BOOST_TEST(!fs::exists(folder / "out/sweep.csv"));
  }
  const auto goes_on =
      shell("timeout --preserve-status -s INT 0.6 \"$mariotte\" sweep map.toml --no-figures --out out");
  BOOST_TEST(has(goes_on.err, "of 1000000 points were done before"));
}

BOOST_FIXTURE_TEST_CASE(another_sweep_in_the_folder_is_refused_unless_forced, Session) {
  write("few.toml", few);
  BOOST_TEST(mariotte("sweep few.toml --out out").code == 0);
  const auto before = content(folder / "out/sweep.csv");
  for (const std::string change : {"--set 'chain.mass[0]=2'", "--accuracy 1e-6", "--column 'icr[0]'"}) {
    const auto refused = mariotte("sweep few.toml --out out " + change);
    BOOST_TEST(refused.code == 6);
    BOOST_TEST(has(refused.err, "have changed (--force starts anew)"));
  }
  BOOST_TEST(content(folder / "out/sweep.csv") == before);
  BOOST_TEST(mariotte("sweep few.toml --out out --force --accuracy 1e-6").code == 0);
  BOOST_TEST(content(folder / "out/sweep.csv") != before);
}

BOOST_FIXTURE_TEST_CASE(a_finished_sweep_is_not_computed_again, Session) {
  write("few.toml", few);
  BOOST_TEST(mariotte("sweep few.toml --out out").code == 0);
  const auto journal = content(folder / "out/journal.jsonl");
  const auto again = mariotte("sweep few.toml --out out");
  BOOST_TEST(again.code == 0);
  BOOST_TEST(has(again.err, "6 of 6 points were done before"));
  BOOST_TEST(content(folder / "out/journal.jsonl") == journal);
}

// A right checksum does not make a row right.
BOOST_FIXTURE_TEST_CASE(a_journal_line_of_other_rows_is_computed_again, Session) {
  write("few.toml", few);
  const std::string sweep = "sweep few.toml --out out --column final.velocity[2] --no-figures";
  BOOST_TEST(mariotte(sweep).code == 0);
  const auto csv = content(folder / "out/sweep.csv"),
             heading = lines(content(folder / "out/journal.jsonl"))[0];
  std::string rows = csv.substr(csv.find('\n') + 1);
  const auto forged = [&](const std::string& text) {
    auto escaped = text;
    for (std::size_t at = 0; (at = escaped.find('\n', at)) != std::string::npos; at += 2)
      escaped.replace(at, 1, "\\n");
    const auto body = "\"first\":0,\"count\":6,\"failed\":0,\"rows\":\"" + escaped + "\"}";
    char sum[16];
    std::snprintf(sum, sizeof sum, "%08x", mariotte::study::crc32(body));
    return heading + "\n{\"crc32\":\"" + sum + "\"," + body + "\n";
  };
  const auto number =
      lines(rows)[0].substr(0, lines(rows)[0].rfind(",separated")).substr(lines(rows)[0].find(',', 5) + 1);
  const auto with = [&](const std::string& cell) {
    return std::string(rows).replace(rows.find(number), number.size(), cell);
  };
  for (const auto& text :
       {rows, with("nonsense"), with("nan"), with("1,2"), with("1").substr(1), rows + rows}) {
    fs::remove(folder / "out/sweep.csv");
    write("out/journal.jsonl", forged(text));
    const auto again = mariotte(sweep);
    BOOST_TEST(again.code == 0);
    BOOST_TEST(has(again.err, "points were done before") == (text == rows), text);
    BOOST_TEST(content(folder / "out/sweep.csv") == csv);
  }
}

BOOST_FIXTURE_TEST_CASE(a_disk_that_is_full_loses_no_finished_point, Session) {
  write("map.toml", support::map_scene(10));
  BOOST_TEST(mariotte("sweep map.toml --no-figures --out calm").code == 0);
  const auto full =
      shell("ulimit -f 100; \"$mariotte\" sweep map.toml --no-figures --out out");  // 50 kB of 280
  BOOST_TEST(full.code == 6);
  BOOST_TEST(has(full.err, "journal.jsonl"));
  BOOST_TEST(!fs::exists(folder / "out/sweep.csv"));
  const auto goes_on = mariotte("sweep map.toml --no-figures --out out");
  BOOST_TEST(goes_on.code == 0);
  BOOST_TEST(has(goes_on.err, "points were done before"));
  BOOST_TEST((content(folder / "out/sweep.csv") == content(folder / "calm/sweep.csv")));
  BOOST_TEST(entries("out") == entries("calm"));
}

BOOST_FIXTURE_TEST_CASE(what_a_kill_left_half_written_is_cleared_away, Session) {
  write("few.toml", few);
  fs::create_directory(folder / "out");
  write("out/.sweep.csv.123.tmp", "half");
  BOOST_TEST(mariotte("sweep few.toml --out out").code == 0);
  BOOST_TEST(!fs::exists(folder / "out/.sweep.csv.123.tmp"));
}

BOOST_FIXTURE_TEST_CASE(a_sweep_that_is_being_written_is_left_alone, Session) {
  write("map.toml", support::map_scene(50000));
  const auto two = shell(
      "timeout 5 \"$mariotte\" sweep map.toml --no-figures --out out -q 2>/dev/null & sleep 0.3; "
      "\"$mariotte\" sweep map.toml --no-figures --out out; echo code $? >&2; "
      "\"$mariotte\" sweep map.toml --no-figures --out out --force; echo forced $? >&2; kill $!; wait");
  BOOST_TEST(has(two.err, "another sweep is writing it"));
  BOOST_TEST(has(two.err, "code 6"));
  BOOST_TEST(has(two.err, "forced 6"));
  BOOST_TEST(fs::exists(folder / "out/journal.jsonl"));
}
