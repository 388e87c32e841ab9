// Pages in Chromium, which is not among the packages that the project needs: without it all of this is
// skipped.
#define BOOST_TEST_MODULE command_browser
#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <cstdlib>

#include "pages.hpp"
#include "session.hpp"

using support::content;
using support::has;
using support::Session;
namespace fs = std::filesystem;

namespace {

constexpr int skipped = 77;  // as CMakeLists.txt tells CTest

struct Browser {
  Browser() {
    if (std::system("command -v chromium >/dev/null") == 0) return;
    std::puts("skipped: chromium is not installed");
    std::fflush(stdout);
    std::_Exit(skipped);
  }
};

const std::string chromium =
    "timeout 60 chromium --headless --no-sandbox --disable-gpu --user-data-dir=profile ";

/// Uses the page as a reader does, and tells what it saw. Its time is virtual, and passes without frames that
/// a screen asks for.
constexpr const char* reader = R"(<pre id="told"></pre><script>
(async function () {
  const $ = id => document.getElementById(id), wait = time => new Promise(done => setTimeout(done, time));
  const last = Number($('instant').max), part = () => Number($('instant').value) / last;
  const told = {};
  window.requestAnimationFrame = frame => setTimeout(() => frame(performance.now()), 16);
  $('instant').value = 0;
  $('instant').dispatchEvent(new Event('input'));
  told.start = part();
  $('play').click();
  told.word_playing = $('play').textContent;
  await wait(1000);
  told.played = part();
  $('play').click();
  told.word_paused = $('play').textContent;
  const held = part();
  await wait(500);
  told.moved_while_paused = part() - held;
  const box = $('timeline').getBoundingClientRect();
  const pointer = (place, buttons) => $('timeline').dispatchEvent(
      new PointerEvent('pointermove', {buttons, clientX: box.left + place * box.width}));
  pointer(0.5, 1);
  told.dragged = part();
  pointer(0.75, 0);
  told.hovered = part();
  $('play').click();
  await wait(8000);
  told.ended = part();
  told.word_ended = $('play').textContent;
  $('told').textContent = JSON.stringify(told);
})();
</script>)";

/// Copies one number, one line and two lines of the first table.
constexpr const char* copyist = R"(<pre id="told"></pre><script>
(function () {
  const rows = document.querySelectorAll('table')[0].rows;
  function copied(first, last) {
    const range = document.createRange();
    range.setStart(first.firstChild, 0);
    range.setEnd(last.firstChild, last.firstChild.length);
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    const event = new ClipboardEvent('copy', {clipboardData: new DataTransfer(), cancelable: true});
    document.dispatchEvent(event);
    return event.clipboardData.getData('text/plain');
  }
  const end = row => row.cells[row.cells.length - 1];
  document.getElementById('told').textContent = JSON.stringify({
    number: copied(end(rows[1]), end(rows[1])),
    line: copied(rows[1].cells[0], end(rows[1])),
    lines: copied(rows[0].cells[0], end(rows[2])),
    title: copied(document.querySelector('h1'), document.querySelector('h1')),
  });
})();
</script>)";

/// What a script tells that is added to a page.
nlohmann::json told(Session& session, const std::string& file, const std::string& script,
                    const std::string& options) {
  auto page = content(session.folder / file);
  session.write("used.html", page.insert(page.rfind("</body>"), script));
  const auto dom = session.shell(chromium + options + " --dump-dom \"file://$PWD/used.html\"");
  const std::string opening = "<pre id=\"told\">";
  const auto from = dom.out.find(opening) + opening.size();
  return nlohmann::json::parse(dom.out.substr(from, dom.out.find("</pre>", from) - from), nullptr, false);
}

}  // namespace

BOOST_TEST_GLOBAL_FIXTURE(Browser);

BOOST_FIXTURE_TEST_CASE(a_browser_has_nothing_to_complain_about, Session) {
  write("sweep.toml", support::sweep_of_four());
  BOOST_TEST(mariotte("run three.toml --out out --report").code == 0);
  BOOST_TEST(mariotte("sweep sweep.toml --out swept --report").code == 0);
  for (const auto* page : {"out 1280", "out 400", "swept 1280", "swept 400"}) {
    const std::string where = page, width = where.substr(where.find(' ') + 1);
    const auto seen = shell(chromium + "--enable-logging=stderr --window-size=" + width +
                            ",1200 --screenshot=page.png \"file://$PWD/" + where.substr(0, where.find(' ')) +
                            "/report.html\"");
    BOOST_TEST(seen.code == 0);
    BOOST_TEST(!has(seen.err, "CONSOLE"));
    BOOST_TEST(fs::file_size(folder / "page.png") > 10'000);
  }
}

// The picture begins at the largest force; its script has drawn it when the clock tells the instant.
BOOST_FIXTURE_TEST_CASE(a_browser_draws_the_moving_picture, Session) {
  BOOST_TEST(mariotte("run three.toml --out out --report").code == 0);
  const auto dom = shell(chromium + "--window-size=400,1200 --dump-dom \"file://$PWD/out/report.html\"");
  BOOST_TEST(has(dom.out, "<output id=\"clock\">t = "));
  BOOST_TEST(has(dom.out, "Arrows are forces; the longest is "));
}

// One pass takes 8 s.
BOOST_FIXTURE_TEST_CASE(the_moving_picture_plays_pauses_and_is_dragged, Session) {
  BOOST_TEST(mariotte("run three.toml --out out --report").code == 0);
  const auto told =
      ::told(*this, "out/report.html", reader, "--virtual-time-budget=60000 --window-size=900,1200");
  BOOST_TEST_REQUIRE(told.is_object());
  BOOST_TEST(told["start"] == 0);
  BOOST_TEST(told["word_playing"] == "Pause");
  BOOST_TEST((told["played"] > 0.1 && told["played"] < 0.15), told);
  BOOST_TEST(told["word_paused"] == "Play");
  BOOST_TEST(told["moved_while_paused"] == 0);
  BOOST_TEST(told["dragged"].get<double>() == 0.5, boost::test_tools::tolerance(1e-2));
  BOOST_TEST(told["hovered"] == told["dragged"]);
  BOOST_TEST(told["ended"] == 1);
  BOOST_TEST(told["word_ended"] == "Play");
}

// Four digits are shown; the page's tables say units above.
BOOST_FIXTURE_TEST_CASE(copied_numbers_have_all_digits, Session) {
  BOOST_TEST(mariotte("run three.toml --out out --report").code == 0);
  const auto told = ::told(*this, "out/report.html", copyist, "--window-size=900,1200");
  BOOST_TEST_REQUIRE(told.is_object());
  const auto result = nlohmann::json::parse(content(folder / "out/result.json"));
  const auto digits = [&](std::size_t ball) { return result["final"]["velocity"][ball].dump(); };
  BOOST_TEST(told["number"] == digits(0));
  BOOST_TEST(told["title"] == "Three balls");
  BOOST_TEST(told["line"] == "1\t1\t1\t" + digits(0));
  BOOST_TEST(told["lines"] == "ball\tmass [kg]\tvelocity before [m/s]\tvelocity after [m/s]\n1\t1\t1\t" +
                                  digits(0) + "\n2\t1\t0\t" + digits(1));
}
