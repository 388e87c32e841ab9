#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/impact/modes/vibrations.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/report/number.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {
namespace {

struct Modes {
  SceneChoice scene;
  std::string force;
  bool shapes = false;
  bool json = false;
};

struct Found {
  impact::Rest rest;
  impact::Vibrations vibrations;
  std::optional<impact::BandEdges> bands;
};

std::optional<double> end_force(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return positive_quantity("--force", text, dimension::stiffness(0));
}

Found find(const Modes& options, const scene::Scene& scene) {
  const auto force = end_force(options.force);
  const auto of_chain = [&](const model::Chain& chain) -> Found {
    const auto rest = impact::rest(chain, force);
    return {rest, vibrations(chain, rest), band_edges(chain, rest)};
  };
  const auto of_network = [&](const model::Network& network) -> Found {
    if (force) throw UsageError("--force presses the ends of a chain; a network has none");
    const auto rest = impact::rest(network);
    return {rest, vibrations(network, rest), {}};
  };
  const auto refuse = [](const auto&) -> Found {
    throw UsageError("only a [chain] or a [network] has modes");
  };
  return std::visit(Overload{of_chain, of_network, refuse}, scene.model);
}

std::string table_of(const impact::Rest& rest) {
  const auto row = [&](Index j) -> report::TableRow {
    return {fmt::format("{}", j + 1), report::rounded(rest.force[j], 10),
            report::rounded(rest.indentation[j], 10), report::rounded(rest.stiffness[j], 10)};
  };
  return report::columns({"contact", "force F [N]", "indentation δ [m]", "stiffness ∂F/∂δ [N/m]"},
                         std::ssize(rest.force), row);
}

std::string table_of(const impact::Vibrations& vibrations) {
  const auto row = [&](Index i) -> report::TableRow {
    const double frequency = vibrations.frequency[i];
    return {fmt::format("{}", i + 1), report::rounded(frequency, 12),
            report::rounded(frequency / (2 * std::numbers::pi), 10)};
  };
  auto text = report::columns({"mode", "ω [rad/s]", "frequency [Hz]"}, std::ssize(vibrations.frequency), row);
  if (vibrations.rigid_motions > 0)
    text += fmt::format("and {} without frequency: what moves without pressing a contact\n",
                        vibrations.rigid_motions);
  return text;
}

std::string text_of(const impact::BandEdges& bands) {
  if (!bands.optical_top)
    return fmt::format("An endless row of such balls passes waves up to ω = {:.12g} rad/s.\n",
                       bands.acoustic_top);
  return fmt::format(
      "An endless row of such balls passes waves up to ω = {:.12g} rad/s, and from {:.12g} to {:.12g} "
      "rad/s.\n",
      bands.acoustic_top, *bands.optical_bottom, *bands.optical_top);
}

std::string table(const Found& found, const scene::Scene& scene) {
  const auto title = scene.title.empty() ? std::string("Small vibrations") : scene.title;
  auto text = title + "\n" + report::heading("At rest") + table_of(found.rest) + report::heading("Modes") +
              table_of(found.vibrations);
  if (found.bands) text += text_of(*found.bands);
  return text;
}

report::Json json(const impact::BandEdges& bands) {
  report::Json all = {{"acoustic_top", bands.acoustic_top}};
  if (bands.optical_bottom) all["optical_bottom"] = *bands.optical_bottom;
  if (bands.optical_top) all["optical_top"] = *bands.optical_top;
  return all;
}

report::Json json(const Modes& options, const Found& found, const scene::Scene& scene) {
  const auto& [rest, vibrations, bands] = found;
  report::Json all = {
      {"title", scene.title},
      {"rest", {{"force", rest.force}, {"indentation", rest.indentation}, {"stiffness", rest.stiffness}}},
      {"angular_frequency", vibrations.frequency},
      {"rigid_motions", vibrations.rigid_motions}};
  if (options.shapes) all["shape"] = vibrations.shape;
  if (bands) all["band_edges"] = json(*bands);
  return all;
}

int modes(const Modes& options) {
  const auto scene = read(options.scene, scene::Purpose::rest);
  const auto found = find(options, scene);
  print(options.json ? report::text(json(options, found, scene)) : table(found, scene));
  return ExitCode::ok;
}

constexpr const char* modes_examples = R"(Examples:
  mariotte modes pressed_row.toml
  mariotte modes row.toml --force "20 N" --json --shapes

The row or network in static equilibrium, and its small vibrations about it, without dampers. Walls, gravity
and precompression hold a row; --force stands for them at free ends.
)";

}  // namespace

Command modes_command() {
  auto options = std::make_shared<Modes>();
  return {
      .name = "modes",
      .about = "Find the frequencies of small vibrations about static equilibrium",
      .footer = modes_examples,
      .options = joined({scene_options(options->scene),
                         {{"--force", &options->force, "Press the ends of a row with it", {.value = "FORCE"}},
                          {"--shapes", &options->shapes, "Displacements of each mode", {.needs = {"--json"}}},
                          {"--json", &options->json, "One JSON object on stdout"}}}),
      .act = [options] { return modes(*options); }};
}

}  // namespace mariotte::command
