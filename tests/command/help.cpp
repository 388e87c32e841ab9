// Commands that need no scene: what the program can do, and a scene to start from.
#define BOOST_TEST_MODULE command_help
#include <boost/test/unit_test.hpp>

#include "session.hpp"

using support::has;
using support::Session;

BOOST_FIXTURE_TEST_CASE(version_says_what_the_program_can_use, Session) {
  const auto version = mariotte("version").out;
  for (const char* part : {"\nMPI ", "\nHDF5 ", "\ngnuplot "}) BOOST_TEST(has(version, part));
  BOOST_TEST(has(shell("PATH=/nowhere \"$mariotte\" version").out, "\ngnuplot none\n"));
}

BOOST_FIXTURE_TEST_CASE(materials_lists_values_and_their_sources, Session) {
  const auto table = mariotte("materials");
  BOOST_TEST(table.code == 0);
  BOOST_TEST(has(table.out, "steel          203"));
  BOOST_TEST(has(table.out, "  yield_strength: "));
  BOOST_TEST(has(table.out, "70     0.23             2400                     –\n"));
  BOOST_TEST(has(table.out, "polystyrene          2.9      0.4             1050                    83\n"));
  BOOST_TEST(has(table.out, "\n–: brittle, it breaks before it yields"));
  BOOST_TEST(has(table.out, "\n  yield_strength: none, it is brittle\n"));
  const auto list = nlohmann::json::parse(mariotte("materials --json").out);
  BOOST_TEST(list.size() >= 8u);
  for (const auto& [name, material] : list.items())
    for (const char* key : {"young", "poisson", "density"}) {
      BOOST_TEST(material[key]["value"].get<double>() > 0, name << " " << key);
      BOOST_TEST(material[key]["source"].get<std::string>() != "", name << " " << key);
    }
}

BOOST_FIXTURE_TEST_CASE(man_page_and_completions_name_every_command_and_option, Session) {
  const auto page = mariotte("man"), completion = mariotte("completion");
  for (const std::string command : {"run", "check", "sweep", "report", "law", "explain", "demo"}) {
    BOOST_TEST(has(page.out, ".SS \"mariotte " + command + "\""));
    BOOST_TEST(has(completion.out, "    " + command + ") words='"));
  }
  BOOST_TEST(has(page.out, "\\-\\-no\\-figures"));
  BOOST_TEST(has(page.out, "How many speeds (default: 21)\n"));
  BOOST_TEST(has(page.out, "Displacements of each mode (needs \\-\\-json)\n"));
  BOOST_TEST(has(page.out, ".SS \"mariotte help\""));
  BOOST_TEST(has(completion.out, "--no-figures"));
  if (shell("command -v man").code == 0)
    BOOST_TEST(shell("\"$mariotte\" man | man --warnings -l - >/dev/null").err == "");
  const auto completed = shell(
      "\"$mariotte\" completion > words.sh; bash -c '. ./words.sh; COMP_WORDS=(mariotte sw); COMP_CWORD=1; "
      "_mariotte; echo \"${COMPREPLY[@]}\"; COMP_WORDS=(mariotte sweep --thr); COMP_CWORD=2; _mariotte; echo "
      "\"${COMPREPLY[@]}\"'");
  BOOST_TEST(completed.out == "sweep\n--threads\n");
}

BOOST_FIXTURE_TEST_CASE(completions_offer_flows_codes_scenes_and_figures, Session) {
  const auto offered = [&](const std::string& line) {
    return shell(
               "PATH=\"${mariotte%/*}:$PATH\"; mariotte completion > words.sh; bash -c '. ./words.sh; "
               "COMP_WORDS=(mariotte " +
               line + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _mariotte; echo \"${COMPREPLY[@]}\"'")
        .out;
  };
  BOOST_TEST(offered("run --flow cvode-b") == "cvode-bdf-dense cvode-bdf-band cvode-bdf-klu\n");
  BOOST_TEST(offered("explain R00") == "R001 R002 R003 R004\n");
  BOOST_TEST(offered("hel") == "help\n");
  BOOST_TEST(offered("help sens") == "sensitivity\n");
  BOOST_TEST(offered("demo newton") == "newton_cradle_5\n");
  BOOST_TEST(offered("init y_") == "y_chain\n");
  BOOST_TEST(has(offered("reproduce acary-2"), "acary-2b"));
  BOOST_TEST(has(offered("reproduce kharaz-r"), "kharaz-restitution"));
}

BOOST_FIXTURE_TEST_CASE(other_shells_have_completions, Session) {
  const auto zsh = mariotte("completion zsh").out, fish = mariotte("completion fish").out;
  BOOST_TEST(zsh.starts_with("#compdef mariotte\n"));
  BOOST_TEST(has(zsh, "'run --flow') compadd -- auto pair"));
  BOOST_TEST(has(fish, "complete -c mariotte -n '__fish_seen_subcommand_from run' -l out -d "));
  BOOST_TEST(has(fish, "__fish_seen_subcommand_from explain' -f -a 'S001"));
  BOOST_TEST(mariotte("completion tcsh").code == 2);
  for (const std::string one : {"zsh", "fish"})
    if (shell("command -v " + one).code == 0)
      BOOST_TEST(shell("\"$mariotte\" completion " + one + " > words; " + one + " -n words").code == 0, one);
}

BOOST_FIXTURE_TEST_CASE(demo_lists_and_runs_its_examples, Session) {
  const auto list = mariotte("demo --list");
  BOOST_TEST(has(list.out, "newton_cradle_5"));
  BOOST_TEST(has(list.out, "Five steel balls\n"));
  BOOST_TEST(mariotte("demo").out.starts_with("Five steel balls\n"));
  BOOST_TEST(has(mariotte("demo microsphere").out, "Restitution"));
  const auto unknown = mariotte("demo triplett");
  BOOST_TEST(unknown.code == 2);
  BOOST_TEST(has(unknown.err, "did you mean 'triplet'?"));
  BOOST_TEST(has(mariotte("demo foo").err, "no example is called 'foo' (nearest: "));
  BOOST_TEST(has(mariotte("init cradle").err, "newton_cradle_5"));
}

BOOST_FIXTURE_TEST_CASE(init_writes_a_scene_to_start_from, Session) {
  BOOST_TEST(mariotte("init triplet").code == 0);
  BOOST_TEST(mariotte("run triplet.toml").code == 0);
  BOOST_TEST(mariotte("init triplet").code == 6);
  BOOST_TEST(mariotte("init triplet --force").code == 0);
  BOOST_TEST(mariotte("init y_chain mine.toml").code == 0);
  BOOST_TEST(support::content(folder / "mine.toml") == support::content(MARIOTTE_SCENES "/y_chain.toml"));
  BOOST_TEST(mariotte("init").code == 2);
  BOOST_TEST(has(mariotte("init triplet -").err, "'-' is no name of a file"));
}

BOOST_FIXTURE_TEST_CASE(init_says_the_command_that_a_scene_is_for, Session) {
  const auto sphere = mariotte("init sphere_fit mine.toml");
  BOOST_TEST(sphere.err == "mariotte: wrote mine.toml and mine.csv; next: mariotte fit mine.toml mine.csv\n");
  BOOST_TEST(support::content(folder / "mine.csv") == support::content(MARIOTTE_SCENES "/sphere_fit.csv"));
  BOOST_TEST(mariotte("fit mine.toml mine.csv").code == 0);
  support::fs::remove(folder / "mine.toml");
  BOOST_TEST(mariotte("init sphere_fit mine.toml").code == 6);
  BOOST_TEST(mariotte("init triplet_map").err ==
             "mariotte: wrote triplet_map.toml; next: mariotte sweep triplet_map.toml --out results\n");
  BOOST_TEST(has(mariotte("init triplet").err, "; next: mariotte run triplet.toml\n"));
}

BOOST_FIXTURE_TEST_CASE(init_does_not_write_measurements_over_their_scene, Session) {
  const auto init = mariotte("init sphere_fit mine.csv");
  BOOST_TEST(support::is_refused(init), init.err);
  BOOST_TEST(has(init.err, "FILE and its measurements are one file, mine.csv [U003]"));
  BOOST_TEST(!support::fs::exists(folder / "mine.csv"));
}

BOOST_FIXTURE_TEST_CASE(every_command_explains_itself_with_an_example, Session) {
  for (const char* command : {"", "run", "check", "sweep", "report", "law", "explain", "demo", "version"}) {
    const auto help = mariotte(std::string(command) + " --help");
    BOOST_TEST(help.code == 0);
    BOOST_TEST(has(help.out, "Example"));
    BOOST_TEST(has(help.out, std::string("mariotte ") + command));
    BOOST_TEST(help.err == "");
  }
}

BOOST_FIXTURE_TEST_CASE(help_is_a_command_as_well, Session) {
  BOOST_TEST(mariotte("help").out == mariotte("--help").out);
  BOOST_TEST(mariotte("help run").out == mariotte("run --help").out);
  BOOST_TEST(mariotte("help study").out == mariotte("study --help").out);
  BOOST_TEST(mariotte("help run").code == 0);
  const auto unknown = mariotte("help sensitivty");
  BOOST_TEST(unknown.code == 2);
  BOOST_TEST(has(unknown.err, "did you mean 'sensitivity'?"));
}

BOOST_FIXTURE_TEST_CASE(version_names_the_version, Session) {
  BOOST_TEST(mariotte("version").out.starts_with("mariotte " MARIOTTE_VERSION "\n"));
  BOOST_TEST(mariotte("--version").out == "mariotte " MARIOTTE_VERSION "\n");
}

BOOST_FIXTURE_TEST_CASE(study_starts_the_program_of_that_study, Session) {
  for (const std::string study : {"stiffness", "work-precision"}) {
    const auto help = mariotte("study " + study + " --help");
    BOOST_TEST(help.code == 0);
    BOOST_TEST(has(help.out, "--csv"));
  }
  BOOST_TEST(mariotte("study work-precision --problem P0").code == 2);
  BOOST_TEST(mariotte("study").code == 2);
}
