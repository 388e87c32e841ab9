#include "mariotte/study/capture.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/core/counted.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/study/fault.hpp"
#include "run_notes.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {
namespace {

struct Capture {
  SceneChoice scene;
  double tolerance = 1e-9;
  bool json = false;
};

std::string table(const impact::CaptureVelocity& found, const scene::Scene& scene) {
  return fmt::format(
      "{}\ncapture velocity {:.12g} m/s\n  captured at {:.12g} m/s, separated at {:.12g} m/s · {} "
      "simulated\n",
      scene.title.empty() ? "Capture" : scene.title, found.value(), found.captured, found.separated,
      counted(found.runs, "impact"));
}

report::Json json(const impact::CaptureVelocity& found, const scene::Scene& scene) {
  return {{"title", scene.title},
          {"capture_velocity", found.value()},
          {"captured", found.captured},
          {"separated", found.separated},
          {"runs", found.runs}};
}

int capture(const Capture& options) {
  const auto document = open(options.scene);
  const auto scene = resolve(options.scene, document);
  const auto found = study::capture_velocity(document, options.tolerance);
  if (!found) {
    error(study::no_capture_velocity, fault::no_capture);
    return ExitCode::check_failed;
  }
  print(options.json ? report::text(json(*found, scene)) : table(*found, scene));
  return tell_run_at(found->separated, study::at_speed(document, found->separated), options.scene.quiet);
}

constexpr const char* capture_examples = R"(Examples:
  mariotte capture microsphere.toml
  mariotte capture fine_powder.toml
  mariotte capture microrod.toml --set "incidence.angles[1]=20 deg" --json

Closes a bracket around the normal speed below which the body stays; all else is as the scene says.
A body that is never captured, as one without damping: exit code 1.
)";

}  // namespace

Command capture_command() {
  auto options = std::make_shared<Capture>();
  return {.name = "capture",
          .about = "Find the speed below which a microbody, or a pair that adheres, does not part again",
          .footer = capture_examples,
          .options = joined(
              {scene_options(options->scene),
               {{"--tolerance",
                 &options->tolerance,
                 "Width of the bracket, relative to the speed",
                 {.check = Range{study::finest_capture, study::widest_capture}, .shows_default = true}},
                {"--json", &options->json, "One JSON object on stdout"}}}),
          .act = [options] { return capture(*options); }};
}

}  // namespace mariotte::command
