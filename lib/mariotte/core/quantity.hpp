// Numbers with units: "10 mm", "0.38 J/m^2", "3 N/m^1.5" → SI.
//
//     quantity = number [unit] | "inf"
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "mariotte/core/dimension.hpp"
#include "mariotte/core/error.hpp"

namespace mariotte {

/// Text that is not a quantity, or one of the wrong dimension.
struct QuantityError : Error {
  QuantityError(const std::string& what, Fault kind) : Error(what, kind) {}
};

/// A value in SI. Without a unit in the text it fits every dimension.
struct Quantity {
  double value;
  Dimension dimension;
  std::string unit;  ///< as written; empty for a bare number
};

/// What stands between a number and its standard deviation.
inline constexpr std::array<std::string_view, 3> deviation_signs{"±", "+-", "+/-"};

/// Throws QuantityError if the text is no quantity; an unknown unit comes with the nearest known one.
Quantity parse_quantity(std::string_view text);

/// Value in SI of a text that must have this dimension, or no unit. Throws QuantityError.
double parse_quantity(std::string_view text, const Dimension& expected);

}  // namespace mariotte
