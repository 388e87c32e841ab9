#include "mariotte/report/table/modes_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

std::string table_of(const impact::Rest& rest) {
  const auto row = [&](Index j) -> TableRow {
    return {fmt::format("{}", j + 1), rounded(rest.force[j], 10), rounded(rest.indentation[j], 10),
            rounded(rest.stiffness[j], 10)};
  };
  return columns({"contact", "force F [N]", "indentation δ [m]", "stiffness ∂F/∂δ [N/m]"},
                 std::ssize(rest.force), row);
}

std::string table_of(const impact::Vibrations& vibrations) {
  const auto row = [&](Index i) -> TableRow {
    const double frequency = vibrations.frequency[i];
    return {fmt::format("{}", i + 1), rounded(frequency, 12),
            rounded(frequency / (2 * std::numbers::pi), 10)};
  };
  auto text = columns({"mode", "ω [rad/s]", "frequency [Hz]"}, std::ssize(vibrations.frequency), row);
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

Json json(const impact::BandEdges& bands) {
  Json all = {{"acoustic_top", bands.acoustic_top}};
  if (bands.optical_bottom) all["optical_bottom"] = *bands.optical_bottom;
  if (bands.optical_top) all["optical_top"] = *bands.optical_top;
  return all;
}

}  // namespace

Json json(const study::Modes& modes) {
  const auto& [rest, vibrations, bands] = modes;
  Json all = {
      {"rest", {{"force", rest.force}, {"indentation", rest.indentation}, {"stiffness", rest.stiffness}}},
      {"angular_frequency", vibrations.frequency},
      {"rigid_motions", vibrations.rigid_motions}};
  if (bands) all["band_edges"] = json(*bands);
  return all;
}

std::string table(const study::Modes& modes, const std::string& title) {
  auto text = (title.empty() ? "Small vibrations" : title) + "\n" + heading("At rest") +
              table_of(modes.rest) + heading("Modes") + table_of(modes.vibrations);
  if (modes.bands) text += text_of(*modes.bands);
  return text;
}

}  // namespace mariotte::report
