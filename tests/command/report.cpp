#define BOOST_TEST_MODULE command_report
#include <boost/test/unit_test.hpp>

#include "pages.hpp"
#include "session.hpp"

using support::content;
using support::has;
using support::Session;
namespace fs = std::filesystem;

BOOST_FIXTURE_TEST_CASE(run_and_report_make_the_same_page, Session) {
  BOOST_TEST(mariotte("run three.toml --out out --report").code == 0);
  const auto page = content(folder / "out/report.html");
  BOOST_TEST(has(page, "<title>Three balls</title>"));
  BOOST_TEST(has(page, "separated"));
  fs::remove(folder / "out/report.html");
  const auto again = mariotte("report out");
  BOOST_TEST(again.code == 0);
  BOOST_TEST(again.out == "out/report.html\n");
  BOOST_TEST((content(folder / "out/report.html") == page));
}

BOOST_FIXTURE_TEST_CASE(the_command_on_the_page_gives_the_same_result, Session) {
  const auto run = mariotte(
      "run three.toml --out out --accuracy 1e-7 --flow cvode-adams --set 'chain.velocity[0]=2 m/s' --json");
  const auto result = nlohmann::json::parse(run.out);
  BOOST_TEST(result["accuracy"]["requested"] == 1e-7);
  BOOST_TEST(mariotte("report out").code == 0);
  const auto page = content(folder / "out/report.html");
  const auto start = page.find("mariotte run '"), end = page.find("</pre>", start);
  BOOST_TEST_REQUIRE(end != std::string::npos);
  const auto repeated =
      mariotte(page.substr(start + std::string("mariotte ").size(), end - start - 9) + " --json");
  const auto again = nlohmann::json::parse(repeated.out);
  for (const auto* part : {"final", "events", "flows", "accuracy", "provenance"})
    BOOST_TEST((again[part] == result[part]), part);
}

BOOST_FIXTURE_TEST_CASE(a_page_of_an_earlier_run_is_not_left_beside_a_new_one, Session) {
  BOOST_TEST(mariotte("run three.toml --out out --report").code == 0);
  BOOST_TEST(mariotte("report out").code == 6);
  BOOST_TEST(mariotte("report out --force").code == 0);
  BOOST_TEST(mariotte("run three.toml --out out --force").code == 0);
  BOOST_TEST(!fs::exists(folder / "out/report.html"));
}

BOOST_FIXTURE_TEST_CASE(a_sweep_has_a_page_too, Session) {
  write("sweep.toml", support::sweep_of_four());
  BOOST_TEST(mariotte("sweep sweep.toml --out out --report --column 'icr[0]'").code == 0);
  const auto page = content(folder / "out/report.html");
  for (const auto* part : {"<b>4</b>", "<b>1</b>", "chain.gap", "0, -0.125", "icr[0]", "separated",
                           "rejected", "must not be negative", "data:image/svg+xml"})
    BOOST_TEST(has(page, part), part);
  BOOST_TEST(mariotte("report out --force").code == 0);
  BOOST_TEST((content(folder / "out/report.html") == page));
}

BOOST_FIXTURE_TEST_CASE(the_command_on_the_page_of_a_sweep_makes_the_same_rows, Session) {
  write("sweep.toml", support::sweep_of_four());
  BOOST_TEST(mariotte("sweep sweep.toml --out out --accuracy 1e-7 --column 'final.velocity[*]'").code == 0);
  BOOST_TEST(mariotte("report out").code == 0);
  const auto page = content(folder / "out/report.html");
  const auto start = page.find("sweep 'sweep.toml'"), end = page.find("</pre>", start);
  BOOST_TEST_REQUIRE(end != std::string::npos);
  BOOST_TEST(mariotte(page.substr(start, end - start)).code == 0);
  BOOST_TEST((content(folder / "again/sweep.csv") == content(folder / "out/sweep.csv")));
}

BOOST_FIXTURE_TEST_CASE(a_page_of_another_sweep_is_not_left_beside_a_new_one, Session) {
  write("sweep.toml", support::sweep_of_four());
  BOOST_TEST(mariotte("sweep sweep.toml --out out --report").code == 0);
  BOOST_TEST(mariotte("sweep sweep.toml --out out --force --accuracy 1e-7").code == 0);
  BOOST_TEST(!fs::exists(folder / "out/report.html"));
  fs::remove(folder / "out/sweep.csv");
  const auto torn = mariotte("report out");
  BOOST_TEST(torn.code == 6);
  BOOST_TEST(has(torn.err, "sweep.csv: cannot be read"));
}

BOOST_FIXTURE_TEST_CASE(a_folder_without_a_result_is_refused, Session) {
  BOOST_TEST(mariotte("report nowhere").code == 6);
  fs::create_directory(folder / "out");
  write("out/result.json", "{ half");
  const auto bad = mariotte("report out");
  BOOST_TEST(bad.code == 6);
  BOOST_TEST(has(bad.err, "holds no result"));
  BOOST_TEST(mariotte("run three.toml --report").code == 2);
}

BOOST_FIXTURE_TEST_CASE(a_sweep_that_is_not_finished_is_told, Session) {
  fs::create_directory(folder / "out");
  std::ofstream(folder / "out/journal.jsonl") << "{}\n";
  const auto refused = mariotte("report out");
  BOOST_TEST(refused.code == 6);
  BOOST_TEST(has(refused.err, "its sweep is not finished"), refused.err);
}

BOOST_FIXTURE_TEST_CASE(a_window_behind_the_end_is_told_of, Session) {
  const auto run = mariotte("run three.toml --out out --set 'figure.window=[50, 60]'");
  BOOST_TEST(run.code == 0);
  BOOST_TEST(has(run.err, "figure.window begins at 50 s, but the run ended at"), run.err);
}

BOOST_FIXTURE_TEST_CASE(a_page_animates_the_run_with_its_own_data, Session) {
  BOOST_TEST(mariotte("run three.toml --out out --report").code == 0);
  const auto page = content(folder / "out/report.html");
  const auto block = [&](const std::string& opening) {
    const auto from = page.find(opening);
    BOOST_TEST_REQUIRE(from != std::string::npos);
    return page.substr(from + opening.size(), page.find("</script>", from) - from - opening.size());
  };
  const auto data = nlohmann::json::parse(block("<script id=\"motion\" type=\"application/json\">"));
  auto stored = nlohmann::json::parse(content(folder / "out/motion.json"));
  BOOST_TEST(data["move"] == stored["move"]);
  const auto result = nlohmann::json::parse(content(folder / "out/result.json"));
  BOOST_TEST(data["discs"].size() == result["final"]["velocity"].size());
  BOOST_TEST(data["contacts"].size() == result["contacts"].size());
  write("script.js", block("<script>"));
  if (shell("command -v node").code == 0) BOOST_TEST(shell("node --check script.js").code == 0);
  BOOST_TEST(mariotte("report out --force").code == 0);
  BOOST_TEST(content(folder / "out/report.html") == page);
}
