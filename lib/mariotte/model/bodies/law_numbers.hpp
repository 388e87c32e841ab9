// Contact laws over any number: plain, with slopes, or recorded.
#pragma once
#include <type_traits>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/contact/law.hpp"
#include "mariotte/model/bodies/bodies_setting.hpp"
#include "mariotte/series/dual.hpp"
#include "mariotte/series/tape.hpp"

namespace mariotte::model {

template <class T>
inline constexpr bool is_recorded = std::is_same_v<T, series::Traced>;

/// δⁿ⁻¹.
template <class T>
T width_of(const contact::PowerLaw& law, const T& depth) {
  using std::pow, std::sqrt;
  if (law.exponent == 1) return T(1.0);
  return law.exponent == 1.5 ? sqrt(depth) : pow(depth, T(law.exponent - 1));
}

/// What has the sign of the force of a law that can be recorded.
inline series::Traced recorded_load(const contact::DampedPower& law, const series::Traced& depth,
                                    const series::Traced& rate) {
  if (law.grows == Damping::as_force) return law.stiffness + law.damping * rate;
  return law.stiffness * depth + law.damping * rate;
}

/// What an error of the rate makes of a load without δ, 1 + a δ̇, in the units of T's load: such a load fades
/// to that while its contact pushes. 0 of others.
template <class T>
double load_noise(const contact::Law& law, double rate_error) {
  const auto powers = contact::powers(law);
  if (!powers || powers->grows != Damping::as_force) return 0;
  return powers->damping * rate_error / (is_recorded<T> ? 1 : powers->stiffness);
}

/// What a law answers, with the slopes that T carries.
template <class T>
T answer(const contact::Force& f, const T& depth, const T& rate) {
  if constexpr (std::is_same_v<T, double>)
    return f.value;
  else
    return T::chain(depth, rate, f.value, f.by_indentation, f.by_rate);
}

/// The force before it is cut off, on the present branch if the law has some.
inline contact::Force smooth_force(const contact::Law& law, const contact::Memory& past, double depth,
                                   double rate) {
  const auto* branches = contact::branched(law);
  return branches ? branches->force(past, depth, rate) : contact::smooth_force(law, depth, rate);
}

/// Depth at which an open contact closes, a closed one opens, and one yields.
inline double closing_depth(const contact::Law& law, const contact::Memory& past) {
  const auto* branches = contact::branched(law);
  return branches ? branches->closing_indentation(past) : 0;
}
inline double opening_depth(const contact::Law& law, const contact::Memory& past) {
  const auto* branches = contact::branched(law);
  return branches ? branches->opening_indentation(past) : 0;
}
inline double yield_depth(const contact::Law& law, const contact::Memory& past) {
  const auto* branches = contact::branched(law);
  return branches ? branches->yield_indentation(past) : infinity;
}

/// What k and c add to k δ + c δ̇ as they move.
template <class N>
N moved_load(const LawNumbers<N>& numbers, double depth, double rate) {
  const auto moved = [](const N& number) { return number - series::value_of(number); };
  return depth * moved(numbers.stiffness) + rate * moved(numbers.damping);
}

/// Force of either sign.
template <class T, int D, class N>
T law_force(const SettingContact<D, N>& one, const contact::Memory& past, const T& depth, const T& rate) {
  const double d = series::value_of(depth), r = series::value_of(rate);
  T force = answer(smooth_force(one.law, past, d, r), depth, rate);
  if constexpr (!std::is_same_v<N, double>)
    if (const auto* power = contact::power_law(one.law); power && d > 0)
      force = force + contact::contact_width(power->exponent, d) * moved_load(one.numbers, d, r);
  return force;
}

/// What has the sign of the force.
template <class T, int D, class N>
T law_load(const SettingContact<D, N>& one, const T& depth, const T& rate) {
  if constexpr (is_recorded<T>) {
    return recorded_load(*contact::powers(one.law), depth, rate);
  } else {
    const double d = series::value_of(depth), r = series::value_of(rate);
    T load = answer(contact::load(one.law, d, r), depth, rate);
    if constexpr (!std::is_same_v<N, double>) load = load + moved_load(one.numbers, d, r);
    return load;
  }
}

/// Slopes of the force by indentation and by its rate. Values with slopes get those of the force of a power
/// law as well; of others these are held.
template <class T>
struct LawSlopes {
  T by_indentation, by_rate;
};
template <class T, int D, class N>
LawSlopes<T> law_slopes(const SettingContact<D, N>& one, const contact::Memory& past, const T& depth,
                        const T& rate) {
  const auto* power = contact::power_law(one.law);
  if constexpr (!std::is_same_v<T, double>)
    if (power) {
      const double n = power->exponent;
      const T width = width_of(*power, depth);
      T slope = n * one.numbers.stiffness * width;
      if (power->damping > 0 && n > 1) slope = slope + (n - 1) * one.numbers.damping * width * (rate / depth);
      return {slope, one.numbers.damping * width};
    }
  const auto f = smooth_force(one.law, past, series::value_of(depth), series::value_of(rate));
  return {T(f.by_indentation), T(f.by_rate)};
}

}  // namespace mariotte::model
