// A contact as the flows see it that need more than a field.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "mariotte/core/cubic_curve.hpp"
#include "mariotte/core/damping.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/core/width_branch.hpp"

namespace mariotte::flow {

/// What a contact does in a phase.
enum class Role : signed char {
  open,      ///< carries no force; closes where its gap is −level
  closed,    ///< carries force
  touching,  ///< carries force; touched at rest before, and is watched once it has left the noise
  slack      ///< indented without force
};

/// f = k δⁿ + c δ^q δ̇ − a δⁿ⁻¹ + b δⁿ⁻¹ δ̇ − P, and where its quantities stand in the state. A contact of
/// another law is open, and has no numbers.
struct PhaseContact {
  Index gap;
  Index work;        ///< ∫ f δ̇ dt, or −1
  Index impulse;     ///< ∫ f dt, or −1
  Index guard;       ///< of the gap
  Index load_guard;  ///< of k δ^{n−q} + c δ̇, or −1
  double stiffness, damping, exponent;
  Damping grows = Damping::as_slope;  ///< q
  double length;                      ///< natural indentation
  double noise_depth;                 ///< indentation that cannot be told from rounding
  double level = 0;
  // Of a branch of a law; as here for any other contact.
  double origin = 0;         ///< indentation from which the power is taken
  Index branch_guard = -1;   ///< of the indentation at which it yields, before that of its turns; or −1
  double yields = infinity;  ///< indentation at which it does, where that is watched
  double turn_side = 0;      ///< sign that δ̇ is to keep but for `turn_speed`, or 0
  double turn_speed = 0;
  double pull = 0;                     ///< P
  double ring = 0;                     ///< a, of a ring of adhesion
  double ring_damping = 0;             ///< b
  const WidthBranch* width = nullptr;  ///< the force, where it is that and no power
  const CubicCurve* curve = nullptr;   ///< likewise
  Role role = Role::open;

  /// f = kδ + c δ̇, cut off where it would pull.
  bool is_linear() const {
    return exponent == 1 && !curve && (damping == 0 || (grows == Damping::as_slope && load_guard >= 0));
  }
  /// Its load may be positive still where its indentation ends; that of any other falls before, or with it.
  bool opens_loaded() const { return load_guard < 0 || grows == Damping::as_force; }
  /// Its damping over its elastic force, indented by its length, at a rate.
  double damping_share(double rate) const {
    if (damping == 0) return 0;
    return damping * rate / (stiffness * std::pow(length, exponent - damping_exponent(grows, exponent)));
  }
  bool pushes() const { return role == Role::closed || role == Role::touching; }
  /// Less deep, and slow, it has let go: well above where it would close again.
  double faded() const { return 0.5 * noise_depth; }
  /// Indentation from which a contact touched at rest is watched: out of the noise.
  double loaded() const { return 2 * noise_depth; }
};

/// All forces are those of linear contacts from δ = 0 on.
inline bool are_linear(const std::vector<PhaseContact>& contacts) {
  const auto is_straight = [](const auto& c) {
    return c.role == Role::open || (c.is_linear() && c.branch_guard < 0);
  };
  return std::all_of(contacts.begin(), contacts.end(), is_straight);
}

}  // namespace mariotte::flow
