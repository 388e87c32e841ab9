#include "mariotte/report/limit_count.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/scene/judge.hpp"
#include "mariotte/scene/simulate.hpp"

namespace mariotte::report {
namespace {

constexpr Index least_runs = 2, most_runs = 8, share_of_runs = 10;

}  // namespace

std::vector<Index> some_of(Index count) {
  const Index some = std::min(count, std::clamp(count / share_of_runs, least_runs, most_runs));
  std::vector<Index> places;
  for (Index k = 0; k < some; ++k) places.push_back(some == 1 ? 0 : k * (count - 1) / (some - 1));
  return places;
}

void LimitCount::look(const scene::Scene& scene) {
  if (!has_validity(scene)) return;
  const auto count = [&](const auto& impact) {
    invalid_ += impact.ending == hybrid::Ending::invalid;
    for (std::size_t i = 0; i < beyond_.size(); ++i)
      beyond_[i] += is_beyond(impact::validity_limits[i], impact.validity);
  };
  std::visit(count, scene::simulate(scene));
}

std::vector<std::string> LimitCount::sentences(std::size_t looked_at, const char* points,
                                               const char* option) const {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < beyond_.size(); ++i) {
    const auto& one = impact::validity_limits[i];
    if (beyond_[i] == 0) continue;
    const auto how = *option ? fmt::format(" ({} {})", option, one.key) : "";
    list.push_back(fmt::format("at {} of {} {} that were looked at, {} is {} {:g}: {}{}", beyond_[i],
                               looked_at, points, one.symbol, one.from_below ? "above" : "below", one.limit,
                               one.otherwise, how));
  }
  return list;
}

}  // namespace mariotte::report
