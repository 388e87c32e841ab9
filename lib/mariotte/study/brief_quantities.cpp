#include "mariotte/study/brief_quantities.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace mariotte::study {
namespace {

using Brief = BriefResult;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

double at(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : undefined;
}

double time(const Brief& brief, std::size_t) {
  return brief.impact.time;
}

double velocity(const Brief& brief, std::size_t i) {
  return at(brief.impact.velocity, i);
}

double impulse(const Brief& brief, std::size_t j) {
  return at(brief.impact.impulse, j);
}

double energy(const Brief& brief, std::size_t) {
  return kinetic_energy(brief.chain, brief.impact.velocity);
}

double energy_ratio(const Brief& brief, std::size_t) {
  const double before = kinetic_energy(brief.chain, brief.chain.velocity);
  return before > 0 ? kinetic_energy(brief.chain, brief.impact.velocity) / before : undefined;
}

double icr(const Brief& brief, std::size_t j) {
  const auto& p = brief.impact.impulse;
  return j + 1 < p.size() && p[j + 1] != 0 ? p[j] / p[j + 1] : undefined;
}

double direction(const Brief& brief, std::size_t j) {
  double length = 0;
  for (const double p : brief.impact.impulse) length = std::hypot(length, p);
  const double p = impulse(brief, j);
  return length > 0 ? p / length : p;
}

double periods(const Brief& brief, std::size_t j) {
  return j < brief.impact.periods.size() ? static_cast<double>(brief.impact.periods[j]) : undefined;
}

struct Known {
  std::string_view before, after;  ///< of the index; `after` is empty if there is none
  double (*read)(const Brief&, std::size_t);
};

constexpr std::array<Known, 8> known{{{"final.time", "", time},
                                      {"final.velocity[", "]", velocity},
                                      {"contacts[", "].impulse", impulse},
                                      {"contacts[", "].periods.count", periods},
                                      {"icr[", "]", icr},
                                      {"impulse_direction[", "]", direction},
                                      {"energy.final", "", energy},
                                      {"energy.ratio_lab", "", energy_ratio}}};

}  // namespace

std::optional<BriefQuantity> brief_quantity(std::string_view key) {
  for (const auto& [before, after, read] : known) {
    if (after.empty() && key == before) return BriefQuantity{read};
    if (after.empty() || !key.starts_with(before)) continue;
    std::size_t index = 0;
    const char* const end = key.data() + key.size();
    const auto [stop, error] = std::from_chars(key.data() + before.size(), end, index);
    if (error == std::errc() && std::string_view(stop, end) == after) return BriefQuantity{read, index};
  }
  return {};
}

}  // namespace mariotte::study
