#include "mariotte/contact/custom_law.hpp"

#include <cmath>
#include <sstream>
#include <utility>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/contact/where_reached.hpp"

namespace mariotte::contact {
namespace {

Force on_tangent(const Force& f, double indentation) {
  return {.value = f.value + f.by_indentation * indentation,
          .by_indentation = f.by_indentation,
          .by_rate = f.by_rate};
}

/// f(δ L, δ̇ V) in the unit of force.
class ScaledLaw final : public CustomLaw {
 public:
  ScaledLaw(SharedLaw law, const Scale& scale) : law_(std::move(law)), scale_(scale) {
    if (const auto* stated = law_->curve()) curve_ = scaled(*stated);
  }

  std::string_view name() const override { return law_->name(); }
  Force force(double indentation, double rate) const override {
    return scaled(law_->force(indentation * scale_.length, rate * scale_.velocity));
  }
  double stored_energy(double indentation) const override {
    return law_->stored_energy(indentation * scale_.length) / scale_.energy();
  }
  bool dissipates() const override { return law_->dissipates(); }
  Force load(double indentation, double rate) const override {
    return scaled(law_->load(indentation * scale_.length, rate * scale_.velocity));
  }
  double natural_indentation(double energy) const override {
    return law_->natural_indentation(energy * scale_.energy()) / scale_.length;
  }
  std::optional<DampedPower> powers() const override {
    auto powers = law_->powers();
    if (!powers) return powers;
    const double n = powers->exponent, q = damping_exponent(powers->grows, n), unit = scale_.force();
    powers->stiffness *= std::pow(scale_.length, n) / unit;
    powers->damping *= std::pow(scale_.length, q) * scale_.velocity / unit;
    return powers;
  }
  const CubicCurve* curve() const override { return curve_.empty() ? nullptr : &curve_; }
  std::vector<LawParameter> parameters() const override { return law_->parameters(); }

 private:
  CubicCurve scaled(CubicCurve curve) const {
    for (auto& segment : curve) {
      segment.from /= scale_.length;
      segment.to /= scale_.length;
      double unit = 1 / scale_.force();
      for (double& a : segment.a) a *= std::exchange(unit, unit * scale_.length);
    }
    return curve;
  }
  Force scaled(const Force& f) const {
    const double unit = scale_.force();
    return {.value = f.value / unit,
            .by_indentation = f.by_indentation * (scale_.length / unit),
            .by_rate = f.by_rate * (scale_.velocity / unit)};
  }

  SharedLaw law_;
  Scale scale_;
  CubicCurve curve_;  ///< none if empty
};

[[noreturn]] void refuse(const CustomLaw& law, double depth, const std::string& why) {
  std::ostringstream at;
  at << depth;
  throw InvalidParameter("the law '" + std::string(law.name()) + "' at δ = " + at.str() + " m: " + why);
}

/// Its force pushes where it stores energy, and without losses it is the slope of that energy.
void expect_sense(const CustomLaw& law, double depth) {
  constexpr double step = 1e-3, rough = 0.01;  // a kink between the two depths leaves a part of it
  const double force = law.force(depth, 0).value;
  if (std::isnan(force)) refuse(law, depth, "its force is no number");
  if (!(force > 0))
    refuse(law, depth, "its force does not push, though it stores more energy the deeper it is");
  if (law.dissipates() || law.branched()) return;
  const double low = (1 - step) * depth, high = (1 + step) * depth;
  const double slope = (law.stored_energy(high) - law.stored_energy(low)) / (high - low);
  if (std::abs(slope - force) <= rough * force) return;
  std::ostringstream numbers;
  numbers << "its force is " << force << " N, and the slope of its stored energy " << slope << " N";
  refuse(law, depth, numbers.str());
}

}  // namespace

double CustomLaw::natural_indentation(double energy) const {
  const double depth = where_reached([this](double at) { return stored_energy(at); }, energy, name());
  expect_sense(*this, depth);
  return depth;
}

Force smooth_force(const CustomLaw& law, double indentation, double rate) {
  return indentation >= 0 ? law.force(indentation, rate) : on_tangent(law.force(0, rate), indentation);
}

Force load(const CustomLaw& law, double indentation, double rate) {
  return indentation >= 0 ? law.load(indentation, rate) : on_tangent(law.load(0, rate), indentation);
}

std::optional<double> find_static_indentation(const CustomLaw& law, double force) {
  const auto at_rest = [&](double depth) {
    const auto* branched = law.branched();
    return branched ? branched->force(loaded_first(*branched, depth), depth, 0).value
                    : law.force(depth, 0).value;
  };
  return if_reached(at_rest, force);
}

SharedLaw in_units(const SharedLaw& law, const Scale& scale) {
  if (const auto* branched = law->branched()) return in_units(*branched, law, scale);
  return std::make_shared<ScaledLaw>(law, scale);
}

}  // namespace mariotte::contact
