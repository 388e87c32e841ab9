// Slopes of coefficients that stand at places of the state, from those of models around a parameter.
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "mariotte/impact/sensitivity/contact_slope.hpp"

namespace mariotte::impact {

/// Coefficients by place; those of one place are summed.
class PlacedCoefficients {
 public:
  void clear() { list_.clear(); }
  void add(Index place, double coefficient) {
    for (auto& [own, sum] : list_)
      if (own == place) {
        sum += coefficient;
        return;
      }
    list_.push_back({place, coefficient});
  }
  bool has(Index place) const;
  double at(Index place) const;  ///< 0 where there is none
  double largest() const;
  std::span<const std::pair<Index, double>> list() const { return list_; }
  bool operator==(const PlacedCoefficients&) const = default;

 private:
  std::vector<std::pair<Index, double>> list_;
};

/// Add `share` of what has moved to the slopes of a column.
void add_difference(const PlacedCoefficients& base, const PlacedCoefficients& moved, Index column,
                    double share, std::vector<ContactSlope::Term>& slopes);
/// Leave out what is zero but for rounding of coefficients, over this step.
void drop_rounding(const PlacedCoefficients& base, Index column, double step,
                   std::vector<ContactSlope::Term>& slopes);

}  // namespace mariotte::impact
