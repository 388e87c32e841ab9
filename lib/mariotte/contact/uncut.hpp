// A damped law that ends where the indentation does: until then its damper may pull. Most other programs cut
// such laws at f = 0 instead, and so do the laws themselves; the two have different restitutions
// [Schwager & Pöschel 2007, Granul Matter 9:465].
#pragma once
#include <string>

#include "mariotte/contact/stated_law.hpp"

namespace mariotte::contact {

/// Any law without branches, its force not cut off.
class Uncut final : public BranchedLaw {
 public:
  explicit Uncut(Law law) : law_(std::move(law)) {}

  const Law& law() const { return law_; }
  std::string_view name() const override { return contact::name(law_); }
  Force force(const Memory&, double indentation, double rate) const override {
    return smooth_force(law_, indentation, rate);
  }
  double stored_energy(const Memory&, double indentation) const override {
    return contact::stored_energy(law_, indentation);
  }
  std::optional<ShiftedPower> power(const Memory&) const override {
    const auto power = contact::powers(law_);
    if (!power) return std::nullopt;
    return ShiftedPower{power->stiffness, power->exponent, 0, power->damping, 0, power->grows};
  }
  bool pulls() const override { return true; }
  bool is_damped() const override { return contact::dissipates(law_); }
  std::vector<LawParameter> parameters() const override { return contact::parameters(law_); }

 private:
  Law law_;
};

}  // namespace mariotte::contact
