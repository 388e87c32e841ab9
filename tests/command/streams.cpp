#define BOOST_TEST_MODULE command_streams
#include <boost/test/unit_test.hpp>

#include "session.hpp"

using support::has;
using support::Session;
namespace fs = std::filesystem;

namespace {

// Steel a thousand times too soft: possible, but suspicious.
constexpr const char* soft_steel = R"([chain]
radius = "10 mm"
material = { young = "210 MPa", poisson = 0.3, density = "7800 kg/m^3" }
law = "hertz"
balls = 2
velocity = ["1 m/s", 0]
)";

}  // namespace

BOOST_FIXTURE_TEST_CASE(warnings_go_to_stderr_unless_quiet, Session) {
  write("soft.toml", soft_steel);
  const auto loud = mariotte("run soft.toml --json");
  BOOST_TEST(loud.code == 0);
  BOOST_TEST(loud.err.starts_with("mariotte: warning: soft.toml:"));
  BOOST_TEST(nlohmann::json::parse(loud.out)["warnings"].size() > 0);
  BOOST_TEST(mariotte("run soft.toml -q").err == "");
}

BOOST_FIXTURE_TEST_CASE(verbose_tells_on_stderr_what_is_done, Session) {
  const auto run = mariotte("run three.toml -v --out results");
  BOOST_TEST(has(run.err, "mariotte: simulated 3 balls"));
  BOOST_TEST(has(run.err, "mariotte: wrote results"));
}

BOOST_FIXTURE_TEST_CASE(a_full_disk_under_stdout_gives_code_6, Session) {
  if (!fs::exists("/dev/full")) return;
  for (const char* arguments :
       {"run three.toml", "run three.toml --json", "check three.toml", "demo", "version", "--help"}) {
    const auto run = mariotte(std::string(arguments) + " >/dev/full");
    BOOST_TEST(run.code == 6, arguments);
    BOOST_TEST(has(run.err, "cannot write to standard output"));
  }
}

BOOST_FIXTURE_TEST_CASE(a_closed_stdout_gives_code_6, Session) {
  BOOST_TEST(mariotte("run three.toml >&-").code == 6);
}

BOOST_FIXTURE_TEST_CASE(a_closed_pipe_gives_code_6_without_a_word, Session) {
  const auto run = shell(
      "mkfifo pipe; { sleep 1; \"$mariotte\" run three.toml; echo code $? >&2; } >pipe & : <pipe; wait");
  BOOST_TEST(run.err == "code 6\n");
}

BOOST_FIXTURE_TEST_CASE(a_folder_that_cannot_be_made_gives_code_6_before_the_run, Session) {
  const auto run = mariotte("run three.toml --out three.toml");
  BOOST_TEST(run.code == 6);
  BOOST_TEST(run.out == "");
  BOOST_TEST(support::content(folder / "three.toml") == support::three_balls);
}

BOOST_FIXTURE_TEST_CASE(a_file_size_limit_gives_code_6_and_leaves_no_partial_file, Session) {
  const auto run = shell("ulimit -f 1; \"$mariotte\" run three.toml --out results");
  BOOST_TEST(run.code == 6);
  BOOST_TEST(!fs::exists(folder / "results/trace.csv"));
  for (const auto& entry : fs::directory_iterator(folder / "results"))
    BOOST_TEST(!entry.path().filename().string().starts_with("."));
}

BOOST_FIXTURE_TEST_CASE(what_was_computed_is_shown_where_its_files_cannot_be_written, Session) {
  for (const char* form : {"", "--json"}) {
    const auto run = shell(std::string("(ulimit -f 1; \"$mariotte\" run three.toml --out results --force ") +
                           form + "; echo code $? >&2) | cat");
    BOOST_TEST(has(run.err, "code 6"), run.err);
    BOOST_TEST(has(run.err, "[F003]"), run.err);
    BOOST_TEST(has(run.out, "-0.07095"), run.out);  // velocity of ball 1
  }
}

// The header fits, the rows do not: HDF5 meets the limit while it writes, and again when it closes the file.
BOOST_FIXTURE_TEST_CASE(a_file_size_limit_under_an_hdf5_trace_gives_code_6, Session) {
  write("row.toml",
        "[chain]\nmass = 1\nlaw = 'hertz'\nstiffness = 1\nballs = 30\n[[chain.ball]]\nnumber = 1\nvelocity = "
        "1\n");
  for (const int blocks : {1, 4, 20, 100}) {
    const auto run = shell("ulimit -f " + std::to_string(blocks) +
                           "; \"$mariotte\" run row.toml -q --trace wave.h5 --every 0.001 --force");
    BOOST_TEST(run.code == 6, "exit code " << run.code << " at " << blocks << " blocks");
    if (has(run.err, "built without HDF5")) return;
    BOOST_TEST(run.err == "mariotte: error: cannot write wave.h5: File too large [F003]\n");
    BOOST_TEST(run.out == "");
    BOOST_TEST(entries() == 2);
  }
}
