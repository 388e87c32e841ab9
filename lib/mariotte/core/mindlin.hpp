// A spring of Mindlin's stiffness k_t = κ √δ under a Hertz force f_n = k δ^{3/2}: the cap μ f_n is reached at
// the stretch (μ k/κ) δ.
#pragma once

namespace mariotte {

/// Rate at which it gives way in slip; `growth` is μ k/κ. On unloading it is rescaled.
template <class T, class Number>
constexpr T mindlin_yielding(const T& slip, const Number& growth, const T& approach, bool unloading) {
  return slip - (unloading ? 1.0 : 1.5) * (growth * approach);
}

}  // namespace mariotte
