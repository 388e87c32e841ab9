// Products, quotients and powers of prefixed units, as in "kg/m^3".
//
//     unit   = factor { ("*" | "·" | " " | "/") factor }        a product after "/" needs parentheses
//     factor = ( prefixed name | "(" unit ")" | "1" ) [ "^" power | "²" | "³" ]
//     power  = decimal | "(" decimal [ "/" decimal ] ")"
#pragma once
#include <string>
#include <string_view>

#include "mariotte/core/dimension.hpp"

namespace mariotte {

/// A unit is up/down in SI. Both are exact powers of ten for most units, so "7 mm" is 7/1000, rounded once,
/// and the same double as 0.007.
struct UnitFactor {
  double up = 1;
  double down = 1;
  Dimension dimension;
};

/// Throws QuantityError for what is no unit; an unknown name comes with the nearest known one.
UnitFactor parse_unit(std::string_view text);

/// 'kgm', as messages name what cannot be read.
std::string quoted(std::string_view text);

}  // namespace mariotte
