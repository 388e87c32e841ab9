#include "mariotte/report/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

namespace mariotte::report {
namespace {

constexpr int significant_digits = 8;
constexpr std::array prefixes = {"f", "p", "n", "µ", "m", "", "k", "M", "G", "T"};  // from 10⁻¹⁵ to 10¹²
constexpr int no_prefix = 5;

double largest_magnitude(std::span<const double> values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

// Whether no prefix is wanted.
bool has_plain_size(double largest) {
  return largest == 0 || (largest >= 0.1 && largest < 1e4);
}

// Position in `prefixes` that brings `largest` into [1, 1000).
int prefix_for(double largest, const std::string& unit) {
  if (!takes_prefix(unit) || has_plain_size(largest)) return no_prefix;
  const int thousands = static_cast<int>(std::floor(std::log10(largest) / 3));
  const int last = unit == "s" ? no_prefix : static_cast<int>(prefixes.size()) - 1;
  return std::clamp(no_prefix + thousands, 0, last);
}

/// The prefix of kilograms is part of the unit.
Display display_of_mass(double largest) {
  auto display = display_for(std::vector{1e3 * largest}, "g");
  display.factor *= 1e3;
  return display;
}

}  // namespace

bool takes_prefix(std::string_view unit) {
  constexpr std::array known = {"m", "s", "N", "J", "Pa", "rad", "Hz", "g"};
  const auto first = unit.substr(0, unit.find_first_of(" /"));
  return std::find(known.begin(), known.end(), first) != known.end();
}

std::string exact(double value) {
  return rounded(value, 17);
}

void append_exact(double value, std::string& text) {
  append_rounded(value, 17, text);
}

void append_rounded(double value, int digits, std::string& text) {
  std::array<char, 32> letters;
  const auto [end, problem] =
      std::to_chars(letters.begin(), letters.end(), value + 0.0, std::chars_format::general, digits);
  text += std::isnan(value) ? "nan" : std::string_view(letters.begin(), end);
}

std::string rounded(double value, int digits) {
  std::string text;
  append_rounded(value, digits, text);
  return text;
}

std::string fixed(double value, int decimals) {
  auto text = fmt::format("{:.{}f}", value, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == text.npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

Display display_for(std::span<const double> values, const std::string& unit) {
  const double largest = largest_magnitude(values);
  if (unit == "kg" && !has_plain_size(largest)) return display_of_mass(largest);
  const int prefix = prefix_for(largest, unit);
  const double factor = std::pow(10.0, 3 * (no_prefix - prefix));
  const int whole_digits = largest > 0 ? static_cast<int>(std::floor(std::log10(largest * factor))) + 1 : 1;
  return {.factor = factor,
          .unit = unit.empty() ? "SI" : prefixes[static_cast<std::size_t>(prefix)] + unit,
          .decimals = std::clamp(significant_digits - whole_digits, 0, significant_digits)};
}

std::string shown(const Display& display, double value) {
  const double scaled = display.factor * value;
  const bool is_tiny = scaled != 0 && std::abs(scaled) < std::pow(10.0, -display.decimals);
  if (is_tiny || std::abs(scaled) >= 1e12) return fmt::format("{:.2e}", scaled);
  return fixed(scaled, display.decimals);
}

}  // namespace mariotte::report
