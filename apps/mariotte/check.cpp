#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/core/counted.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/report/table/table.hpp"
#include "mariotte/study/sweep/design_reader.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {
namespace {

struct CheckOptions {
  SceneChoice scene;
  bool json = false;
};

/// What its [[sweep]] tables would do, if the scene has any. Throws SceneError if they or its columns make no
/// sense.
std::string check_sweep(scene::Document document, bool quiet) {
  const bool has_sweep = find(*document.tree.table(), "sweep");
  document.source.warnings.clear();  // the scene has told them
  const auto design = has_sweep ? study::read_design(document) : study::Design();
  study::expect_own_columns(document, design);
  if (!has_sweep) return "";
  if (!quiet)
    for (const auto& one : document.source.warnings) warning(one);
  return fmt::format("\nSweep\n  {}, varying {}\n", counted(design.points(), "point"),
                     fmt::join(study::keys(design), ", "));
}

int check(const CheckOptions& options) {
  const auto document = open(options.scene);
  const auto scene = resolve(options.scene, document);
  const auto sweep = check_sweep(document, options.scene.quiet);
  print(options.json ? report::text(report::json(scene)) : report::table(scene) + sweep);
  return ExitCode::ok;
}

constexpr const char* check_examples = R"(Examples:
  mariotte check cradle.toml
  mariotte check cradle.toml --set "chain.velocity[0]=2 m/s" --json
)";

}  // namespace

Command check_command() {
  auto options = std::make_shared<CheckOptions>();
  return {.name = "check",
          .about = "Validate a scene and show it in SI units; run nothing",
          .footer = check_examples,
          .options = joined(
              {scene_options(options->scene), {{"--json", &options->json, "One JSON object on stdout"}}}),
          .act = [options] { return check(*options); }};
}

}  // namespace mariotte::command
