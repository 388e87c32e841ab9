// The indentation of a law at which something that grows with it has a value.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "mariotte/core/bracket.hpp"
#include "mariotte/core/error.hpp"

namespace mariotte::contact {

/// The argument at which a growing function reaches a positive value, to the rounding of natural sizes:
/// between two powers of 16, then by secants. None if it does not.
template <class Function>
std::optional<double> if_reached(Function&& function, double value) {
  constexpr int most = 250;  // nearly all that doubles hold
  const auto excess = [&](double at) { return function(at) - value; };
  double low = 1, high = 1;
  for (int i = 0; i < most && excess(low) > 0; ++i) high = std::exchange(low, low / 16);
  for (int i = 0; i < most && excess(high) < 0; ++i) low = std::exchange(high, high * 16);
  const double below = excess(low), above = excess(high);
  if (!(below <= 0 && above >= 0)) return std::nullopt;
  return locate_sign_change(excess, low, below, high, above, 2e-15 * high);
}

/// The same. Throws InvalidParameter if there is none.
template <class Function>
double where_reached(Function&& function, double value, std::string_view law) {
  if (const auto found = if_reached(function, value)) return *found;
  throw InvalidParameter("the law '" + std::string(law) + "' does not grow from zero with the indentation");
}

}  // namespace mariotte::contact
