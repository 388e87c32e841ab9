// Parts of random scenes: masses, laws, gaps, units.
#pragma once
#include "dice.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::stress_study {

/// How many powers of ten a scene's masses or stiffnesses are spread over: mostly none, one or two.
inline double spread(Dice& dice) {
  const double kind = dice.uniform(0, 1);
  if (kind < 0.3) return 0;
  return kind < 0.9 ? dice.uniform(0, 2) : dice.uniform(2, 10);
}

/// Which laws a scene is made of.
enum class Laws { linear, hertz, damped_linear, damped_hertz, damped_any, undamped_mixture, mixture };

/// Damping group: none, light, or anything up to 10⁶.
inline double damping_group(Dice& dice) {
  const double kind = dice.uniform(0, 1);
  if (kind < 0.15) return 0;
  return kind < 0.75 ? dice.between(1e-3, 3) : dice.between(1, 1e6);
}

/// c = 2 ζ √(k m*) for n = 1, and what has the same effect at unit speed for others.
inline contact::Law damped(double stiffness, double ratio, double exponent, double mass) {
  const double c =
      2 * ratio * std::pow(stiffness, exponent / (exponent + 1)) * std::pow(mass, 1 / (exponent + 1));
  return contact::Viscoelastic{stiffness, c, exponent};
}

/// The law of one contact between bodies of a reduced mass.
inline contact::Law draw_law(Dice& dice, Laws laws, double stiffness, double mass) {
  switch (laws) {
    case Laws::linear:
      return contact::Linear{stiffness};
    case Laws::hertz:
      return contact::Hertz{stiffness};
    case Laws::damped_linear:
      return damped(stiffness, damping_group(dice), 1, mass);
    case Laws::damped_hertz:
      return damped(stiffness, damping_group(dice), 1.5, mass);
    case Laws::damped_any:
      return damped(stiffness, damping_group(dice), dice.chance(0.3) ? dice.whole(1, 3) : dice.uniform(1, 3),
                    mass);
    case Laws::undamped_mixture:
      return draw_law(dice, dice.chance(0.5) ? Laws::linear : Laws::hertz, stiffness, mass);
    case Laws::mixture:
      break;
  }
  return draw_law(dice, static_cast<Laws>(dice.whole(0, 4)), stiffness, mass);
}

inline Laws any_laws(Dice& dice) {
  return static_cast<Laws>(dice.whole(0, 6));
}

}  // namespace mariotte::stress_study
