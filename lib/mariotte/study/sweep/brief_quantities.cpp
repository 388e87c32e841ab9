#include "mariotte/study/sweep/brief_quantities.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "mariotte/impact/laws/restitution.hpp"

namespace mariotte::study {
namespace {

using Brief = BriefChain;

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

double time_of_body(const BriefBody& brief, std::size_t) {
  return brief.impact.time;
}

double component(const Vector3& v, std::size_t i) {
  return i == 0 ? v.e1 : i == 1 ? v.e2 : i == 2 ? v.e3 : undefined;
}

double velocity_of_body(const BriefBody& brief, std::size_t i) {
  return component(brief.impact.velocity, i);
}

double spin(const BriefBody& brief, std::size_t i) {
  return component(brief.impact.spin, i);
}

/// As in the whole result, both are 0 of a captured body, and not known before the tip has separated.
impact::Restitution restitution(const BriefBody& brief) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (brief.impact.ending == hybrid::Ending::captured) return {};
  if (brief.impact.ending != hybrid::Ending::separated) return {.tip = unknown, .centre = unknown};
  return impact::restitution(tip_velocity(brief.body, 0), brief.impact.tip_velocity, brief.body.velocity.e1,
                             brief.impact.velocity.e1);
}

double restitution_of_tip(const BriefBody& brief, std::size_t) {
  return restitution(brief).tip;
}

double restitution_of_centre(const BriefBody& brief, std::size_t) {
  return restitution(brief).centre;
}

template <class Result>
struct Known {
  std::string_view before, after;  ///< of the index; `after` is empty if there is none
  double (*read)(const Result&, std::size_t);
};

constexpr std::array<Known<BriefChain>, 8> of_chain{{{"final.time", "", time},
                                                     {"final.velocity[", "]", velocity},
                                                     {"contacts[", "].impulse", impulse},
                                                     {"contacts[", "].periods.count", periods},
                                                     {"icr[", "]", icr},
                                                     {"impulse_direction[", "]", direction},
                                                     {"energy.final", "", energy},
                                                     {"energy.ratio_lab", "", energy_ratio}}};

constexpr std::array<Known<BriefBody>, 5> of_body{{{"final.time", "", time_of_body},
                                                   {"final.velocity[", "]", velocity_of_body},
                                                   {"final.spin[", "]", spin},
                                                   {"restitution.tip", "", restitution_of_tip},
                                                   {"restitution.centre", "", restitution_of_centre}}};

template <class Result, std::size_t n>
std::optional<BriefQuantity<Result>> look_up(const std::array<Known<Result>, n>& known,
                                             std::string_view key) {
  for (const auto& [before, after, read] : known) {
    if (after.empty() && key == before) return BriefQuantity<Result>{read};
    if (after.empty() || !key.starts_with(before)) continue;
    std::size_t index = 0;
    const char* const end = key.data() + key.size();
    const auto [stop, error] = std::from_chars(key.data() + before.size(), end, index);
    if (error == std::errc() && std::string_view(stop, end) == after)
      return BriefQuantity<Result>{read, index};
  }
  return {};
}

}  // namespace

std::optional<BriefQuantity<BriefChain>> brief_quantity_of_chain(std::string_view key) {
  return look_up(of_chain, key);
}

std::optional<BriefQuantity<BriefBody>> brief_quantity_of_body(std::string_view key) {
  return look_up(of_body, key);
}

}  // namespace mariotte::study
