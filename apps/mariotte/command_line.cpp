#include "command.hpp"
#include "command_line/program.hpp"
#include "mariotte/report/page/provenance.hpp"

namespace mariotte::command {
namespace {

constexpr const char* first_examples = R"(Examples:
  mariotte demo                                  five steel balls, no file needed
  mariotte init newton_cradle_5 cradle.toml      a scene to start from
  mariotte run cradle.toml                       a table of the impact
  mariotte run cradle.toml --out results         also files and figures
  mariotte run cradle.toml --json > cradle.json  the same for scripts
  mariotte sweep map.toml --out results          many scenes, by its [[sweep]] tables
  mariotte law cradle.toml                       the same impact by the multiple-impact law
  mariotte capture microsphere.toml              how slow a microbody may be to get off again
  mariotte restitution steel_pair.toml --from 0.1 --to 10   of two bodies, by their speed
  mariotte modes pressed_row.toml                frequencies and shapes of small vibrations
  mariotte sensitivity triplet.toml              how the outcome changes with every parameter
  mariotte fit microsphere.toml measured.csv     its damping from measured restitution
  mariotte materials                             materials that scenes can name, with sources
  mariotte explain S010                          what an error means, by the code of its message
  mariotte help run                              all about one command, as run --help

Exit codes: 0 ok, 1 check failed, 2 usage, 3 scene error, 4 solver failure, 5 a limit was reached,
6 file error, 130 or 143 interrupted.
)";

}  // namespace

int command_line(int argc, char** argv) noexcept {
  Command program{.name = "mariotte",
                  .about = "Stiff, event-driven impacts: balls in a chain, microbodies on a plane.",
                  .footer = first_examples,
                  .version = "mariotte " + report::provenance().version};
  program.commands = {
      run_command(),         check_command(),       law_command(),        sweep_command(),
      capture_command(),     restitution_command(), modes_command(),      sensitivity_command(),
      uncertainty_command(), fit_command(),         report_command(),     demo_command(),
      init_command(),        reproduce_command(),   study_command(),      materials_command(),
      explain_command(),     version_command(),     man_command(program), completion_command(program)};
  return run_program(program, argc, argv);
}

}  // namespace mariotte::command
