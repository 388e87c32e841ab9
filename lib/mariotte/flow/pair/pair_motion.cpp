#include "mariotte/flow/pair/pair_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mariotte/core/bracket.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/flow/pair/hertz_time.hpp"

namespace mariotte::flow {
namespace {

double fifth_power_root(double z) {  // z^{2/5}
  return std::pow(z, 0.4);
}

double value_of(const ConcaveGap& gap, double time, double deepened) {
  return gap.value + gap.rate * time + gap.coupling * deepened;
}

/// Falling root of a gap in time, for motions known as functions of time. The gap rises at first if it
/// started from zero; its only falling root lies behind its maximum.
template <class Motion>
double fall_in_time(const Motion& motion, const ConcaveGap& gap, double duration) {
  if (gap.coupling == 0) return -gap.value / gap.rate;
  const double start = motion.at(0).value;
  const auto rate = [&](double time) { return gap.rate + gap.coupling * motion.at(time).rate; };
  const auto value = [&](double time) { return value_of(gap, time, motion.at(time).value - start); };
  const double first = rate(0), last = rate(duration);
  const double top =
      first > 0 && last < 0 ? locate_sign_change(rate, 0, first, duration, last, epsilon * duration) : 0;
  const double highest = value(top), lowest = value(duration);
  if (!(highest > 0)) return top;
  return locate_sign_change(value, top, highest, duration, lowest, epsilon * duration);
}

}  // namespace

double HertzMotion::duration() const {
  return tau_ * (full_hertz_time - start_time_);
}

HertzMotion::HertzMotion(const PairLaw& law, const Indentation& start)
    : start_depth_(std::max(0.0, start.value)) {
  const double spring = law.stiffness / law.reduced_mass;
  const double stored = 0.8 * spring * start_depth_ * start_depth_ * std::sqrt(start_depth_);
  const double energy = start.rate * start.rate + stored;
  speed_ = std::sqrt(energy);
  depth_ = fifth_power_root(energy / (0.8 * spring));
  tau_ = speed_ / (spring * depth_ * std::sqrt(depth_));
  y_start_ = -start.rate / speed_;
  start_time_ = time({y_start_, stored / energy, start_depth_ / depth_});
}

HertzMotion::Place HertzMotion::from_y(double y) const {
  const double z = (1 - y) * (1 + y);
  return {y, z, fifth_power_root(z)};
}

HertzMotion::Place HertzMotion::from_ratio(double ratio, double side) const {
  const double z = ratio * ratio * std::sqrt(ratio);
  return {std::copysign(std::sqrt(1 - z), side), z, ratio};
}

double HertzMotion::time(const Place& place) const {
  const double square = place.y * place.y;
  if (square <= 0.5) return place.y * from_middle(square);
  const double rest = full_hertz_time - 1.25 * place.ratio * from_end(place.z);
  return place.y > 0 ? rest : -rest;
}

Indentation HertzMotion::at(double elapsed) const {
  const double wanted = start_time_ + elapsed / tau_;
  if (wanted >= full_hertz_time) return {0, -speed_};
  const double early = time(from_y(hertz_middle));
  const auto found = [&](const Place& place) { return Indentation{depth_ * place.ratio, -speed_ * place.y}; };
  if (const double away = std::abs(wanted); away > early) {  // in δ/δ_m, smooth up to the opening
    const auto late = [&](double ratio) { return time(from_ratio(ratio)) - away; };
    const double ratio =
        locate_sign_change(late, 0, full_hertz_time - away, hertz_half_depth, early - away, epsilon);
    return found(from_ratio(ratio, wanted));
  }
  const auto late = [&](double y) { return time(from_y(y)) - wanted; };
  return found(from_y(
      locate_sign_change(late, -hertz_middle, -early - wanted, hertz_middle, early - wanted, epsilon)));
}

Reached HertzMotion::reach(double depth) const {
  if (y_start_ >= 0 || !(depth < depth_)) return {infinity, {}};
  const auto place = from_ratio(depth / depth_, -1);
  return {std::max(0.0, tau_ * (time(place) - start_time_)), {depth, -speed_ * place.y}};
}

Reached HertzMotion::recede(double speed) const {
  if (!(speed < speed_)) return {infinity, {}};
  const auto place = from_y(speed / speed_);
  return {std::max(0.0, tau_ * (time(place) - start_time_)), {depth_ * place.ratio, -speed}};
}

double HertzMotion::value(const ConcaveGap& gap, const Place& place) const {
  return value_of(gap, tau_ * (time(place) - start_time_), depth_ * place.ratio - start_depth_);
}

/// Behind its maximum, where δ̇ = −rate/coupling, in whichever of the three charts holds the root: by δ/δ_m
/// while the contact is shallow, on its way in and out, and by y between. In y the way in would be cut short:
/// one rounding error of y = −1 is 5e-7 of δ_m. In the charts dT is −(5/4) d(δ/δ_m)/y and (δ/δ_m)^{−3/2} dy.
Reached HertzMotion::meet(const ConcaveGap& gap) const {
  if (gap.coupling == 0) return {-gap.value / gap.rate, at(-gap.value / gap.rate)};
  const double top = std::clamp(gap.rate / (gap.coupling * speed_), y_start_, 1.0);
  const auto on_way_in = [&](double ratio) { return from_ratio(ratio, -1); };
  const auto in_the_middle = [&](double y) { return from_y(y); };
  const auto on_way_out = [&](double ratio) { return from_ratio(ratio, 1); };
  const auto by_ratio = [](const Place& place) { return -1.25 / place.y; };
  const auto by_y = [](const Place& place) { return 1 / (place.ratio * std::sqrt(place.ratio)); };
  const auto root = [&](const auto& chart, const auto& time_rate, double from, double to) {
    const auto there = [&](double coordinate) {
      const Place place = chart(coordinate);
      const double rate = gap.rate - gap.coupling * speed_ * place.y;
      return std::pair(value(gap, place), tau_ * rate * time_rate(place));
    };
    const Place place = chart(there(from).first > 0 ? locate_fall(there, from, to, epsilon) : from);
    return Reached{tau_ * (time(place) - start_time_), {depth_ * place.ratio, -speed_ * place.y}};
  };
  if (top < -hertz_middle && value(gap, from_y(-hertz_middle)) <= 0)
    return root(on_way_in, by_ratio, top > y_start_ ? from_y(top).ratio : start_depth_ / depth_,
                hertz_half_depth);
  if (top < hertz_middle && value(gap, from_y(hertz_middle)) <= 0)
    return root(in_the_middle, by_y, std::max(top, -hertz_middle), hertz_middle);
  if (value(gap, from_ratio(0)) >= 0) return opening();
  return root(on_way_out, by_ratio, from_y(std::max(top, hertz_middle)).ratio, 0);
}

LinearMotion::LinearMotion(const PairLaw& law, const Indentation& start)
    : frequency_(std::sqrt(law.stiffness / law.reduced_mass)),
      angle_(std::atan2(-start.rate, frequency_ * std::max(0.0, start.value))),
      speed_(std::hypot(start.rate, frequency_ * start.value)) {}

double LinearMotion::duration() const {
  return (std::numbers::pi / 2 - angle_) / frequency_;
}
double LinearMotion::turn() const {
  return std::max(0.0, -angle_ / frequency_);
}
Reached LinearMotion::reach(double depth) const {
  const double ratio = depth * frequency_ / speed_;
  if (angle_ >= 0 || !(ratio < 1)) return {infinity, {}};
  const double time = std::max(0.0, (-std::acos(ratio) - angle_) / frequency_);
  return {time, {depth, at(time).rate}};
}
Reached LinearMotion::recede(double speed) const {
  if (!(speed < speed_)) return {infinity, {}};
  const double time = std::max(0.0, (std::asin(speed / speed_) - angle_) / frequency_);
  return {time, at(time)};
}
Indentation LinearMotion::at(double time) const {
  const double angle = angle_ + frequency_ * time;
  return {speed_ / frequency_ * std::cos(angle), -speed_ * std::sin(angle)};
}
double LinearMotion::fall(const ConcaveGap& gap) const {
  return fall_in_time(*this, gap, duration());
}

DampedMotion::DampedMotion(const PairLaw& law, const Indentation& start)
    : start_(start),
      decay_(0.5 * law.damping / law.reduced_mass),
      square_(law.stiffness / law.reduced_mass),
      // Equal roots are moved apart by a rounding error, which the motion does not notice.
      split_(std::sqrt(std::max(std::abs(square_ - decay_ * decay_), epsilon * epsilon * square_))),
      form_(square_ >= decay_ * decay_ ? Form::oscillating
            : 2 * split_ <= decay_     ? Form::creeping
                                       : Form::stiff),
      duration_(find_duration()) {}

/// First zero of δ̈ = e^{−bt} (A cos φ + B sin φ), φ = √|ω²−b²| t, A < 0, with hyperbolic functions beyond
/// critical damping; or of p r₁² e^{r₁t} + q r₂² e^{r₂t}, where q r₂² is δ̈ − p r₁² at the start. A contact
/// whose load has vanished but for rounding lets go at once.
double DampedMotion::find_duration() const {
  const double a = std::min(0.0, -(square_ * start_.value + 2 * decay_ * start_.rate));
  const double jerk = -(square_ * start_.rate + 2 * decay_ * a);
  const double b = (jerk + decay_ * a) / split_;
  if (form_ == Form::oscillating) return std::atan2(-a, b) / split_;
  if (form_ == Form::creeping) return std::atanh(-a / b) / split_;
  const double fast = -(decay_ + split_), slow = square_ / fast;
  const double p = (start_.rate - fast * start_.value) / (slow - fast);
  return std::log1p(-a / (p * slow * slow)) / (slow - fast);
}

Indentation DampedMotion::at(double time) const {
  if (form_ == Form::stiff) {
    const double fast = -(decay_ + split_), slow = square_ / fast;
    const double p = (start_.rate - fast * start_.value) / (slow - fast);
    const double q = (slow * start_.value - start_.rate) / (slow - fast);
    const double x = p * std::exp(slow * time), y = q * std::exp(fast * time);
    return {x + y, slow * x + fast * y};
  }
  const bool round = form_ == Form::oscillating;
  const double angle = split_ * time, fade = std::exp(-decay_ * time);
  const double even = round ? std::cos(angle) : std::cosh(angle);
  const double odd = (round ? std::sin(angle) : std::sinh(angle)) / split_;
  return {fade * (start_.value * even + (start_.rate + decay_ * start_.value) * odd),
          fade * (start_.rate * even - (square_ * start_.value + decay_ * start_.rate) * odd)};
}

double DampedMotion::fall(const ConcaveGap& gap) const {
  return fall_in_time(*this, gap, duration_);
}

PairMotion make_pair_motion(const PairLaw& law, const Indentation& start) {
  if (law.width) return WidthMotion(*law.width, law.reduced_mass, start);
  if (law.damping > 0) return DampedMotion(law, start);
  if (law.exponent == 1) return LinearMotion(law, start);
  return HertzMotion(law, start);
}

}  // namespace mariotte::flow
