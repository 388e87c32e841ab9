#include "mariotte/core/monotone_cubic.hpp"

#include <algorithm>

namespace mariotte {
namespace {

/// Of the parabola through the last three points, between 0 and three times the last secant.
double end_slope(double own, double next, double width, double other) {
  const double slope = ((2 * width + other) * own - width * next) / (width + other);
  return own > 0 ? std::clamp(slope, 0.0, 3 * own) : std::clamp(slope, 3 * own, 0.0);
}

}  // namespace

std::vector<double> monotone_slopes(std::span<const double> x, std::span<const double> y) {
  const std::size_t last = x.size() - 1;
  const auto width = [&](std::size_t i) { return x[i + 1] - x[i]; };
  const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / width(i); };
  std::vector<double> slope(x.size(), secant(0));
  if (last == 1) return slope;
  for (std::size_t i = 1; i < last; ++i) {
    const double left = 2 * width(i) + width(i - 1), right = width(i) + 2 * width(i - 1);
    const bool turns = !(secant(i - 1) * secant(i) > 0);
    slope[i] = turns ? 0 : (left + right) / (left / secant(i - 1) + right / secant(i));
  }
  slope[0] = end_slope(secant(0), secant(1), width(0), width(1));
  slope[last] = end_slope(secant(last - 1), secant(last - 2), width(last - 1), width(last - 2));
  return slope;
}

}  // namespace mariotte
