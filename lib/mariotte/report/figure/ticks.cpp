#include "mariotte/report/figure/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mariotte::report {

double tick_step(double span, double most) {
  const double least = span / std::max(1.0, most), decade = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * decade >= least) return digit * decade;
  return 10 * decade;
}

namespace {

/// The digits of every so many decades; what is beyond the ends would widen the margin.
std::vector<double> round_numbers(double least, double most, const std::vector<double>& digits, int decades) {
  std::vector<double> found;
  for (int power = static_cast<int>(std::floor(std::log10(least))); std::pow(10, power) <= most;
       power += decades)
    for (const double digit : digits)
      if (const double at = digit * std::pow(10, power); at >= least * (1 - 1e-9) && at <= most * (1 + 1e-9))
        found.push_back(at);
  return found;
}

std::vector<double> even_numbers(double least, double most) {
  constexpr double most_of_them = 4;
  const double step = tick_step(most - least, most_of_them);
  std::vector<double> found;
  for (double n = std::ceil(least / step - 1e-9); n * step <= most * (1 + 1e-9); ++n)
    found.push_back(n * step);
  return found;
}

/// Every two neighbours have a letter between them.
bool have_room(const std::vector<double>& ticks, double letters_per_decade) {
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const auto lengths = tick_name(ticks[i - 1]).size() + tick_name(ticks[i]).size();
    if (letters_per_decade * std::log10(ticks[i] / ticks[i - 1]) < 0.5 * static_cast<double>(lengths) + 1)
      return false;
  }
  return true;
}

}  // namespace

std::vector<double> logarithmic_ticks(double least, double most, double letters) {
  const double letters_per_decade = letters / std::log10(most / least);
  const std::vector<std::vector<double>> all_digits = {{1, 2, 3, 5, 7}, {1, 2, 5}, {1, 3}};
  if (most > least && round_numbers(least, most, all_digits[0], 1).size() < 2)
    return even_numbers(least, most);
  for (const auto& digits : all_digits)
    if (auto ticks = round_numbers(least, most, digits, 1); have_room(ticks, letters_per_decade))
      return ticks;
  int decades = 1;
  while (!have_room(round_numbers(least, most, {1}, decades), letters_per_decade)) ++decades;
  return round_numbers(least, most, {1}, decades);
}

std::string tick_name(double value) {
  return fmt::format("{}{:g}", value < 0 ? "−" : "", std::abs(value));
}

}  // namespace mariotte::report
