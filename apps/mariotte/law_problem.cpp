#include "law_problem.hpp"

#include <algorithm>

#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "law_table.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/report/warnings.hpp"
#include "mariotte/scene/judge.hpp"

namespace mariotte::command {
namespace {

using Texts = std::vector<std::string>;

std::vector<double> quantities(const std::string& option, const Texts& texts, const Dimension& dimension) {
  std::vector<double> values;
  for (const auto& text : texts) values.push_back(quantity(option, text, dimension));
  return values;
}

impact::EnergyFrame frame(const std::string& text) {
  for (const auto frame : {impact::EnergyFrame::given, impact::EnergyFrame::mass_centre})
    if (text == report::frame_name(frame)) return frame;
  throw UsageError("--frame: must be given or mass-centre, not " + text);
}

/// What the flags say beside [law].
void add_flags(scene::Law& law, const LawChoice& choice) {
  if (!choice.mass.empty()) {
    law.mass = quantities("--mass", choice.mass, dimension::mass);
    law.velocity = quantities("--velocity", choice.velocity, dimension::velocity);
    if (law.velocity.size() != law.mass.size())
      throw UsageError("--velocity: needs one value per mass (" + std::to_string(law.mass.size()) +
                       "), got " + std::to_string(law.velocity.size()));
  }
  if (!choice.direction.empty()) law.direction = quantities("--direction", choice.direction, dimension::none);
  if (!choice.icr.empty())
    law.direction = impact::direction_of_ratios(quantities("--icr", choice.icr, dimension::none));
  if (!choice.energy_ratio.empty())
    law.energy_ratio = quantity("--energy-ratio", choice.energy_ratio, dimension::none);
  if (!choice.frame.empty()) law.frame = frame(choice.frame);
}

/// A ratio above 1 may be meant: contacts that are pressed beforehand give energy.
void warn_of_gain(const LawChoice& choice, const scene::Law& law) {
  if (choice.scene.quiet || !law.energy_ratio || !(*law.energy_ratio > 1)) return;
  warning(std::string(choice.energy_ratio.empty() ? "law.energy_ratio" : "--energy-ratio") +
          ": above 1 the impact gains energy, which only contacts that are pressed before it can give");
}

/// What a chain or the flags have collide; nothing of other models.
Balls balls(const scene::Law& law, const scene::Scene& scene) {
  if (!law.mass.empty()) return {law.mass, law.velocity};
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  return chain ? Balls{chain->mass, chain->velocity} : Balls{};
}

void take_from_table(LawProblem& problem, scene::Law& law, const LawChoice& choice,
                     const scene::Scene& scene) {
  problem.from_table = look_up(choice.table, choice.at, balls(law, scene));
  const auto& parameters = problem.from_table->parameters;
  law.direction = parameters.direction;
  law.energy_ratio = parameters.energy_ratio;
  law.frame = parameters.frame;
}

/// Impulses and energies of a simulated impact stand in for what is not given.
template <class Model>
void complete_by_simulation(LawProblem& problem, scene::Law& law, const Model& model,
                            const scene::Scene& scene) {
  auto impact = impact::simulate(model, scene.run);
  judge(impact, scene);
  problem.simulation_ended = impact.ending;
  problem.message = impact.message;
  problem.warnings = report::warnings(impact, scene.run.flow);
  const auto found = impact::parameters_of(impact, law.frame);
  if (law.direction.empty()) law.direction = found.direction;
  if (!law.energy_ratio) law.energy_ratio = found.energy_ratio;
  problem.report.parameters.slow = found.slow;
  problem.report.simulated = impact.velocity;
}

/// Stiffnesses and exponents for the rival that needs them, if all contacts have such.
void add_contacts(impact::RivalParameters& parameters, const std::vector<contact::Law>& laws) {
  const auto is_power_law = [](const contact::Law& law) { return contact::power_law(law) != nullptr; };
  parameters.distributes = std::all_of(laws.begin(), laws.end(), is_power_law);
  if (!parameters.distributes) return;
  for (const auto& law : laws) {
    parameters.stiffness.push_back(contact::stiffness(law));
    parameters.exponent.push_back(contact::exponent(law));
  }
}

/// Everything that the scene's model says: what collides, its contacts and, where the law is not complete,
/// its simulation.
template <class Model>
void take_from_contacts(LawProblem& problem, scene::Law& law, const Model& model, const scene::Scene& scene) {
  if (law.direction.empty() || !law.energy_ratio) complete_by_simulation(problem, law, model, scene);
  add_contacts(problem.rivals, model.law);
}

void take_from(LawProblem& problem, scene::Law& law, const model::Chain& chain, const scene::Scene& scene) {
  take_from_contacts(problem, law, chain, scene);
  problem.report.before = impact::chain_configuration(chain.mass, chain.velocity);
}

void take_from(LawProblem& problem, scene::Law& law, const model::Network& network,
               const scene::Scene& scene) {
  take_from_contacts(problem, law, network, scene);
  problem.report.before = impact::configuration_of(network);
  problem.report.moving = impact::moving(network);
  problem.report.velocity_unit = impact::velocity_unit(network);
}

/// The reader refuses a [body] for this purpose, and [bodies] have laws of their own.
void take_from(LawProblem&, scene::Law&, const model::Microbody&, const scene::Scene&) {
  throw UsageError("the multiple-impact law needs a [chain] or [network]", fault::law_incomplete);
}

void take_from(LawProblem&, scene::Law&, const model::Bodies&, const scene::Scene&) {
  throw UsageError("the multiple-impact law needs a [chain] or [network]", fault::law_incomplete);
}

void take_from(LawProblem&, scene::Law&, const scene::LawAlone&, const scene::Scene&) {
  throw UsageError("give a scene, or --mass and --velocity", fault::law_incomplete);
}

std::optional<double> restitution(const LawChoice& choice) {
  if (choice.restitution.empty()) return {};
  const double value = quantity("--restitution", choice.restitution, dimension::none);
  if (!(value >= 0 && value <= 1))
    throw InvalidParameter("--restitution: must be between 0 and 1, not " + choice.restitution);
  return value;
}

/// Of what the multiple-impact law is told.
void expect_no_parameters(const LawChoice& choice) {
  const bool parameters = !(choice.mass.empty() && choice.icr.empty() && choice.direction.empty());
  const bool energy = !(choice.energy_ratio.empty() && choice.frame.empty() && choice.table.empty());
  if (parameters || energy)
    throw UsageError(
        "of [bodies] laws take --restitution alone; other numbers are for a [chain] or [network]",
        fault::law_parameters);
}

}  // namespace

scene::Scene scene_of(const LawChoice& choice) {
  return choice.scene.path.empty() ? scene::Scene{} : read(choice.scene, scene::Purpose::law);
}

report::FrictionLawReport friction_laws(const LawChoice& choice, const scene::Scene& scene,
                                        const model::Bodies& bodies) {
  expect_no_parameters(choice);
  return {scene.title, impact::first_impact(bodies, scene.run, restitution(choice)), scene.sha256};
}

LawProblem law_problem(const LawChoice& choice, const scene::Scene& scene) {
  auto law = scene.law.value_or(scene::Law{});
  add_flags(law, choice);
  warn_of_gain(choice, law);
  LawProblem problem;
  problem.report.title = scene.title;
  problem.report.scene_sha256 = scene.sha256;
  if (!choice.table.empty()) take_from_table(problem, law, choice, scene);
  problem.rivals.restitution = restitution(choice).value_or(1);
  const bool own = !law.mass.empty();
  if (!own) std::visit([&](const auto& model) { take_from(problem, law, model, scene); }, scene.model);
  if (law.direction.empty()) throw UsageError("give --icr, --direction or --table", fault::law_incomplete);
  if (!law.energy_ratio) throw UsageError("give --energy-ratio", fault::law_incomplete);
  if (own) problem.report.before = impact::chain_configuration(law.mass, law.velocity);
  problem.report.parameters.direction = law.direction;
  problem.report.parameters.energy_ratio = *law.energy_ratio;
  problem.report.parameters.frame = law.frame;
  problem.rivals.direction = law.direction;
  problem.report.restitution = problem.rivals.restitution;
  return problem;
}

}  // namespace mariotte::command
