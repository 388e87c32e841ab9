// Two bodies in one closed contact, nothing else acting: δ(t) in closed form.
#pragma once
#include <variant>

#include "mariotte/flow/pair/indentation.hpp"
#include "mariotte/flow/pair/width_motion.hpp"

namespace mariotte::flow {

/// A contact f = k δⁿ (undamped, n = 1 or 3/2) or f = k δ + c δ̇ between two bodies of reduced mass m*.
struct PairLaw {
  double stiffness;                    ///< k
  double damping;                      ///< c, 0 unless n = 1
  double exponent;                     ///< n
  double reduced_mass;                 ///< m*
  const WidthBranch* width = nullptr;  ///< the force, where it is that
};

/// δ̈ = −(k/m*) δ^{3/2}. With y = −δ̇/w∞ and w∞² = δ̇² + (4/5)(k/m*) δ^{5/2}:
///   δ = δ_m (1−y²)^{2/5},  t = τ [T(y) − T(y₀)],  T(y) = ∫₀^y (1−u²)^{−3/5} du.
class HertzMotion {
 public:
  HertzMotion(const PairLaw& law, const Indentation& start);
  double duration() const;
  double turn() const { return y_start_ < 0 ? -tau_ * start_time_ : 0; }  ///< time of largest indentation
  Reached reach(double depth) const;   ///< where it is so deep on its way in
  Reached recede(double speed) const;  ///< where it parts so fast
  Reached opening() const { return {duration(), at(duration())}; }
  Indentation at(double time) const;
  Reached meet(const ConcaveGap& gap) const;  ///< where the gap falls through zero
  double fall(const ConcaveGap& gap) const { return meet(gap).time; }

 private:
  struct Place {
    double y, z, ratio;  ///< y, 1 − y², δ/δ_m
  };
  Place from_y(double y) const;
  Place from_ratio(double ratio, double side = 1) const;  ///< y has the sign of `side`
  double time(const Place& place) const;
  double value(const ConcaveGap& gap, const Place& place) const;

  double speed_, depth_, tau_, start_depth_;  ///< w∞, δ_m, τ, δ(0)
  double y_start_, start_time_;               ///< y₀, T(y₀)
};

/// δ̈ = −ω² δ: δ = (w∞/ω) cos θ, δ̇ = −w∞ sin θ, θ = θ₀ + ω t.
class LinearMotion {
 public:
  LinearMotion(const PairLaw& law, const Indentation& start);
  double duration() const;
  double turn() const;
  Reached reach(double depth) const;
  Reached recede(double speed) const;
  Reached opening() const { return {duration(), at(duration())}; }
  Indentation at(double time) const;
  double fall(const ConcaveGap& gap) const;

 private:
  double frequency_, angle_, speed_;
};

/// δ̈ + 2 b δ̇ + ω² δ = 0, to the instant at which the force, and with it δ̈, is zero.
class DampedMotion {
 public:
  DampedMotion(const PairLaw& law, const Indentation& start);
  double duration() const { return duration_; }
  double turn() const { return duration_; }  ///< not looked for: a step's observer finds both peaks
  Reached reach(double) const { return {infinity, start_}; }  ///< no branch has a damper
  Reached recede(double) const { return {infinity, start_}; }
  Reached opening() const { return {duration(), at(duration())}; }
  Indentation at(double time) const;
  double fall(const ConcaveGap& gap) const;

 private:
  double find_duration() const;

  /// Sines, hyperbolic sines, or two exponentials: each where it keeps its digits.
  enum class Form { oscillating, creeping, stiff };

  Indentation start_;
  double decay_, square_, split_;  ///< b, ω², √|ω²−b²|
  Form form_;
  double duration_;
};

/// A pair by whichever closed form it has.
using PairMotion = std::variant<HertzMotion, LinearMotion, DampedMotion, WidthMotion>;

/// The closed form of this law.
PairMotion make_pair_motion(const PairLaw& law, const Indentation& start);

}  // namespace mariotte::flow
