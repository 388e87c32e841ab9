#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/json/propagation_json.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"
#include "run_of_slopes.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {
namespace {

struct Uncertain {
  SceneChoice scene;
  std::vector<std::string> of;
  study::Samples samples;
  bool json = false;
};

int uncertainty(const Uncertain& options) try {
  auto document = open(options.scene);
  const auto inputs = study::take_uncertain_inputs(document);
  if (inputs.empty())
    throw UsageError(
        options.scene.path +
        ": no number of the scene has a deviation, as in \"10 mm ± 1 um\" or --set 'KEY=2 ± 1 %'");
  const auto scene = resolve(options.scene, document);
  auto found = study::propagate(document, scene, inputs, options.samples, options.of);
  const auto of_run = take_ending(found, scene_of(found.outcomes, document, scene));
  print(options.json ? report::text(report::json(found)) : report::table(found, scene.title));
  tell_warnings(of_run, options.scene.quiet);
  return tell_ending(found.ending, found.message, scene);
} catch (const study::UnknownOutcome& problem) {
  throw UsageError(std::string("--of ") + problem.what());
}

constexpr const char* uncertainty_examples = R"(Examples:
  mariotte uncertainty triplet.toml --set 'chain.radius=10 mm ± 1 um'
  mariotte uncertainty triplet.toml --set 'chain.velocity[0]=1 +- 1 %' --samples 1000 --seed 7
  mariotte uncertainty microsphere.toml --set 'body.radius=2.45 um +- 2 %' --of capture_velocity
  mariotte uncertainty measured.toml --json

What stands behind ± (or +-) is a standard deviation, in units or in per cent. Deviations of outcomes are of
first order, by the exact slopes of `mariotte sensitivity`; --samples adds runs with normally distributed inputs.
)";

}  // namespace

Command uncertainty_command() {
  auto options = std::make_shared<Uncertain>();
  return {.name = "uncertainty",
          .about = "Tell how uncertain the outcome of a scene is whose numbers have deviations",
          .footer = uncertainty_examples,
          .options = joined({scene_options(options->scene),
                             run_options(options->scene),
                             {{"--of",
                               &options->of,
                               "Outcome, such as velocity, icr[0] or capture_velocity; may be repeated",
                               {.value = "QUANTITY", .takes_one = true}},
                              {"--samples",
                               &options->samples.count,
                               "Runs with random inputs, beside the first order",
                               {.value = "N", .check = Range{2, 1e9}}},
                              {"--seed",
                               &options->samples.seed,
                               "Of the random inputs",
                               {.value = "N", .shows_default = true, .needs = {"--samples"}}},
                              {"--json", &options->json, "One JSON object on stdout"}}}),
          .act = [options] { return uncertainty(*options); }};
}

}  // namespace mariotte::command
