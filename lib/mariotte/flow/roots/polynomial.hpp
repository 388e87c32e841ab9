// First roots of the polynomials that steps are made of, none skipped.
#pragma once
#include <optional>
#include <span>

#include "mariotte/core/types.hpp"

namespace mariotte::flow {

/// Σ c[k] xᵏ.
double horner(std::span<const double> c, double x);

/// Whether Σ c[k] xᵏ is proven to fall all the way over [0, end].
bool falls(std::span<const double> c, double end);

/// First x in (0, end] at which Σ c[k] xᵏ falls to zero, for a polynomial that is positive right of 0;
/// infinite if there is none. A root at 0 itself does not count. Proven by subdivision of the Bernstein form;
/// at most 32 coefficients.
double place_of_fall(std::span<const double> c, double end);

/// The same, if there is one. Inline: an optional that a call returns would wait for memory.
inline std::optional<double> first_fall(std::span<const double> c, double end) {
  const double place = place_of_fall(c, end);
  return place == infinity ? std::nullopt : std::optional(place);
}

/// x in [0, end] at which Σ c[k] xᵏ, which grows from 0, comes to `value`; `end` if it does not.
double rise_to(std::span<const double> c, double value, double end);

}  // namespace mariotte::flow
