// A power law as somebody outside would write it: nothing shows that it is one.
#pragma once
#include "mariotte/contact/law.hpp"

namespace mariotte::test {

class CustomPowerLaw final : public contact::CustomLaw {
 public:
  explicit CustomPowerLaw(const contact::PowerLaw& law) : law_(law) {}
  std::string_view name() const override { return "outside"; }
  contact::Force force(double indentation, double rate) const override {
    return contact::smooth_force(law_, indentation, rate);
  }
  double stored_energy(double indentation) const override {
    return contact::stored_energy(law_, indentation);
  }
  bool dissipates() const override { return law_.damping > 0; }

 private:
  contact::PowerLaw law_;
};

inline contact::SharedLaw custom(const contact::PowerLaw& law) {
  return std::make_shared<CustomPowerLaw>(law);
}

}  // namespace mariotte::test
