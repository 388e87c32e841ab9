// An estimate of an error that shares no formula with what it judges.
#pragma once
#include <algorithm>
#include <optional>
#include <string_view>

#include "mariotte/flow/kind.hpp"
#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"

namespace mariotte::impact {

/// Accuracy to which CVODE keeps its promise with steps to spare.
inline constexpr double cvode_floor = 1e-12;

/// CVODE, or where it was asked for the choice of the library.
inline std::optional<flow::Kind> another_flow(const hybrid::Options& options) {
  if (options.flow && is_cvode(*options.flow)) return std::nullopt;
  return flow::Kind::cvode_adams;
}

/// CVODE has followed all phases in which something pushes, and by choice: there is no other flow for them.
template <class Impact>
bool has_no_other(const Impact& result, const hybrid::Options& options) {
  const auto is_left = [](const auto& use) {
    return use.name.starts_with("cvode") || use.name == name(flow::Kind::ballistic);
  };
  return !options.flow && std::all_of(result.flows.begin(), result.flows.end(), is_left);
}

/// `estimate`, or how far apart a run by another flow is, where that is more than the error of that run:
/// ten times `floor`, or what it says. `simulate(options)` runs, `apart(impact)` compares.
template <class Simulate, class Apart>
double beside_another_flow(double estimate, hybrid::Options options, std::optional<flow::Kind> kind,
                           double floor, Simulate&& simulate, Apart&& apart) {
  options.flow = kind;
  options.accuracy = std::max(options.accuracy, floor);
  const auto& other = simulate(options);
  using hybrid::Ending;
  if (other.ending == Ending::failed || other.ending == Ending::event_limit) return estimate;
  const double difference = apart(other),
               own = std::max(10 * floor, 4 * other.estimated_accuracy.value_or(0));
  return difference > own ? std::max(estimate, difference) : estimate;
}

}  // namespace mariotte::impact
