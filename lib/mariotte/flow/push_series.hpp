// The motion of the contacts that carry force in a step, as power series.
#pragma once
#include <array>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::flow {

inline constexpr int most_orders = 20;
/// Coefficients by order, with room for registers of up to eight that are whole.
using PushPolynomial = std::array<double, 24>;

/// Contacts of power laws in a clock σ that starts at 0:
///   dt/dσ = `pace`,   δ, δ̇ and, with n = 1 or 3/2, δⁿ⁻¹ are polynomials of σ.
/// Or, where contacts start from δ = 0 (`power` > 0), in z = t^power:
///   δ = t Σ d_k zᵏ,   √δ = √t Σ r_k zᵏ.
struct PushSeries {
  struct Contact {
    Index gap;  ///< its place in the state
    bool owns_clock = false;
    bool is_curved = false;  ///< n = 3/2
    PushPolynomial depth, rate, root;
  };
  int order = 0;          ///< of δ and δ̇; the root is known to one less
  double end = 0;         ///< of σ, or of t
  double power = 0;       ///< of t in z
  bool is_time = true;    ///< σ is time
  bool has_roots = true;  ///< all exponents are 1 or 3/2
  PushPolynomial pace{};
  std::vector<Contact> contact;
  std::vector<Contact>
      dozing;  ///< so shallow that their force is left out: depths and rates; none at a start
};

/// Leave out the motion before `begin` of σ, which starts again at 0 there. Not for those with a power; what
/// dozes stays.
void drop(PushSeries& series, double begin);

}  // namespace mariotte::flow
