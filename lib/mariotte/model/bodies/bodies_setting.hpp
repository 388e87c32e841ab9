// What does not change during a run of bodies: features and gaps at the start, laws, places in the state.
// N is a number, or a value with slopes by what the bodies are made from.
#pragma once
#include <algorithm>
#include <vector>

#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/model/bodies/bodies_mode.hpp"
#include "mariotte/model/bodies/vec.hpp"
#include "mariotte/series/dual.hpp"

namespace mariotte::model {

/// A body, D = 2 or 3.
template <int D, class N = double>
struct SettingBody {
  N mass;
  Vec<N, turns(D)> inertia;     ///< principal moments
  BasicQuaternion<N> attitude;  ///< at the start
  bool is_round;                ///< all moments are equal
  double reach = 0;             ///< to the farthest point of its spheres
  bool has_arms = false;        ///< a sphere is not at the mass centre: contacts feel how it has turned
  double push = 1;              ///< largest velocity that a contact can give it, over that of the other body
};

/// A sphere at the start, axes of space.
template <int D, class N = double>
struct SettingSphere {
  Index body;
  Vec<N, D> arm;  ///< from the mass centre
  N radius;
};

/// k and c of a power law; 0 of others.
template <class N>
struct LawNumbers {
  N stiffness = 0, damping = 0;
};

/// A pair that may touch. Displacements since the start are the state, so that gaps lose no digits.
template <int D, class N = double>
struct SettingContact {
  Index plane = -1;         ///< or −1
  Index a = -1, b = -1;     ///< spheres
  Vec<N, D> apart;          ///< from a to b at the start; the normal of a plane
  N distance = 0, gap = 0;  ///< at the start
  contact::Law law;
  LawNumbers<N> numbers = {};
  BasicTangential<N> tangential;
  N share = 0.5;
  // Natural sizes.
  double mass = 1, length = 1, time = 1, force = 1;

  /// Where the normal force is as small, friction is not: a large coefficient leaves it as much as there was.
  double fading_force() const { return force / std::max(1.0, series::value_of(tangential.friction)); }
  /// Of the centres of two spheres that touch: the sum of their radii, unless they were stated to touch.
  N touching_distance() const { return distance - gap; }
};

/// Places in the state: bodies, the clock, slots of closed contacts.
///   plane: per body y(2) φ v(2) ω;   slot: T or ξ, ∫f_n, ∫f_t, three losses
///   space: per body y(3) p(4) v(3) H(3);   slot: T, ξ or e (3), ∫f_n, ∫f_t (3), three losses
/// y is a displacement and p (φ) a turn since the start.
template <int D>
struct BodiesLayout {
  static constexpr Index tangents = D == 2 ? 1 : 3;
  static constexpr Index attitude = D == 2 ? 1 : 4;
  static constexpr Index body_size = 2 * D + attitude + turns(D);
  static constexpr Index slot_size = 2 * tangents + 4;

  Index bodies = 0, slots = 0;

  Index turn(Index i) const { return i * body_size + D; }
  Index shift(Index i) const { return i * body_size; }
  Index velocity(Index i) const { return turn(i) + attitude; }
  Index momentum(Index i) const { return velocity(i) + D; }  ///< in the plane the spin
  Index clock() const { return bodies * body_size; }
  Index spring(Index slot) const { return clock() + 1 + slot * slot_size; }
  Index normal(Index slot) const { return spring(slot) + tangents; }
  Index tangential(Index slot) const { return normal(slot) + 1; }
  Index losses(Index slot) const { return tangential(slot) + tangents; }  ///< friction, rescale, damper
  Index size() const { return spring(slots); }
};

/// Everything together.
template <int D, class N = double>
struct BodiesSetting {
  Vec<N, D> gravity;
  std::vector<SettingBody<D, N>> body;
  std::vector<SettingSphere<D, N>> sphere;
  std::vector<Vec<N, D>> plane_velocity;
  std::vector<SettingContact<D, N>> contact;
  double speed = 1;                      ///< what the accuracy is relative to
  double sag_speed = 0;                  ///< that gravity gives what starts on its contacts
  double length = 1, time = 1;           ///< shortest natural ones of all contacts
  double smallest_indentation = 0;       ///< stands for 0 where a ratio of forces is wanted
  double slip_noise = 0, gap_noise = 0;  ///< share of speed and length that is rounding
  double skin = 0;                       ///< gap up to which pairs are watched; 0: all are
  double onset_noise = 0;                ///< share of length within which contacts close together
  double faint = 0;                      ///< share of force below which its direction does not matter
  double rounding = 0;                   ///< share of length that has been lost on the way to contacts
  bool has_limit = false;                ///< in time: until there what friction holds is followed, too

  /// Slip in space below which a rigid contact is at rest.
  double rest_speed() const { return 100 * slip_noise * speed; }
  /// Share of force by which a rigid contact may exceed its cap where that has faded.
  double faint_stick() const { return std::max(slip_noise, 0.1 * faint); }
};

/// Displacements are counted from the start: of the way that a body has gone along a gap so large a share is
/// rounding, which its indentation loses.
inline constexpr double lost_digits = 16 * epsilon;

/// What has lost so large a share of its indentation to rounding has as much noise.
template <int D, class N>
void allow_rounding(BodiesSetting<D, N>& setting, double share) {
  setting.rounding = std::max(setting.rounding, share);
  for (double* noise : {&setting.slip_noise, &setting.gap_noise, &setting.onset_noise})
    *noise = std::max(*noise, setting.rounding);
}

/// Of validated bodies that are followed for a time at most; `accuracy` sets what counts as noise.
template <int D>
BodiesSetting<D> setting_of(const Bodies& bodies, double accuracy, double max_time = infinity);

/// Throws InvalidParameter (S035) where the way to the first contact leaves hardly a digit of an indentation.
template <int D>
void expect_digits(const BodiesSetting<D>& setting);
/// The same of validated bodies.
void expect_digits(const Bodies& bodies);

/// The state at the start, without slots.
template <int D>
std::vector<double> initial_state(const Bodies& bodies, const BodiesSetting<D>& setting);

/// Of the direction e of a slip: CVODE knows it far better than its forces need.
inline constexpr double direction_magnitude = 30;

/// Natural size of each component in a mode: an error of accuracy × size is what the user allows.
template <int D>
void set_magnitudes(const BodiesSetting<D>& setting, const BodiesLayout<D>& layout, const BodiesMode& mode,
                    std::vector<double>& magnitude);

}  // namespace mariotte::model
