// Slopes of what is analytic in a parameter, by central differences of order eight.
//
//     dF/dp ≈ Σ_k w_k (F(p + k h) − F(p − k h))/h,   k = 1 … 4
//
// F is a formula here, never a run: forces, masses and stiffnesses as functions of what a scene says. With h
// as below the error of the formula is 2e-16 for 1/p and 2e-13 for 1/p⁵, as a radius enters the inverse of an
// inertia; rounding adds 2e-13.
#pragma once
#include <array>
#include <cstddef>
#include <span>

namespace mariotte::impact {

/// h over the parameter.
inline constexpr double stencil_share = 5e-3;

/// A hundredth of a state over its parameter.
inline double natural_slope(double step) {
  return 0.01 * stencil_share / step;
}

/// The parameter is moved to p + offset · h.
struct StencilPoint {
  int offset;
  double weight;
};

inline constexpr std::array<StencilPoint, 8> stencil{{{-4, 1.0 / 280},
                                                      {-3, -4.0 / 105},
                                                      {-2, 1.0 / 5},
                                                      {-1, -4.0 / 5},
                                                      {1, 4.0 / 5},
                                                      {2, -1.0 / 5},
                                                      {3, 4.0 / 105},
                                                      {4, -1.0 / 280}}};

/// Of what is linear in a parameter.
inline constexpr std::array<StencilPoint, 2> linear_stencil{{{-4, -1.0 / 8}, {4, 1.0 / 8}}};

/// dF/dp, where `value(k)` is F at the k-th of these points: by differences, so that it is exactly zero where
/// F stays, however short the step.
template <class Value>
double stencil_slope(std::span<const StencilPoint> points, double step, Value&& value) {
  const double first = value(0);
  double sum = 0;
  for (std::size_t k = 1; k < points.size(); ++k) sum += points[k].weight * (value(k) - first);
  return sum / step;
}
template <class Value>
double stencil_slope(double step, Value&& value) {
  return stencil_slope(stencil, step, value);
}

}  // namespace mariotte::impact
