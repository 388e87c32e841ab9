// Contact laws over any number: plain, with slopes, or recorded.
#pragma once
#include <type_traits>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/contact/law.hpp"
#include "mariotte/series/dual.hpp"
#include "mariotte/series/tape.hpp"

namespace mariotte::model {

template <class T>
inline constexpr bool is_recorded = std::is_same_v<T, series::Traced>;

/// True of laws whose force is known on a tape: δⁿ⁻¹ (k δ + c δ̇) with n = 1 or 3/2.
inline bool can_be_recorded(const contact::Law& law) {
  const auto* power = contact::power_law(law);
  return power && (power->exponent == 1 || power->exponent == 1.5);
}

/// δⁿ⁻¹ of a law that can be recorded.
inline series::Traced recorded_width(const contact::PowerLaw& law, const series::Traced& depth) {
  return law.exponent == 1 ? series::Traced(1.0) : sqrt(depth);
}

/// What has the sign of the force of a law that can be recorded.
inline series::Traced recorded_load(const contact::PowerLaw& law, const series::Traced& depth,
                                    const series::Traced& rate) {
  return law.stiffness * depth + law.damping * rate;
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

/// Force of either sign.
template <class T>
T law_force(const contact::Law& law, const contact::Memory& past, const T& depth, const T& rate) {
  if constexpr (is_recorded<T>) {
    const auto& one = *contact::power_law(law);
    return recorded_width(one, depth) * recorded_load(one, depth, rate);
  } else {
    return answer(smooth_force(law, past, series::value_of(depth), series::value_of(rate)), depth, rate);
  }
}

/// What has the sign of the force.
template <class T>
T law_load(const contact::Law& law, const T& depth, const T& rate) {
  if constexpr (is_recorded<T>)
    return recorded_load(*contact::power_law(law), depth, rate);
  else
    return answer(contact::load(law, series::value_of(depth), series::value_of(rate)), depth, rate);
}

/// Slopes of the force by indentation and by its rate. Values with slopes get those of an undamped linear or
/// Hertz force as well; of others these are held.
template <class T>
struct LawSlopes {
  T by_indentation, by_rate;
};
template <class T>
LawSlopes<T> law_slopes(const contact::Law& law, const contact::Memory& past, const T& depth, const T& rate) {
  using std::sqrt;
  const auto* power = contact::power_law(law);
  if constexpr (is_recorded<T>) {
    const auto width = recorded_width(*power, depth);
    auto slope = power->exponent * power->stiffness * width;
    if (power->damping > 0 && power->exponent > 1)
      slope = slope + (power->exponent - 1) * power->damping * width * (rate / depth);
    return {slope, power->damping * width};
  } else {
    const auto f = smooth_force(law, past, series::value_of(depth), series::value_of(rate));
    LawSlopes<T> slopes{T(f.by_indentation), T(f.by_rate)};
    if (power && power->damping == 0 && power->exponent == 1.5)
      slopes.by_indentation = 1.5 * power->stiffness * sqrt(depth);
    return slopes;
  }
}

}  // namespace mariotte::model
