#include "mariotte/impact/sensitivity/coefficient_slopes.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {
namespace {

void add_slope(Index place, Index column, double part, std::vector<ContactSlope::Term>& slopes) {
  if (part == 0) return;
  for (auto& one : slopes)
    if (one.place == place && one.column == column) {
      one.slope += part;
      return;
    }
  slopes.push_back({place, column, part});
}

}  // namespace

bool PlacedCoefficients::has(Index place) const {
  return std::any_of(list_.begin(), list_.end(), [&](const auto& one) { return one.first == place; });
}

double PlacedCoefficients::at(Index place) const {
  for (const auto& [own, coefficient] : list_)
    if (own == place) return coefficient;
  return 0;
}

double PlacedCoefficients::largest() const {
  double most = 0;
  for (const auto& [place, coefficient] : list_) most = std::max(most, std::abs(coefficient));
  return most;
}

void add_difference(const PlacedCoefficients& base, const PlacedCoefficients& moved, Index column,
                    double share, std::vector<ContactSlope::Term>& slopes) {
  for (const auto& [place, coefficient] : base.list())
    add_slope(place, column, share * (moved.at(place) - coefficient), slopes);
  for (const auto& [place, coefficient] : moved.list())
    if (!base.has(place)) add_slope(place, column, share * coefficient, slopes);
}

void drop_rounding(const PlacedCoefficients& base, Index column, double step,
                   std::vector<ContactSlope::Term>& slopes) {
  const double least = 8 * epsilon * base.largest() / step;
  std::erase_if(slopes,
                [&](const auto& one) { return one.column == column && std::abs(one.slope) <= least; });
}

}  // namespace mariotte::impact
