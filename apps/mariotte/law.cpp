#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "law_problem.hpp"
#include "mariotte/impact/fault.hpp"
#include "mariotte/report/table/law_report.hpp"
#include "run_notes.hpp"

namespace mariotte::command {
namespace {

int show(const LawChoice& choice, const scene::Scene& scene, const report::FrictionLawReport& report) {
  print(choice.json ? report::text(report::json(report)) : report::table(report));
  return tell_run(scene::simulate(scene), scene, choice.scene.quiet);
}

int apply(const LawChoice& choice, const scene::Scene& scene) {
  auto problem = law_problem(choice, scene);
  tell_warnings(problem.warnings, choice.scene.quiet);
  if (const auto code = tell_ending(problem.simulation_ended, problem.message, scene); code != ExitCode::ok)
    return code;
  auto& report = problem.report;
  report.outcome = impact::multiple_impact(report.before, report.parameters);
  if (problem.from_table)
    report.velocity_error = impact::multiple_impact(report.before, *problem.from_table).velocity_error;
  if (choice.rivals && !problem.rivals.distributes)
    tell_warnings({"liu-zhao-brogliato is left out: it knows contacts of k δ^n alone"}, choice.scene.quiet);
  if (choice.rivals) report.rivals = impact::rival_outcomes(report.before, problem.rivals);
  print(choice.json ? report::text(report::json(report)) : report::table(report));
  const auto why = reason(report.outcome);
  if (why.empty()) return ExitCode::ok;
  error(why, fault::inadmissible);
  return ExitCode::check_failed;
}

int law(const LawChoice& choice) {
  try {
    auto scene = scene_of(choice);
    if (const auto* bodies = std::get_if<model::Bodies>(&scene.model))
      return show(choice, scene, friction_laws(choice, scene, *bodies));
    scene.until = false;  // the law is that of a whole impact
    return apply(choice, scene);
  } catch (const impact::OutsideTable& problem) {
    error(problem.what(), fault::outside_table);
    return ExitCode::check_failed;
  } catch (const InvalidParameter& problem) {
    if (problem.fault.code == fault::no_single_contact.code) throw;
    if (!choice.scene.path.empty()) throw InvalidParameter(problem.what(), fault::law_parameters);
    throw UsageError(problem.what(), fault::law_parameters);
  }
}

constexpr const char* law_examples = R"(Examples:
  mariotte law --mass 1,1,1 --velocity 1,0,0 --icr 1.5 --energy-ratio 0.9
  mariotte law --mass "100 g,100 g" --velocity "1 m/s,0" --direction 1 --energy-ratio 0.5 --frame mass-centre
  mariotte law cradle.toml                       ratios and e from a simulation of the scene
  mariotte law cradle.toml --energy-ratio 0.9    ratios from the simulation, e as given
  mariotte law cradle.toml --rivals              beside Newton, Poisson, Moreau and others
  mariotte law thrown_rod.toml                   [bodies]: laws with friction beside the first impact
  mariotte law triplet_law.toml --json           a scene with [law]
  mariotte law --table kappa.csv --at kappa=2 --mass 1,1,1 --velocity 1,0,0

An outcome that is not admissible, or no real one, or a place outside the table: exit code 1, with the reason.
)";

OptionList declare(LawChoice& choice) {
  const char* list = "X,X,…";
  return joined(
      {{{"SCENE", &choice.scene.path, "Scene with [law], or a [chain], [network] or [bodies] to simulate"}},
       override_options(choice.scene),
       {{"--mass",
         &choice.mass,
         "Masses from left to right [kg]; inf is a wall",
         {.value = list, .between_commas = true, .needs = {"--velocity"}}},
        {"--velocity",
         &choice.velocity,
         "Velocities before the impact [m/s]",
         {.value = list, .between_commas = true, .needs = {"--mass"}}},
        {"--icr",
         &choice.icr,
         "Impulse correlation ratios p_j/p_{j+1}, one less than contacts",
         {.value = list, .between_commas = true}},
        {"--direction",
         &choice.direction,
         "Impulses up to their size, one per contact",
         {.value = list, .between_commas = true, .excludes = {"--icr"}}},
        {"--energy-ratio", &choice.energy_ratio, "e = T+/T-, kinetic energies"},
        {"--frame", &choice.frame, "Frame of e: given, or mass-centre", {.value = "FRAME"}},
        {"--table",
         &choice.table,
         "Take direction and e from a file of icr_table",
         {.value = "FILE", .excludes = {"--icr", "--direction", "--energy-ratio", "--frame"}}},
        {"--at",
         &choice.at,
         "Where in the table",
         {.value = "NAME=VALUE,…", .between_commas = true, .needs = {"--table"}}},
        {"--rivals", &choice.rivals,
         "Show what other impact laws answer, too; without a scene contacts are equal Hertz ones"},
        {"--restitution",
         &choice.restitution,
         "Coefficient of restitution of these; default 1, of [bodies] as simulated",
         {.needs = {"--rivals"}}},
        {"--json", &choice.json, "One JSON object on stdout instead of the table"}}});
}

}  // namespace

Command law_command() {
  auto choice = std::make_shared<LawChoice>();
  return {.name = "law",
          .about = "Apply impact laws: velocities from ratios and energy, or with friction",
          .footer = law_examples,
          .options = declare(*choice),
          .act = [choice] { return law(*choice); }};
}

}  // namespace mariotte::command
