// The field of bodies in contact, written once: T is a number, or a value with slopes, which gives Jacobian
// and rates of guards. N is what the setting has: if these have slopes, so has all that follows from them.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/core/mindlin.hpp"
#include "mariotte/model/bodies/bodies_loads.hpp"
#include "mariotte/model/bodies/bodies_mode.hpp"
#include "mariotte/model/bodies/bodies_stick.hpp"
#include "mariotte/model/bodies/law_numbers.hpp"
#include "mariotte/model/bodies/recorded_law.hpp"

namespace mariotte::model {

/// A closed contact at one instant.
template <class T, int D>
struct ContactForces {
  ContactMotion<T, D> motion;
  T normal;             ///< f_n
  T elastic;            ///< of it, what it would be at δ̇ = 0
  Vec<T, D> friction;   ///< on b
  Vec<T, D> direction;  ///< of slip, or e of a spring that slips
  T spring;             ///< k_t
};

/// What a state leads to: motion, forces, accelerations.
template <class T, int D, class N = double>
class BodiesField {
 public:
  using Vector = Vec<T, D>;
  using Contact = SettingContact<D, N>;

  explicit BodiesField(const BodiesSetting<D, N>& setting) : setting_(setting), loads_(setting) {}
  const BodiesSetting<D, N>& setting() const { return setting_; }

  /// Evaluate at x. Throws nothing; a redundant stick gets the least friction that does.
  void evaluate(const BodiesLayout<D>& layout, const BodiesMode& mode, std::span<const T> x) {
    layout_ = layout;
    loads_.move(layout, x);
    closed_.resize(mode.closed.size());
    stuck_.clear();
    for (std::size_t i = 0; i < closed_.size(); ++i) set_forces(mode.closed[i], x, closed_[i], i);
    accelerate();
    if (!stuck_.empty()) set_stick();
  }

  const ContactForces<T, D>& contact(std::size_t i) const { return closed_[i]; }
  const BodyMotion<T, D>& body(Index i) const { return loads_.body()[i]; }
  /// True if the last evaluation left friction undetermined: the contacts that stick are redundant.
  bool is_redundant() const { return redundant_; }

  ContactMotion<T, D> motion(Index contact) const { return loads_.motion(contact); }
  GapMotion<T, D> approach(Index contact) const { return loads_.approach(contact); }
  Vector slip_acceleration(Index contact, const ContactMotion<T, D>& c) const {
    return loads_.slip_acceleration(contact, c);
  }

  /// Where a slip from rest goes, if that has slopes; else its mode says so.
  void set_start(Index slot, const std::optional<Vector>& way) {
    if (slot >= std::ssize(start_)) start_.resize(slot + 1);
    start_[slot] = way;
  }

  /// Rates of the whole state.
  void rates(const BodiesMode& mode, std::span<const T> x, std::span<T> dx) const {
    for (Index i = 0; i < layout_.bodies; ++i) put_body_rates(i, x, dx);
    dx[layout_.clock()] = T(1.0);
    for (Index k = layout_.spring(0); k < layout_.size(); ++k) dx[k] = T(0.0);
    for (std::size_t i = 0; i < closed_.size(); ++i) put_contact_rates(mode.closed[i], closed_[i], x, dx);
  }

  /// Rate λ̇ at which a spring that slips gives way; negative once it would hold.
  T yielding(const ClosedContact& mode, const ContactForces<T, D>& c) const {
    const auto& one = setting_.contact[mode.contact];
    const T approach = -c.motion.gap_rate;
    const T tangential = dot(c.motion.slip, c.direction);
    const N mu = one.tangential.friction;
    if (is_past(c)) return tangential;
    if (is_proportional(one) && !mode.slack)
      return mindlin_yielding(tangential, mu * ratio(one), approach, mode.unloading);
    T rate = tangential - mu * (force_rate(mode, c) / c.spring);
    if (one.tangential.law == TangentialLaw::mindlin && mode.unloading)
      rate = rate + 0.5 * mu * ((c.normal / c.spring) * (approach / c.motion.indentation));
    return rate;
  }

  /// ḟ_n, which for a damped contact depends on all accelerations.
  T force_rate(const ClosedContact& mode, const ContactForces<T, D>& c) const {
    const auto& one = setting_.contact[mode.contact];
    if (mode.slack) return T(0.0);
    const T rate = -c.motion.gap_rate;
    const auto slopes = slopes_of(mode, one, c.motion.indentation, rate);
    if (!contact::is_damped(one.law)) return slopes.by_indentation * rate;
    return slopes.by_indentation * rate - slopes.by_rate * loads_.gap_acceleration(mode.contact, c.motion);
  }

  /// A contact that sticks rigidly, and its place among those that are closed.
  struct Stuck {
    std::size_t place;
    Index contact;
  };
  const std::vector<Stuck>& stuck() const { return stuck_; }
  /// Impulses on b at each of these that together take away the slips `left(contact)`.
  template <class Left>
  const std::vector<Vector>& stopping(Left&& left) {
    for (std::size_t i = 0; i < stuck_.size(); ++i) still_[i].slip_rate = left(stuck_[i].contact);
    hold();
    return holding_;
  }

  /// The law of a closed contact, on a tape.
  RecordedForce recorded(const ClosedContact& mode, const Contact& one, const T& depth, const T& rate) const {
    return recorded_force(one.law, mode.past, depth, rate, setting_.onset_noise * one.length);
  }

  /// Add a force on b at a closed contact, and its opposite on a.
  void push(std::size_t i, Index contact, const Vector& force) {
    loads_.push(contact, closed_[i].motion, force);
  }
  /// Accelerations from the forces pushed so far.
  void accelerate() { loads_.accelerate(); }

 private:
  /// Linear forces, and those with branches, go on past zero, so that a step which reaches beyond separation
  /// meets no kink.
  T depth_of(const Contact& one, const ContactMotion<T, D>& c) const {
    if constexpr (is_recorded<T>) return c.indentation;
    return contact::branched(one.law) || contact::is_linear(one.law) ? T(-c.gap) : c.indentation;
  }

  /// Elastic force and stiffness k_t of the same power of δ: f_n/k_t = ratio δ.
  static bool is_proportional(const Contact& one) {
    const auto* power = contact::power_law(one.law);
    return one.tangential.law == TangentialLaw::mindlin && power && power->exponent == 1.5 &&
           power->damping == 0;
  }
  static N ratio(const Contact& one) { return one.numbers.stiffness / one.tangential.stiffness; }

  /// True beyond separation, where a step may look but nothing is kept: stiffnesses that grow with δ are 0.
  bool is_past(const ContactForces<T, D>& c) const {
    return !is_recorded<T> && !(c.motion.indentation > setting_.smallest_indentation);
  }

  /// Force of either sign.
  T force_of(const ClosedContact& mode, const Contact& one, const T& depth, const T& rate) const {
    if constexpr (is_recorded<T>)
      return recorded(mode, one, depth, rate).value;
    else
      return law_force<T>(one, mode.past, depth, rate);
  }
  LawSlopes<T> slopes_of(const ClosedContact& mode, const Contact& one, const T& depth, const T& rate) const {
    if constexpr (is_recorded<T>) {
      const auto f = recorded(mode, one, depth, rate);
      return {f.by_indentation, f.by_rate};
    } else {
      return law_slopes<T>(one, mode.past, depth, rate);
    }
  }

  void set_forces(const ClosedContact& mode, std::span<const T> x, ContactForces<T, D>& c,
                  std::size_t place) {
    const auto& one = setting_.contact[mode.contact];
    c.motion = motion(mode.contact);
    const T depth = depth_of(one, c.motion), rate = -c.motion.gap_rate;
    const bool lets_go = mode.slack && !contact::pulls(one.law);
    c.elastic = contact::is_damped(one.law) || lets_go ? force_of(mode, one, depth, T(0.0)) : T(0.0);
    c.normal = lets_go ? T(0.0) : force_of(mode, one, depth, rate);
    c.friction = lift<T>(Vec<double, D>{});
    c.direction = c.friction;
    set_spring(one, c);
    set_friction(mode, one, x, c, place);
    loads_.push(mode.contact, c.motion, c.normal * c.motion.normal + c.friction);
  }

  void set_spring(const Contact& one, ContactForces<T, D>& c) const {
    using std::sqrt;
    const bool grows = one.tangential.law == TangentialLaw::mindlin;
    c.spring = grows ? T(one.tangential.stiffness * sqrt(c.motion.indentation)) : T(one.tangential.stiffness);
  }

  void set_friction(const ClosedContact& mode, const Contact& one, std::span<const T> x,
                    ContactForces<T, D>& c, std::size_t place) {
    if (mode.slack || mode.friction == Friction::none) return;
    if (mode.friction == Friction::slip) {
      c.direction = slip_direction(mode, one, x, c.motion);
      c.friction = (-(one.tangential.friction * c.normal)) * c.direction;
    } else if (one.tangential.has_spring()) {
      const bool as_force = one.tangential.law == TangentialLaw::mindlin && !mode.unloading;
      const Vector state = tangential_state(mode, x, c.motion.normal);
      c.friction = (as_force ? T(-1.0) : T(-c.spring)) * state;
    } else {
      stuck_.push_back({place, mode.contact});
    }
  }

  /// T, ξ or e of a slot as a vector in the tangent plane.
  Vector tangential_state(const ClosedContact& mode, std::span<const T> x, const Vector& normal) const {
    const Index at = layout_.spring(mode.slot);
    if constexpr (D == 2)
      return x[at] * across(normal);
    else {
      const auto state = vec_at<3>(x, at);
      return state - dot(state, normal) * normal;
    }
  }

  /// A slip from rest keeps its first direction until it has one of its own. What was left of the slip before
  /// does not count: it may be opposite, and the direction would turn about at once.
  Vector beside_first(const ClosedContact& mode, const Vector& slip) const {
    const double speed = setting_.rest_speed();
    Vector first, rest;
    for (int k = 0; k < D; ++k) {
      first[k] = T(mode.start[k]);
      rest[k] = T(mode.rest.empty() ? 0.0 : mode.rest[k]);
    }
    if (mode.slot < std::ssize(start_) && start_[mode.slot]) first = *start_[mode.slot];
    const Vector gone = slip - rest;
    const T share = 1.0 / (1.0 + 1 / (speed * speed) * dot(gone, gone));
    return slip + share * (T(speed) * first - rest);
  }

  /// The slip without what rounding has left of it along the normal: that may be much beside a slip that
  /// comes to rest.
  static Vector in_plane(const ContactMotion<T, D>& c) { return c.slip - dot(c.slip, c.normal) * c.normal; }

  Vector slip_direction(const ClosedContact& mode, const Contact& one, std::span<const T> x,
                        const ContactMotion<T, D>& c) const {
    if constexpr (D == 2)
      return T(mode.sign) * across(c.normal);
    else {
      Vector along = one.tangential.has_spring() ? tangential_state(mode, x, c.normal) : in_plane(c);
      if (!mode.start.empty() && (mode.from_rest || !(dot(along, along) > 0.0)))
        along = beside_first(mode, along);
      const T size = norm(along);
      return size > 0.0 ? (1.0 / size) * along : along;
    }
  }

  /// Friction of all contacts that stick rigidly.
  void set_stick() {
    still_.clear();
    for (const auto& [place, contact] : stuck_) {
      const auto& one = setting_.contact[contact];
      const auto& c = closed_[place].motion;
      const Index a = one.plane < 0 ? setting_.sphere[one.a].body : Index{-1};
      still_.push_back({.tangents = tangents(c.normal),
                        .side = {{{setting_.sphere[one.b].body, c.lever_b, 1.0}, {a, c.lever_a, -1.0}}},
                        .slip_rate = slip_acceleration(contact, c)});
    }
    hold();
    for (std::size_t i = 0; i < stuck_.size(); ++i) {
      auto& c = closed_[stuck_[i].place];
      c.friction = c.friction + holding_[i];
      loads_.push(stuck_[i].contact, c.motion, c.friction);
    }
    accelerate();
  }

  void hold() {
    redundant_ = !hold_still<T>(setting_, std::span<const BodyMotion<T, D>>(loads_.body()),
                                std::span<const StuckContact<T, D>>(still_), holding_);
  }

  void put_body_rates(Index i, std::span<const T> x, std::span<T> dx) const {
    put(dx, layout_.shift(i), body(i).velocity);
    put(dx, layout_.velocity(i), loads_.velocity_rate(i));
    if constexpr (D == 2) {
      dx[layout_.turn(i)] = body(i).spin[0];
      dx[layout_.momentum(i)] = loads_.spin_rate(i)[0];
    } else {
      const auto& w = body(i).spin;
      mariotte::put<T>(
          dx, layout_.turn(i),
          quaternion_rate(quaternion_at<T>(x, layout_.turn(i)), BasicVector3<T>{w[0], w[1], w[2]}));
      put(dx, layout_.momentum(i), loads_.moment(i));
    }
  }

  void put_contact_rates(const ClosedContact& mode, const ContactForces<T, D>& c, std::span<const T> x,
                         std::span<T> dx) const {
    const auto& one = setting_.contact[mode.contact];
    put_spring_rate(mode, one, c, x, dx);
    dx[layout_.normal(mode.slot)] = c.normal;
    if constexpr (D == 2)
      dx[layout_.tangential(mode.slot)] = dot(c.friction, across(c.motion.normal));
    else
      put(dx, layout_.tangential(mode.slot), c.friction);
    const Index loss = layout_.losses(mode.slot);
    dx[loss] = friction_power(mode, one, c);
    dx[loss + 1] = rescale_power(mode, one, c);
    if (contact::is_damped(one.law)) dx[loss + 2] = (c.normal - c.elastic) * (-c.motion.gap_rate);
  }

  T friction_power(const ClosedContact& mode, const Contact& one, const ContactForces<T, D>& c) const {
    if (mode.friction != Friction::slip || mode.slack) return T(0.0);
    if (!one.tangential.has_spring()) return -dot(c.friction, c.motion.slip);
    if (is_past(c)) return T(0.0);
    return one.tangential.friction * c.normal * yielding(mode, c);
  }

  /// T² |k̇_t|/2 k_t²: what changes of the stiffness cost, both ways.
  T rescale_power(const ClosedContact& mode, const Contact& one, const ContactForces<T, D>& c) const {
    if (one.tangential.law != TangentialLaw::mindlin || mode.slack || is_past(c)) return T(0.0);
    const T rate = mode.unloading ? c.motion.gap_rate : T(-c.motion.gap_rate);
    return 0.25 * ((dot(c.friction, c.friction) / c.spring) * rate / c.motion.indentation);
  }

  void put_spring_rate(const ClosedContact& mode, const Contact& one, const ContactForces<T, D>& c,
                       std::span<const T> x, std::span<T> dx) const {
    if (!one.tangential.has_spring() || mode.slack || mode.friction == Friction::none) return;
    const Index at = layout_.spring(mode.slot);
    const bool as_force = one.tangential.law == TangentialLaw::mindlin && !mode.unloading;
    const T rate = as_force ? c.spring : T(1.0);
    if constexpr (D == 2) {
      if (mode.friction == Friction::stick) dx[at] = rate * dot(c.motion.slip, across(c.motion.normal));
    } else {
      const auto state = vec_at<3>(x, at);
      Vector change = mode.friction == Friction::stick ? rate * c.motion.slip : turning_to_slip(one, c);
      put(dx, at, change + turned(frame_spin(one, c.motion), state));
    }
  }

  /// ė = (u − (u·e) e)/|ξ|, where |ξ| is no shorter than what a force too faint to matter has: as that fades,
  /// e would turn ever faster, and by rounding.
  Vector turning_to_slip(const Contact& one, const ContactForces<T, D>& c) const {
    const auto& u = c.motion.slip;
    const double faint = setting_.faint * one.fading_force();
    const T stretch = (one.tangential.friction * (c.normal > faint ? c.normal : T(faint))) / c.spring;
    const T least = 10 * setting_.faint * (one.fading_force() / one.force) * one.time * norm(u);
    const T length = stretch > series::value_of(least) ? stretch : least;
    if (!(length > 0.0)) return lift<T>(Vec<double, D>{});
    return (1.0 / length) * (u - dot(u, c.direction) * c.direction);
  }

  /// n × ṅ and half the spins about n.
  Vector frame_spin(const Contact& one, const ContactMotion<T, D>& c) const {
    auto spin = body(setting_.sphere[one.b].body).spin;
    if (one.plane < 0) spin = spin + body(setting_.sphere[one.a].body).spin;
    return turned(c.normal, c.normal_rate) + T(0.5 * dot(spin, c.normal)) * c.normal;
  }

  const BodiesSetting<D, N>& setting_;
  BodiesLayout<D> layout_;
  BodiesLoads<T, D, N> loads_;
  std::vector<ContactForces<T, D>> closed_;
  std::vector<Stuck> stuck_;
  std::vector<StuckContact<T, D>> still_;
  std::vector<Vector> holding_;               ///< friction of each
  std::vector<std::optional<Vector>> start_;  ///< by slot
  bool redundant_ = false;
};

}  // namespace mariotte::model
