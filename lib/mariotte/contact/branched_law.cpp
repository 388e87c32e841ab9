#include "mariotte/contact/branched_law.hpp"

#include <cmath>
#include <utility>

namespace mariotte::contact {
namespace {

/// f(δ L, δ̇ V) in the unit of force, with what is remembered in the unit of length.
class ScaledBranches final : public BranchedLaw {
 public:
  ScaledBranches(const BranchedLaw& law, SharedLaw owner, const Scale& scale)
      : law_(law), owner_(std::move(owner)), scale_(scale) {}

  std::string_view name() const override { return law_.name(); }
  Force force(const Memory& past, double indentation, double rate) const override {
    const auto f = law_.force(stated(past), indentation * scale_.length, rate * scale_.velocity);
    const double unit = scale_.force();
    return {.value = f.value / unit,
            .by_indentation = f.by_indentation * (scale_.length / unit),
            .by_rate = f.by_rate * (scale_.velocity / unit)};
  }
  double stored_energy(const Memory& past, double indentation) const override {
    return law_.stored_energy(stated(past), indentation * scale_.length) / scale_.energy();
  }
  double closing_indentation(const Memory& past) const override {
    return law_.closing_indentation(stated(past)) / scale_.length;
  }
  double opening_indentation(const Memory& past) const override {
    return law_.opening_indentation(stated(past)) / scale_.length;
  }
  /// Where it has yielded before it yields again, to the last digit.
  double yield_indentation(const Memory& past) const override {
    return past.peak > 0 ? past.peak : law_.yield_indentation(past) / scale_.length;
  }
  double plastic_loss(double peak) const override {
    return law_.plastic_loss(peak * scale_.length) / scale_.energy();
  }
  std::optional<ShiftedPower> power(const Memory& past) const override {
    auto power = law_.power(stated(past));
    if (!power) return power;
    power->stiffness *= std::pow(scale_.length, power->exponent) / scale_.force();
    power->origin /= scale_.length;
    const double q = damping_exponent(power->grows, power->exponent);
    power->damping *= std::pow(scale_.length, q) * scale_.velocity / scale_.force();
    power->pull /= scale_.force();
    return power;
  }
  /// u in the root of the unit of length.
  std::optional<WidthBranch> width_branch(const Memory& past) const override {
    auto branch = law_.width_branch(stated(past));
    if (!branch) return branch;
    const double width = std::sqrt(scale_.length);
    branch->curve.radius /= scale_.length;
    branch->curve.s /= width;
    branch->curve.origin /= scale_.length;
    double unit = 1 / scale_.force();
    for (double& push : branch->push) push *= std::exchange(unit, unit * width);
    branch->damping *= scale_.length * scale_.velocity / scale_.force();
    return branch;
  }
  std::optional<BrachDunn> adhesive_tip() const override {
    auto tip = law_.adhesive_tip();
    if (!tip) return tip;
    const double per_root = std::sqrt(scale_.length) / scale_.force();
    tip->stiffness *= per_root * scale_.length;
    tip->adhesion *= per_root;
    tip->damping_hertz *= scale_.velocity;
    tip->damping_adhesion *= scale_.velocity;
    return tip;
  }
  std::optional<double> rest_indentation(const Memory& past) const override {
    auto rest = law_.rest_indentation(stated(past));
    if (rest) *rest /= scale_.length;
    return rest;
  }
  bool pulls() const override { return law_.pulls(); }
  bool adheres() const override { return law_.adheres(); }
  bool watches_turns() const override { return law_.watches_turns(); }
  bool is_damped() const override { return law_.is_damped(); }
  double natural_indentation(double energy) const override {
    return law_.natural_indentation(energy * scale_.energy()) / scale_.length;
  }
  std::vector<LawParameter> parameters() const override { return law_.parameters(); }

 private:
  Memory stated(Memory past) const {
    past.peak *= scale_.length;
    return past;
  }

  const BranchedLaw& law_;
  SharedLaw owner_;
  Scale scale_;
};

}  // namespace

void begin(Memory& past, const BranchedLaw& law) {
  past.recedes = false;
  const double from = law.closing_indentation(past);
  if (past.peak > 0)
    past.branch = Branch::unloading;
  else
    past.branch = law.yield_indentation(past) <= from ? Branch::plastic : Branch::elastic;
  if (law.pulls()) past.adhesion_loss -= law.stored_energy(past, from);
}

void end(Memory& past, const BranchedLaw& law) {
  if (law.pulls()) past.adhesion_loss += law.stored_energy(past, law.opening_indentation(past));
}

void yield(Memory& past) {
  past.branch = Branch::plastic;
  past.recedes = false;
}

void turn(Memory& past, const BranchedLaw& law, double indentation) {
  past.recedes = !past.recedes;
  if (past.recedes && past.branch == Branch::plastic) {
    past.branch = Branch::unloading;
    past.peak = indentation;
  } else if (!past.recedes && indentation >= law.yield_indentation(past)) {
    past.branch = Branch::plastic;
  }
}

SharedLaw in_units(const BranchedLaw& law, const SharedLaw& owner, const Scale& scale) {
  return std::make_shared<ScaledBranches>(law, owner, scale);
}

}  // namespace mariotte::contact
