// A Hertz contact with damping c δ^{1/4} δ̇, f = max(0, k δ^{3/2} + c δ^{1/4} δ̇) [Tsuji, Tanaka & Ishida 1992,
// Powder Technol 71:239].
//
// In s ~ δ^{5/4} the phase curve of a pair is that of a linear contact with ζ = c/(2√(5/4) √(m k)), so its
// restitution does not depend on the speed [Antypov & Elliott 2011, EPL 94:50004].
#pragma once
#include <cmath>

#include "mariotte/contact/custom_law.hpp"
#include "mariotte/contact/power_law.hpp"

namespace mariotte::contact {

/// f = δ^{1/4} (k δ^{5/4} + c δ̇).
class Tsuji final : public CustomLaw {
 public:
  /// k > 0 [N/m^{3/2}], c ≥ 0 [N s/m^{5/4}].
  Tsuji(double stiffness, double damping) : spring_{.stiffness = stiffness}, damping_(damping) {}

  std::string_view name() const override { return "tsuji"; }
  /// The slope of the damping is unbounded towards δ = 0, and left out there.
  Force force(double indentation, double rate) const override {
    auto f = smooth_force(spring_, indentation, 0);
    const double width = std::sqrt(std::sqrt(indentation));
    f.value += damping_ * width * rate;
    f.by_rate = damping_ * width;
    if (indentation > 0) f.by_indentation += 0.25 * damping_ * width * rate / indentation;
    return f;
  }
  double stored_energy(double indentation) const override {
    return contact::stored_energy(spring_, indentation);
  }
  bool dissipates() const override { return damping_ > 0; }
  Force load(double indentation, double rate) const override {
    const double width = std::sqrt(std::sqrt(indentation));
    return {.value = spring_.stiffness * indentation * width + damping_ * rate,
            .by_indentation = 1.25 * spring_.stiffness * width,
            .by_rate = damping_};
  }
  std::optional<DampedPower> powers() const override {
    return DampedPower{.stiffness = spring_.stiffness,
                       .exponent = spring_.exponent,
                       .damping = damping_,
                       .grows = Damping::as_root};
  }
  std::vector<LawParameter> parameters() const override {
    return {{"stiffness", spring_.stiffness}, {"damping", damping_}};
  }

 private:
  PowerLaw spring_;
  double damping_;  ///< c [N s/m^{5/4}]
};

}  // namespace mariotte::contact
