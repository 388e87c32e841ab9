#include "reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "guard.hpp"
#include "mariotte/impact/laws/linear_triplet.hpp"
#include "measuring/stored_cases.hpp"

namespace mariotte::stiffness_study {
namespace {

using Json = nlohmann::json;
using Numbers = std::vector<double>;
using measuring::same;

template <class Matches>
std::optional<Numbers> stored_in(const std::string& name, const Matches& matches) {
  for (const auto& one : measuring::cases(name))
    if (one.contains("final") && matches(one)) return one.at("final").get<Numbers>();
  return std::nullopt;
}

std::optional<Numbers> stored_numbers(const ImpactCase& unit) {
  if (unit.law == "hertz" && unit.balls == 3)
    return stored_in("chain/triplets", [&](const Json& one) {
      return one["law"] == "hertz" && same(one["kappa"], unit.ratio) && one["velocity"] == Numbers{1, 0, 0};
    });
  if (unit.law == "hertz" && unit.ratio == 1)
    return stored_in("chain/equal_chains", [&](const Json& one) { return one["n"] == unit.balls; });
  if (unit.law == "viscoelastic" && unit.balls == 3 && unit.ratio == 1)
    return stored_in("chain/viscoelastic", [&](const Json& one) {
      return one["final"].size() == 3 && one["exponent"] == unit.exponent &&
             same(one["damping"], unit.damping);
    });
  return std::nullopt;
}

}  // namespace

std::optional<Reference> References::find(const ImpactCase& one, const std::vector<std::string>& used,
                                          double accuracy) {
  const auto unit = dimensionless(one);
  if (auto numbers = stored_numbers(unit)) return Reference{*numbers, "stored"};
  if (unit.law == "linear" && unit.balls == 3) {
    const auto closed = impact::linear_triplet({.ratio = unit.ratio});
    return Reference{{closed.velocity.begin(), closed.velocity.end()}, "closed form"};
  }
  for (const char* flow : {"cvode-adams", "cvode-bdf-band", "taylor"}) {
    if (std::find(used.begin(), used.end(), flow) != used.end()) continue;
    if (auto found = computed(unit, flow, std::max(0.01 * accuracy, 1e-14))) return found;
  }
  return std::nullopt;
}

std::optional<Reference> References::computed(const ImpactCase& unit, const std::string& flow,
                                              double accuracy) {
  const auto family = fmt::format("{} {} {} {}", flow, unit.law, unit.balls, unit.exponent);
  const auto key = fmt::format("{} {} {:.12g} {}", family, unit.ratio, unit.damping, accuracy);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  auto& reference = known_[key];
  if (slowest_[family] > patience_) return reference;
  const double limit = 4 * patience_;
  const auto run = guarded(unit, {.flow = flow, .accuracy = accuracy, .batch = 0}, limit);
  slowest_[family] = std::max(slowest_[family], run.ending == "-" ? limit : run.seconds);
  if (run.separated() && run.admitted)
    reference = Reference{run.velocity, fmt::format("{} at {:.0e}", flow, accuracy)};
  return reference;
}

}  // namespace mariotte::stiffness_study
