#include "mariotte/impact/laws/friction_laws.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/types.hpp"

namespace mariotte::impact {
namespace {

/// The impulse that takes the gap rate to `after` with Coulomb's law for the whole of it. As p_t/p_n goes
/// from −μ to μ, slip afterwards grows: it sticks where that passes zero.
InContact at_once(const FrictionalContact& c, double after) {
  const double rise = after - c.velocity.normal, determinant = c.nn * c.tt - c.nt * c.nt;
  const InContact stick{(c.tt * rise + c.nt * c.velocity.tangential) / determinant,
                        -(c.nt * rise + c.nn * c.velocity.tangential) / determinant};
  if (std::abs(stick.tangential) <= c.friction * stick.normal) return stick;
  const auto sliding = [&](double ratio) {
    const double normal = rise / (c.nn + ratio * c.nt);
    return InContact{normal, ratio * normal};
  };
  const auto forward = sliding(-c.friction);
  const bool is_forward = forward.normal > 0 && velocity_after(c, forward).tangential > 0;
  return is_forward ? forward : sliding(c.friction);
}

/// Where an impact is whose normal impulse grows bit by bit.
struct ImpulseState {
  InContact impulse, velocity;
  double work = 0;  ///< of the normal force on the bodies
};

/// How impulse and velocity change with the normal impulse.
struct ImpulseRate {
  double ratio;  ///< p_t over p_n
  InContact rate;
};

ImpulseRate impulse_rate(const FrictionalContact& c, double slip) {
  const double holding = -c.nt / c.tt;
  const bool sticks = slip == 0 && std::abs(holding) <= c.friction;
  const double ratio = sticks ? holding : std::copysign(c.friction, slip != 0 ? -slip : holding);
  return {ratio, {c.nn + ratio * c.nt, sticks ? 0 : c.nt + ratio * c.tt}};
}

/// Normal impulse until the slip ends.
double until_rest(double slip, double rate) {
  return slip * rate < 0 ? -slip / rate : infinity;
}

void advance(ImpulseState& at, const ImpulseRate& along, double by) {
  at.work += by * (at.velocity.normal + 0.5 * by * along.rate.normal);
  at.impulse.normal += by;
  at.impulse.tangential += by * along.ratio;
  at.velocity.normal += by * along.rate.normal;
  at.velocity.tangential += by * along.rate.tangential;
}

/// Goes on until `distance`, of what is left on the present course, is within it. Slip ends once at most.
template <class Distance>
ImpulseState followed(const FrictionalContact& c, ImpulseState at, Distance&& distance) {
  for (;;) {
    const auto along = impulse_rate(c, at.velocity.tangential);
    const double rest = until_rest(at.velocity.tangential, along.rate.tangential);
    const double wanted = distance(at, along);
    advance(at, along, std::min(rest, wanted));
    if (wanted <= rest) return at;
    at.velocity.tangential = 0;
  }
}

/// A rod that jams may be drawn in until its slip ends, and only then turn back.
ImpulseState compressed(const FrictionalContact& c) {
  return followed(c, {{}, c.velocity}, [](const ImpulseState& at, const ImpulseRate& along) {
    return along.rate.normal > 0 ? std::max(0.0, -at.velocity.normal / along.rate.normal) : infinity;
  });
}

}  // namespace

InContact newton(const FrictionalContact& c, double e) {
  validate(c, e);
  return at_once(c, -e * c.velocity.normal);
}

InContact moreau(const FrictionalContact& c, double e) {
  validate(c, e);
  const auto plastic = at_once(c, 0);
  return {(1 + e) * plastic.normal, (1 + e) * plastic.tangential};
}

InContact poisson(const FrictionalContact& c, double e) {
  validate(c, e);
  const auto half = compressed(c);
  const double all = (1 + e) * half.impulse.normal;
  return followed(c, half,
                  [&](const ImpulseState& at, const ImpulseRate&) { return all - at.impulse.normal; })
      .impulse;
}

InContact stronge(const FrictionalContact& c, double e) {
  validate(c, e);
  const auto half = compressed(c);
  const double all = (1 - e * e) * half.work;  // work of both is negative
  return followed(c, half,
                  [&](const ImpulseState& at, const ImpulseRate& along) {
                    const double w = at.velocity.normal, left = std::max(0.0, all - at.work);
                    return left > 0 ? 2 * left / (w + std::sqrt(w * w + 2 * along.rate.normal * left)) : 0;
                  })
      .impulse;
}

}  // namespace mariotte::impact
