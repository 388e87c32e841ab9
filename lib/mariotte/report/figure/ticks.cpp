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

std::string tick_name(double value) {
  return fmt::format("{}{:g}", value < 0 ? "−" : "", std::abs(value));
}

}  // namespace mariotte::report
