// Two springs, k₁ for loading and k₂ ≥ k₁ for unloading: f = k₁ δ, and k₂ (δ − δ_p) below the largest
// indentation δ* with the dent δ_p = δ* (1 − k₁/k₂) [Walton & Braun 1986, J Rheol 30:949]. A pair has the
// restitution √(k₁/k₂) at every speed.
#pragma once
#include "mariotte/contact/stated_law.hpp"
#include "mariotte/core/error.hpp"

namespace mariotte::contact {

struct WaltonBraun : YieldingStatement {
  static constexpr std::string_view name = "walton-braun";
  double loading;    ///< k₁ [N/m]
  double unloading;  ///< k₂ [N/m]

  WaltonBraun(double k1, double k2) : loading(k1), unloading(k2) {
    expect_numbers(name, parameters());
    if (k2 < k1)
      throw InvalidParameter("walton-braun: unloading_stiffness must not be below loading_stiffness");
  }
  double dent(double peak) const { return peak * ((unloading - loading) / unloading); }

  template <class T>
  T force(const Memory& past, const T& indentation, const T&) const {
    if (past.branch != Branch::unloading) return loading * indentation;
    return unloading * (indentation - T(dent(past.peak)));
  }
  std::optional<ShiftedPower> power(const Memory& past) const {
    if (past.branch != Branch::unloading) return ShiftedPower{loading, 1, 0};
    return ShiftedPower{unloading, 1, dent(past.peak)};
  }
  double stored_energy(const Memory& past, double d) const {
    const double peak = past.branch == Branch::unloading ? past.peak : d, left = d - dent(peak);
    return 0.5 * unloading * left * left;
  }
  double closing_indentation(const Memory& past) const { return dent(past.peak); }
  double yield_indentation(const Memory&) const { return 0; }
  double plastic_loss(double peak) const { return 0.5 * loading * peak * dent(peak); }
  std::vector<LawParameter> parameters() const {
    return {{"loading_stiffness", loading}, {"unloading_stiffness", unloading}};
  }
};

}  // namespace mariotte::contact
