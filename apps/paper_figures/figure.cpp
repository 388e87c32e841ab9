#include "figure.hpp"

#include <cmath>

namespace mariotte::paper_figures {

// Comparing with NaN is false; an infinite bound is no bound.
bool holds(const Check& check) {
  return std::isfinite(check.allowed) && std::abs(check.computed - check.expected) <= check.allowed;
}

}  // namespace mariotte::paper_figures
