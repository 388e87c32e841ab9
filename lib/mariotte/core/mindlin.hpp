// A spring of Mindlin's stiffness k_t = κ √δ under a Hertz force f_n = k δ^{3/2}: the cap μ f_n is reached at
// the stretch (μ k/κ) δ.
#pragma once

namespace mariotte {

/// Rate at which it gives way in slip; `growth` is μ k/κ. On unloading it is rescaled.
template <class T, class Number>
constexpr T mindlin_yielding(const T& slip, const Number& growth, const T& approach, bool unloading) {
  return slip - (unloading ? 1.0 : 1.5) * (growth * approach);
}

/// Energy lost in slip by changes of its stiffness, from one √δ to another: ∫ (μ f_n)² |dk_t|/2 k_t²; `cap`
/// is μ k, `stiffness` κ.
inline double mindlin_rescaled(double cap, double stiffness, double from, double to, bool unloading) {
  const auto fifth = [](double x) { return x * x * x * x * x; };
  const double change = 0.1 * cap * cap / stiffness * (fifth(to) - fifth(from));
  return unloading ? -change : change;
}

}  // namespace mariotte
