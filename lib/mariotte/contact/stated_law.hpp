// Laws with branches, each stated once: its force as a template over the number, and what else is not usual.
//
//   struct Spring : LawStatement {
//     static constexpr std::string_view name = "spring";
//     double stiffness;
//     template <class T>
//     T force(const Memory&, const T& indentation, const T& rate) const { return stiffness * indentation; }
//     double stored_energy(const Memory&, double d) const { return stiffness * d * d / 2; }
//     std::vector<LawParameter> parameters() const { return {{"stiffness", stiffness}}; }
//   };
//   Law law = state(Spring{.stiffness = 3});
#pragma once
#include <utility>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/contact/law.hpp"
#include "mariotte/series/dual.hpp"

namespace mariotte::contact {

/// What most laws have in common; BranchedLaw says what each means.
struct LawStatement {
  double closing_indentation(const Memory&) const { return 0; }
  double yield_indentation(const Memory&) const { return infinity; }
  double plastic_loss(double) const { return 0; }
  std::optional<ShiftedPower> power(const Memory&) const { return std::nullopt; }
  std::optional<WidthBranch> width_branch(const Memory&) const { return std::nullopt; }
  std::optional<BrachDunn> adhesive_tip() const { return std::nullopt; }
  std::optional<double> rest_indentation(const Memory&) const { return std::nullopt; }
  bool adheres() const { return false; }
  bool pulls() const { return false; }
  bool watches_turns() const { return false; }
  bool is_damped() const { return false; }
};

/// A law that yields: plastic where it is deeper than ever, and elastic about its dent.
struct YieldingStatement : LawStatement {
  bool watches_turns() const { return true; }
};

/// A law that holds bodies together.
struct AdhesiveStatement : LawStatement {
  bool adheres() const { return true; }
  bool pulls() const { return true; }
  bool watches_turns() const { return true; }
};

/// A statement as the library's law; slopes come from the force itself.
template <class Statement>
class StatedLaw final : public BranchedLaw {
 public:
  explicit StatedLaw(Statement statement) : law_(std::move(statement)) {}

  std::string_view name() const override { return law_.name; }
  Force force(const Memory& past, double indentation, double rate) const override {
    using Number = series::Dual<double, 2>;
    const Number f = law_.force(past, Number(indentation, {1, 0}), Number(rate, {0, 1}));
    return {.value = f.value, .by_indentation = f.slope[0], .by_rate = f.slope[1]};
  }
  double stored_energy(const Memory& past, double indentation) const override {
    return law_.stored_energy(past, indentation);
  }
  double closing_indentation(const Memory& past) const override { return law_.closing_indentation(past); }
  double opening_indentation(const Memory& past) const override {
    if constexpr (requires { law_.opening_indentation(past); })
      return law_.opening_indentation(past);
    else
      return law_.closing_indentation(past);
  }
  double yield_indentation(const Memory& past) const override {
    return past.peak > 0 ? past.peak : law_.yield_indentation(past);
  }
  double plastic_loss(double peak) const override { return law_.plastic_loss(peak); }
  std::optional<ShiftedPower> power(const Memory& past) const override { return law_.power(past); }
  std::optional<WidthBranch> width_branch(const Memory& past) const override {
    return law_.width_branch(past);
  }
  std::optional<BrachDunn> adhesive_tip() const override { return law_.adhesive_tip(); }
  std::optional<double> rest_indentation(const Memory& past) const override {
    return law_.rest_indentation(past);
  }
  double natural_indentation(double energy) const override {
    if constexpr (requires { law_.natural_indentation(energy); })
      return law_.natural_indentation(energy);
    else
      return BranchedLaw::natural_indentation(energy);
  }
  bool pulls() const override { return law_.pulls(); }
  bool adheres() const override { return law_.adheres(); }
  bool watches_turns() const override { return law_.watches_turns(); }
  bool is_damped() const override { return law_.is_damped(); }
  std::vector<LawParameter> parameters() const override { return law_.parameters(); }

 private:
  Statement law_;
};

/// A statement as a law of a contact.
template <class Statement>
Law state(Statement statement) {
  return SharedLaw(std::make_shared<StatedLaw<Statement>>(std::move(statement)));
}

/// Whether the contact is, or would be, plastic at an indentation.
inline bool is_plastic(const Memory& past, double indentation, double yield_indentation) {
  return past.branch == Branch::plastic ||
         (past.branch == Branch::elastic && indentation > yield_indentation);
}

/// Throw unless every number is positive and finite, and the dampings not negative.
void expect_numbers(std::string_view law, const std::vector<LawParameter>& parameters);

}  // namespace mariotte::contact
