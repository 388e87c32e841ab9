#define BOOST_TEST_MODULE command_check
#include <boost/test/unit_test.hpp>

#include "session.hpp"

using support::has;
using support::Session;
using Json = nlohmann::json;

BOOST_FIXTURE_TEST_CASE(check_shows_the_scene_and_runs_nothing, Session) {
  const auto check = mariotte("check three.toml");
  BOOST_TEST(check.code == 0);
  BOOST_TEST(has(check.out, "3 balls"));
  BOOST_TEST(!has(check.out, "separated"));
  BOOST_TEST(entries() == 1);
}

BOOST_FIXTURE_TEST_CASE(check_resolves_units_and_overrides_to_si, Session) {
  const auto check = mariotte("check three.toml --json --set 'chain.velocity[0]=2 mm/s'");
  const auto scene = Json::parse(check.out);
  BOOST_TEST(scene["chain"]["velocity"] == Json::array({0.002, 0.0, 0.0}));
  BOOST_TEST(scene["chain"]["contact"][1]["law"] == "hertz");
}

BOOST_FIXTURE_TEST_CASE(a_malformed_scene_gives_code_3_and_writes_nothing, Session) {
  write("bad.toml", "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nstiffnes = 1\n");
  for (const char* arguments : {"check bad.toml", "run bad.toml --out results", "run bad.toml --json"}) {
    const auto run = mariotte(arguments);
    BOOST_TEST(run.code == 3);
    BOOST_TEST(run.out == "");
    BOOST_TEST(run.err.starts_with("mariotte: error: bad.toml:4:1: "));
  }
  BOOST_TEST(entries() == 2);
}

BOOST_FIXTURE_TEST_CASE(check_tells_what_a_sweep_would_do_or_why_it_cannot, Session) {
  const std::string sweep = std::string(support::three_balls) + "[[sweep]]\nkey = 'chain.velocity[2]'\n";
  write("good.toml", sweep + "values = [0, '-1 m/s']\n");
  write("bad.toml", sweep + "values = [0, '1 kg']\n");
  BOOST_TEST(has(mariotte("check good.toml").out, "2 points, varying chain.velocity[2]"));
  const auto bad = mariotte("check bad.toml");
  BOOST_TEST(bad.code == 3);
  BOOST_TEST(bad.err.starts_with("mariotte: error: bad.toml:11:14: "));
}

BOOST_FIXTURE_TEST_CASE(check_refuses_columns_that_no_run_could_give, Session) {
  const std::string sweep = "[[sweep]]\nkey = 'chain.mass[0]'\nvalues = [1, 2]\n";
  for (const auto& end : {std::string(), sweep}) {
    const auto check = [&](const std::string& columns) {
      write("mine.toml", "columns = [" + columns + "]\n" + support::three_balls + end);
      return mariotte("check mine.toml");
    };
    const auto bad = check("'icr[0]', 'final.velocty[0]'");
    BOOST_TEST(bad.code == 3);
    BOOST_TEST(has(bad.err,
                   "mine.toml:1:22: columns[1]: no result has 'final.velocty[0]' (did you mean "
                   "'final.velocity[0]'?) [W004]"),
               bad.err);
    BOOST_TEST(check("'foo'").code == 3);
    BOOST_TEST(has(check("'a = icr[0]', 'a = icr[0]'").err, "mine.toml:1:26: columns[1]: there are two"));
    BOOST_TEST(check("'icr[*]', 'events[*].time', 'contacts[*].periods[*][0]', 'a = icr[0] / 2'").code == 0);
  }
}

BOOST_FIXTURE_TEST_CASE(a_scene_that_cannot_be_read_gives_code_6, Session) {
  const auto run = mariotte("run missing.toml");
  BOOST_TEST(run.code == 6);
  BOOST_TEST(has(run.err, "missing.toml"));
  BOOST_TEST(mariotte("run .").code == 6);
}

BOOST_FIXTURE_TEST_CASE(a_command_line_without_sense_gives_code_2, Session) {
  for (const char* arguments :
       {"", "run", "jump", "run three.toml --bogus", "run three.toml --accuracy 0",
        "run three.toml --accuracy 1", "run three.toml --accuracy nan", "run three.toml --accuracy -1",
        "run three.toml --flow nonsense", "run three.toml -q -v", "check three.toml --out results"})
    BOOST_TEST(support::is_refused(mariotte(arguments)), arguments);
}

BOOST_FIXTURE_TEST_CASE(every_error_of_a_scene_is_told_at_once, Session) {
  write("bad.toml", R"(titel = "wrong"
[chain]
mass = [1, -1]
velocity = ["1 m", 0]
gap = -1
law = "hertz"
stiffness = 1
[run]
accuracy = 2
)");
  const auto check = mariotte("check bad.toml");
  BOOST_TEST(check.code == 3);
  for (const char* error :
       {"bad.toml:1:1: unknown key 'titel' (did you mean 'title'?) [S010]",
        "bad.toml:3:12: chain.mass[1]: must be positive",
        "bad.toml:4:13: chain.velocity[0]: ", "bad.toml:5:7: chain.gap: must not be negative",
        "bad.toml:9:12: run.accuracy: must be between 0 and 1"})
    BOOST_TEST(has(check.err, std::string("mariotte: error: ") + error), error << " in " << check.err);
}

BOOST_FIXTURE_TEST_CASE(check_prints_the_restitution_of_damped_contacts, Session) {
  const auto check = mariotte("check " MARIOTTE_SCENES "/measured_restitution.toml --set chain.at=2");
  BOOST_TEST(has(check.out, "contact  e at 0.2 m/s  e at 2 m/s  e at 20 m/s\n"));
  BOOST_TEST(has(check.out, "  0.95000000  "));
  BOOST_TEST(!has(mariotte("check three.toml").out, "e at"));

  write("sphere.toml",
        "[body]\nshape = \"sphere\"\nradius = 1e-3\ndensity = 1000\n[surface]\nstiffness = \"1 GPa\"\n"
        "restitution = 0.8\n[incidence]\nnormal_speed = 3\n");
  const auto sphere = mariotte("check sphere.toml").out;
  BOOST_TEST(has(
      sphere,
      "Restitution of each tip alone, by the damping above\n  tip  e at 0.3 m/s  e at 3 m/s  e at 30 m/s\n"));
  BOOST_TEST(has(sphere, "  0.80000000  "));

  write("bodies.toml",
        "[bodies]\ndimension = 2\nradius = 0.01\nmass = 1\nlaw = \"viscoelastic\"\nstiffness = 1e9\n"
        "restitution = 0.7\n[[bodies.body]]\nposition = [0, 0.01]\nvelocity = [0, -2]\n"
        "[[bodies.plane]]\nnormal = [0, 1]\n");
  const auto bodies = mariotte("check bodies.toml").out;
  BOOST_TEST(has(bodies, "contact  e at 0.2 m/s  e at 2 m/s  e at 20 m/s\n"));
  BOOST_TEST(has(bodies, "  0.70000000  "));
}

BOOST_FIXTURE_TEST_CASE(check_names_a_damped_law_as_scenes_do, Session) {
  const auto shown = [&](const std::string& law) {
    return mariotte("check three.toml --set 'chain.contact=[{stiffness = 1, " + law + "}]'").out;
  };
  BOOST_TEST(has(shown("law = \"kelvin-voigt\", restitution = 0.9"), "viscoelastic (kelvin-voigt)"));
  BOOST_TEST(has(shown("law = \"kelvin-voigt\", damping = 1, separation = \"indentation\""),
                 "viscoelastic (kelvin-voigt)"));
  BOOST_TEST(has(shown("law = \"viscoelastic\", damping = 1"), "viscoelastic (kuwabara-kono)"));
  BOOST_TEST(has(shown("law = \"viscoelastic\", damping = 1, exponent = 2"), "  viscoelastic  "));
  BOOST_TEST(has(shown("law = \"hertz\""), "  hertz  "));
  const auto bodies =
      mariotte("check " MARIOTTE_SCENES "/rocking_with_friction.toml --set bodies.damping=4000");
  BOOST_TEST(has(bodies.out, " viscoelastic ("), bodies.out);
}

BOOST_FIXTURE_TEST_CASE(where_a_damped_contact_ends_is_told, Session) {
  const std::string uncut =
      " --set 'chain.contact=[{law = \"kelvin-voigt\", stiffness = 1, damping = 0.5, "
      "separation = \"indentation\"}, {law = \"hertz\", stiffness = 1}]'";
  BOOST_TEST(
      has(mariotte("check three.toml" + uncut).out, "  0.5           1        0  separation indentation\n"));
  const auto contacts = Json::parse(mariotte("run three.toml --json" + uncut).out)["scene"]["contact"];
  BOOST_TEST(contacts[0].value("separation", "") == "indentation");
  BOOST_TEST(!contacts[1].contains("separation"));
  const auto bodies = mariotte("check " MARIOTTE_SCENES
                               "/rocking_with_friction.toml --set bodies.damping=4000 "
                               "--set 'bodies.separation=\"indentation\"'");
  BOOST_TEST(has(bodies.out, "separation indentation\n"), bodies.out);
}

BOOST_FIXTURE_TEST_CASE(a_key_in_the_wrong_table_is_told_where_it_belongs, Session) {
  BOOST_TEST(has(mariotte("check three.toml --set chain.accuracy=1e-6").err, "(it belongs to [run])"));
  BOOST_TEST(has(mariotte("check three.toml --set chain.friction=0.1").err,
                 "(friction acts between [bodies], or on a [body]: surface.friction)"));
  BOOST_TEST(has(mariotte("check three.toml --set chain.until=1").err, "(it belongs to [run])"));
  BOOST_TEST(has(mariotte("check three.toml --set run.law=hertz").err,
                 "(it belongs to the contacts: [chain], [network] or [bodies])"));
  BOOST_TEST(has(mariotte("check three.toml --set run.radius=1").err,
                 "(it belongs to what has that size: [chain], [network], [body] or [bodies])"));
  BOOST_TEST(has(mariotte("check three.toml --set chain.young=1e9").err, "(it belongs to a material: "));
  BOOST_TEST(
      has(mariotte("check three.toml --set chain.impacts=2").err, "(it belongs to [run], beside a [body])"));
  BOOST_TEST(
      has(mariotte("check three.toml --set chain.columns=icr").err, "(it belongs above the first table)"));
  BOOST_TEST(has(mariotte("check three.toml --set run.gap=0").err, "(it belongs to [chain]: gap = "));
  for (const char* text :
       {"[chain]\nangles = [0, 0, 0]\n", "[body]\nangles = [0, 0, 0]\n[surface]\n[incidence]\n"}) {
    write("angles.toml", text);
    BOOST_TEST(has(mariotte("check angles.toml").err, "(it belongs to [incidence], beside a [body])"));
  }
}

BOOST_FIXTURE_TEST_CASE(a_wrong_word_is_told_the_choices, Session) {
  BOOST_TEST(has(mariotte("check three.toml --set 'chain.contact[0].law=\"x\"'").err,
                 "unknown law 'x' (one of: linear, hertz, viscoelastic, "));
  BOOST_TEST(has(mariotte("check three.toml --set 'chain.wall=\"letf\"'").err,
                 "unknown wall 'letf' (did you mean 'left'?) (one of: left, right, both)"));
}

BOOST_FIXTURE_TEST_CASE(one_of_a_kind_is_no_plural, Session) {
  write("one.toml", std::string(support::three_balls) + "[[sweep]]\nkey = 'chain.mass[0]'\nvalues = [2]\n");
  BOOST_TEST(has(mariotte("check one.toml").out, "  1 point, varying chain.mass[0]\n"));
  const std::string sweep = "sweep one.toml --out out --no-figures --threads 1";
  const auto first = mariotte(sweep + " -v");
  BOOST_TEST(first.out.starts_with("1 point, all with a result"));
  BOOST_TEST(has(first.err, "1 point in "));
  BOOST_TEST(has(first.err, " on 1 thread;"));
  BOOST_TEST(has(mariotte(sweep).err, "1 of 1 point was done before"));
  BOOST_TEST(mariotte("report out").code == 0);
  BOOST_TEST(
      has(support::content(folder / "out/report.html"), "1 point varies chain.mass[0]. It has a result."));
  BOOST_TEST(has(mariotte("sensitivity three.toml --to 'mass[0]'").out, "slopes by 1 parameter\n"));
}

BOOST_FIXTURE_TEST_CASE(a_missing_file_and_a_folder_are_called_so, Session) {
  BOOST_TEST(has(mariotte("run nowhere.toml").err, "nowhere.toml: no such file [F001]"));
  BOOST_TEST(has(mariotte("run .").err, ".: is a folder [F001]"));
  write("table.toml",
        "[chain]\nmass = [1, 1]\nvelocity = [1, 0]\nlaw = 'tabulated'\ntable = 'nowhere.csv'\n");
  BOOST_TEST(
      has(mariotte("run table.toml").err, "table.toml:5:9: chain.table: nowhere.csv: no such file [F001]"));
}

BOOST_FIXTURE_TEST_CASE(an_angle_in_degrees_without_a_unit_is_told_so, Session) {
  const auto check = mariotte("check " MARIOTTE_SCENES "/microrod.toml --set 'incidence.angles=[0, 42, 0]'");
  BOOST_TEST(check.code == 3);
  BOOST_TEST(has(check.err, "(a bare number is in radians; \"42 deg\" is in degrees)"));
  const auto warned = mariotte("check " MARIOTTE_SCENES "/microrod.toml --set 'incidence.angles=[0, 7, 0]'");
  BOOST_TEST(has(warned.err, "incidence.angles: more than a full turn (a bare number is in radians"));
}

BOOST_FIXTURE_TEST_CASE(a_misspelt_word_is_told_what_it_is_like, Session) {
  const auto command = mariotte("rnu three.toml");
  BOOST_TEST(command.code == 2);
  BOOST_TEST(has(command.err, "unknown command 'rnu' (did you mean 'run'?)"));
  BOOST_TEST(has(mariotte("frob three.toml").err, "unknown command 'frob' (nearest: "));
  BOOST_TEST(has(mariotte("--frob").err, "unknown option '--frob' (nearest: "));
  BOOST_TEST(has(mariotte("run three.toml --frob").err, "--frob"));
  BOOST_TEST(has(mariotte("run three.toml --acuracy 1e-6").err, "did you mean '--accuracy'?"));
  BOOST_TEST(has(mariotte("study stifness").err, "did you mean 'stiffness'?"));
}

BOOST_FIXTURE_TEST_CASE(numbers_of_options_are_finite, Session) {
  const std::string scenes = MARIOTTE_SCENES "/";
  for (const auto& line : {"capture " + scenes + "captured_sphere.toml --tolerance nan",
                           "fit " + scenes + "sphere_fit.toml " + scenes + "sphere_fit.csv --confidence nan",
                           std::string("run three.toml --trace w.csv --every inf"),
                           "restitution " + scenes + "steel_pair.toml --from 1 --to inf"}) {
    const auto run = mariotte(line);
    BOOST_TEST(support::is_refused(run), line);
    BOOST_TEST(has(run.err, "finite"), run.err);
    BOOST_TEST(has(run.err, "[U003]"), run.err);
  }
}

BOOST_FIXTURE_TEST_CASE(a_number_out_of_its_range_is_told_the_range, Session) {
  const auto run = mariotte("capture " MARIOTTE_SCENES "/microsphere.toml --tolerance 1e-16");
  BOOST_TEST(run.code == 2);
  BOOST_TEST(has(run.err, "--tolerance: 1e-16 is not in the range 1e-15 to 0.5"), run.err);
}

BOOST_FIXTURE_TEST_CASE(options_that_would_have_no_effect_are_refused, Session) {
  const std::string scenes = MARIOTTE_SCENES "/";
  const std::pair<std::string, std::string> cases[] = {
      {"run three.toml --force", "--force requires --out or --trace"},
      {"sensitivity three.toml --force", "--force requires --out"},
      {"fit " + scenes + "sphere_fit.toml " + scenes + "sphere_fit.csv --force", "--force requires --out"},
      {"modes " + scenes + "pressed_row.toml --shapes", "--shapes requires --json"},
      {"study icr-table --force", "--force requires --out"}};
  for (const auto& [line, why] : cases) {
    const auto run = mariotte(line);
    BOOST_TEST(run.code == 2, line);
    BOOST_TEST(run.out == "", line);
    BOOST_TEST(has(run.err, why), run.err);
    BOOST_TEST(has(run.err, "[U003]"), run.err);
  }
}

BOOST_FIXTURE_TEST_CASE(speeds_of_a_restitution_have_units, Session) {
  const std::string pair = "restitution " MARIOTTE_SCENES "/steel_pair.toml --count 2 ";
  const auto with_units = mariotte(pair + "--from '10 cm/s' --to '1 m/s'");
  BOOST_TEST(with_units.code == 0);
  BOOST_TEST(with_units.out == mariotte(pair + "--from 0.1 --to 1").out);
  BOOST_TEST(
      has(mariotte(pair + "--from 0 --to 1").err, "--from: must be positive and finite, not 0 [U003]"));
  BOOST_TEST(has(mariotte(pair + "--from 1 --to '1 m'").err, "--to: expected "));
}
