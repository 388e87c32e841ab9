#include "mariotte/study/propagation/outcome_columns.hpp"

#include <algorithm>
#include <array>

namespace mariotte::study {
namespace {

/// An outcome of balls, and what stands before and behind its index in a result.
struct Place {
  std::string_view outcome, before, behind;
};
constexpr std::array places = {Place{"velocity", "final.velocity", ""},
                               Place{"impulse", "contacts", ".impulse"}, Place{"icr", "icr", ""},
                               Place{"time", "final.time", ""}, Place{"dissipated", "energy.dissipated", ""}};

}  // namespace

std::optional<std::vector<Column>> columns_of(const std::vector<impact::OutcomeSlopes>& outcomes) {
  std::vector<Column> columns;
  for (const auto& one : outcomes) {
    const auto place = std::find_if(places.begin(), places.end(),
                                    [&](const Place& known) { return known.outcome == one.name; });
    if (place == places.end()) return std::nullopt;
    const auto index = one.index ? "[" + std::to_string(*one.index) + "]" : "";
    columns.push_back({.key = std::string(place->before) + index + std::string(place->behind)});
  }
  return columns;
}

}  // namespace mariotte::study
