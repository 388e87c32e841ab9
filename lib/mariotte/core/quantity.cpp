#include "mariotte/core/quantity.hpp"

#include <charconv>
#include <cmath>

#include "mariotte/core/types.hpp"
#include "mariotte/core/unit.hpp"

namespace mariotte {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Takes the number off the front of `text`.
double take_number(std::string_view& text) {
  const auto whole = text;
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  double value = infinity;
  if (text == "inf") {
    text = {};
  } else {
    if (text.empty() || std::string_view("0123456789.").find(text.front()) == std::string_view::npos)
      throw QuantityError("expected a number with a unit, got " + quoted(whole), fault::no_quantity);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range)
      throw QuantityError("number out of range in " + quoted(whole), fault::out_of_range);
    if (error != std::errc())
      throw QuantityError("expected a number with a unit, got " + quoted(whole), fault::no_quantity);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return negative ? -value : value;
}

}  // namespace

Quantity parse_quantity(std::string_view text) {
  auto rest = trimmed(text);
  const double number = take_number(rest);
  rest = trimmed(rest);
  if (rest.empty()) return {number, {}, {}};
  for (const auto sign : deviation_signs)
    if (rest.find(sign) != std::string_view::npos)
      throw QuantityError("got " + quoted(text) + ": deviations are for 'mariotte uncertainty' alone",
                          fault::no_quantity);
  const auto unit = parse_unit(rest);
  const double value = number * unit.up / unit.down;
  if (!std::isfinite(value))
    throw QuantityError("number out of range in " + quoted(text), fault::out_of_range);
  return {value, unit.dimension, std::string(rest)};
}

double parse_quantity(std::string_view text, const Dimension& expected) {
  const auto quantity = parse_quantity(text);
  if (!quantity.unit.empty() && !same(quantity.dimension, expected))
    throw QuantityError("expected " + describe(expected) + ", got " + quoted(quantity.unit),
                        fault::wrong_dimension);
  return quantity.value;
}

}  // namespace mariotte
