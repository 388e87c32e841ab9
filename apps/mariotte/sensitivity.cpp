#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/tornado.hpp"
#include "mariotte/report/json/sensitivity_json.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/scene/result_key.hpp"
#include "mariotte/scene/simulate.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"
#include "run_of_slopes.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {
namespace {

struct Slopes {
  SceneChoice scene;
  std::vector<std::string> of, to;
  bool json = false;
  bool csv = false;
  std::string out;
  bool force = false;
};

/// The usual result of a run with what it takes to repeat it, and the slopes.
report::Json json(const impact::Sensitivity& slopes, const scene::Scene& scene, const SceneChoice& choice) {
  auto result =
      std::visit([&](const auto& impact) { return report::json(impact, scene); }, scene::simulate(scene));
  result["provenance"]["scene"] = choice.path;
  result["provenance"]["overrides"] = choice.set;
  report::add_slopes(slopes, result);
  return result;
}

std::vector<std::string> file_names() {
  auto names = report::tornado_figures();
  names.insert(names.end(), {"slopes.csv", "result.json", "bars.csv", "plot.gp"});
  return names;
}

/// Bars count balls and contacts as results do.
impact::Sensitivity numbered(impact::Sensitivity slopes, const scene::Document& document) {
  for (auto& parameter : slopes.parameter) parameter.name = scene::key_in_results(document, parameter.name);
  return slopes;
}

/// Slopes, what they are of, and their picture; a note if there is none.
void write_folder(const Slopes& options, const impact::Sensitivity& slopes, const scene::Scene& scene,
                  const scene::Document& document) {
  const std::filesystem::path folder = options.out;
  report::write_file(folder / "slopes.csv", report::csv(slopes));
  report::write_file(folder / "result.json", report::text(json(slopes, scene, options.scene)));
  const auto script = report::tornado_script(numbered(slopes, document), scene.title);
  if (script.empty()) return note("no picture: no relative slope is known that is more than rounding");
  report::write_file(folder / "bars.csv", report::tornado_csv(slopes));
  report::write_file(folder / "plot.gp", script);
  if (const auto problem = report::draw(folder, report::tornado_figures()); !problem.empty())
    note(problem + "; data and script are in " + (folder / "plot.gp").string());
}

int sensitivity(const Slopes& options) try {
  if (!options.out.empty()) report::prepare_folder(options.out, file_names(), options.force);
  const auto document = open(options.scene);
  const auto scene = resolve(options.scene, document);
  auto slopes = study::sensitivity(document, scene, options.to, options.of);
  study::keep_asked_for(slopes.outcome, options.of);
  const auto of_run = take_ending(slopes, scene_of(slopes.outcome, document, scene));
  if (options.json)
    print(report::text(json(slopes, scene, options.scene)));
  else
    print(options.csv ? report::csv(slopes) : report::table(slopes, scene.title));
  if (!options.out.empty()) write_folder(options, slopes, scene, document);
  tell_warnings(of_run, options.scene.quiet);
  return tell_ending(slopes.ending, slopes.message, scene);
} catch (const study::UnknownOutcome& problem) {
  throw UsageError(std::string("--of ") + problem.what());
}

constexpr const char* sensitivity_examples = R"(Examples:
  mariotte sensitivity triplet.toml
  mariotte sensitivity triplet.toml --of icr --to contact --to gap
  mariotte sensitivity triplet.toml --to chain.radius --to chain.material.young --csv
  mariotte sensitivity microsphere.toml --json
  mariotte sensitivity triplet.toml --of velocity --out slopes

Slopes are exact through every event, not differences of runs: doc/sensitivity.md says how. Without --to they
are by every mass, velocity, gap and number of a law; of a body by what its scene gives. What made the slopes,
scene and version, is in the JSON; --csv alone is the table and nothing else.
)";

}  // namespace

Command sensitivity_command() {
  auto options = std::make_shared<Slopes>();
  return {.name = "sensitivity",
          .about = "Tell how the outcome of a scene changes with its parameters",
          .footer = sensitivity_examples,
          .options = joined(
              {scene_options(options->scene),
               run_options(options->scene),
               {{"--of",
                 &options->of,
                 "Outcome, such as velocity, impulse[0], icr, time or, of a microbody, "
                 "capture_velocity; may be repeated",
                 {.value = "QUANTITY", .takes_one = true}},
                {"--to",
                 &options->to,
                 "Parameter, such as mass[0], contact[1].stiffness or a key of the scene; may be "
                 "repeated",
                 {.value = "KEY", .takes_one = true}},
                {"--json", &options->json, "One JSON object on stdout"},
                {"--csv", &options->csv, "A table for other programs", {.excludes = {"--json"}}},
                {"--out",
                 &options->out,
                 "Write slopes.csv, result.json and a picture of relative slopes into this folder",
                 {.value = "DIR"}},
                {"--force", &options->force, "Overwrite files of an earlier call", {.needs = {"--out"}}}}}),
          .act = [options] { return sensitivity(*options); }};
}

}  // namespace mariotte::command
