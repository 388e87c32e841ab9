// Damping that grows with the force, f = max(0, k δⁿ (1 + a δ̇)) [Hunt & Crossley 1975, J Appl Mech 42:440].
//
// The force is zero where the gap opens, or at δ̇ = −1/a: a contact that neighbours draw apart faster goes
// slack. A pair alone always lets go at δ = 0, with the restitution e of a v (1 + e) = ln[(1 + a v)/(1 − a e
// v)].
#pragma once
#include <cmath>

#include "mariotte/contact/custom_law.hpp"
#include "mariotte/contact/power_law.hpp"
#include "mariotte/core/error.hpp"

namespace mariotte::contact {

/// f = k δⁿ (1 + a δ̇).
class HuntCrossley final : public CustomLaw {
 public:
  /// k > 0 [N/m^n], a ≥ 0 [s/m], n ≥ 1. Throws InvalidParameter.
  explicit HuntCrossley(double stiffness, double damping, double exponent = 1.5)
      : spring_{.stiffness = stiffness, .exponent = exponent}, damping_(damping) {
    if (!(stiffness > 0 && damping >= 0 && exponent >= 1 && std::isfinite(stiffness + damping + exponent)))
      throw InvalidParameter(
          "hunt-crossley: stiffness must be positive, damping not negative, exponent at least 1, all finite");
  }

  std::string_view name() const override { return "hunt-crossley"; }
  Force force(double indentation, double rate) const override {
    const auto elastic = smooth_force(spring_, indentation, 0);
    const double factor = 1 + damping_ * rate;
    return {.value = factor * elastic.value,
            .by_indentation = factor * elastic.by_indentation,
            .by_rate = damping_ * elastic.value};
  }
  double stored_energy(double indentation) const override {
    return contact::stored_energy(spring_, indentation);
  }
  bool dissipates() const override { return damping_ > 0; }
  Force load(double /*indentation*/, double rate) const override {
    return {.value = 1 + damping_ * rate, .by_indentation = 0, .by_rate = damping_};
  }
  std::optional<DampedPower> powers() const override {
    return DampedPower{.stiffness = spring_.stiffness,
                       .exponent = spring_.exponent,
                       .damping = damping_ * spring_.stiffness,
                       .grows = Damping::as_force};
  }
  std::vector<LawParameter> parameters() const override {
    return {{"stiffness", spring_.stiffness}, {"damping", damping_}, {"exponent", spring_.exponent}};
  }

 private:
  PowerLaw spring_;
  double damping_;  ///< a [s/m]
};

}  // namespace mariotte::contact
