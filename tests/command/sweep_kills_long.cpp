// 200 kills at random moments of a sweep over 10⁵ points, of every number of threads and ranks.
#define BOOST_TEST_MODULE command_sweep_kills_long
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "sweep_session.hpp"

namespace {

/// Columns that the quick run of a chain does not have, and an accuracy that takes its time, make the sweep
/// long enough for so many kills.
const std::string sweep =
    "\"$mariotte\" sweep map.toml --no-figures -q --column 'contacts[*].peak_force' --accuracy 1e-13 --out ";

struct Calm : support::Session {
  std::string csv;

  Calm() {
    write("map.toml", support::map_scene(500));
    BOOST_TEST(shell(sweep + "calm").code == 0);
    csv = support::content(folder / "calm/sweep.csv");
    BOOST_TEST(std::count(csv.begin(), csv.end(), '\n') == 100'001);
  }

  void expect_the_same_after_kills(const std::string& before, const std::string& after, double longest) {
    std::filesystem::remove_all(folder / "killed");
    const auto line = before + sweep + "killed" + after;
    const auto result = support::kill_and_go_on(*this, line, "killed", 200, longest);
    BOOST_TEST_MESSAGE(line << ": " << result.kills << " kills, " << result.lost << " losses");
    BOOST_TEST(result.kills > 100);
    BOOST_TEST(result.lost == 0);
    BOOST_TEST(result.ended);
    BOOST_TEST((support::content(folder / "killed/sweep.csv") == csv));
  }
};

}  // namespace

BOOST_FIXTURE_TEST_CASE(two_hundred_kills_lose_nothing_on_any_number_of_threads, Calm) {
  for (const int threads : {1, 2, 3})
    expect_the_same_after_kills("", " --threads " + std::to_string(threads), 0.1);
}

#ifdef MARIOTTE_MPI
BOOST_FIXTURE_TEST_CASE(two_hundred_kills_lose_nothing_on_any_number_of_ranks, Calm) {
  for (const int ranks : {1, 2, 4}) expect_the_same_after_kills(support::mpirun(ranks), " --threads 1", 0.6);
}
#endif
