// Sweeps under mpirun.
#define BOOST_TEST_MODULE command_sweep_ranks
#include <boost/test/unit_test.hpp>

#include "sweep_session.hpp"

namespace fs = std::filesystem;
using support::content;
using support::has;
using support::mpirun;
using support::Session;

BOOST_FIXTURE_TEST_CASE(any_number_of_ranks_gives_the_same_csv, Session) {
  write("map.toml", support::map_scene(20));
  BOOST_TEST(mariotte("sweep map.toml --no-figures --out alone").code == 0);
  for (const int ranks : {1, 2, 4}) {
    const auto out = "o" + std::to_string(ranks);
    const auto run =
        shell(mpirun(ranks) + "\"$mariotte\" sweep map.toml --no-figures --threads 1 --out " + out);
    BOOST_TEST(run.code == 0);
    BOOST_TEST(run.out == "4000 points, all with a result: " + out + "/sweep.csv\n");
    BOOST_TEST((content(folder / out / "sweep.csv") == content(folder / "alone/sweep.csv")));
  }
}

BOOST_FIXTURE_TEST_CASE(what_some_ranks_have_done_others_go_on_with, Session) {
  write("map.toml", support::map_scene(3000));
  BOOST_TEST(mariotte("sweep map.toml --no-figures --out alone").code == 0);
  const std::string sweep = "\"$mariotte\" sweep map.toml --no-figures --threads 1 --out out -q";
  BOOST_TEST(shell(support::struck("KILL", mpirun(3) + sweep, "out")).code == 137);
  BOOST_TEST(shell(support::struck("TERM", mpirun(2) + sweep, "out")).code != 0);
  BOOST_TEST(!fs::exists(folder / "out/sweep.csv"));
  const auto last = mariotte("sweep map.toml --no-figures --out out");
  BOOST_TEST(last.code == 0);
  BOOST_TEST(has(last.err, "points were done before"));
  BOOST_TEST((content(folder / "out/sweep.csv") == content(folder / "alone/sweep.csv")));
}

BOOST_FIXTURE_TEST_CASE(one_rank_that_cannot_go_on_ends_all, Session) {
  write("map.toml", support::map_scene(20));
  const auto bad = shell(mpirun(2) + "\"$mariotte\" sweep map.toml --no-figures --out out --set chain.mas=1");
  BOOST_TEST(bad.code == 3);
  BOOST_TEST(bad.err.find("mariotte: error: ") == bad.err.rfind("mariotte: error: "));
}
