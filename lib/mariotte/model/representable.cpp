#include "mariotte/model/representable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace mariotte::model {
namespace {

// Written so that nan is never fine.
bool fits(double size) {
  return size >= smallest_size && size <= largest_size;
}
bool is_bounded(double value) {
  return std::abs(value) <= largest_size;
}

/// How fast a piece of drive k turns: the frequency of a sine, or the duration of a pulse.
StatedNumber stated_frequency(const std::vector<Drive>& drives, Index k, const SignalPiece& piece) {
  const double frequency = piece.frequency / (2 * std::numbers::pi);
  if (drives[static_cast<std::size_t>(k)].signal.piece.size() == 1) return {"frequency", -1, frequency, k};
  return {"duration", -1, 0.5 / frequency, k};
}

/// The stated number that is farthest from 1.
class Culprit {
 public:
  void consider(const StatedNumber& number) {
    if (number.value == 0 || std::isinf(number.value)) return;
    const double distance = std::abs(std::log(std::abs(number.value)));
    if (distance <= distance_) return;
    distance_ = distance;
    number_ = number;
  }
  void consider(std::string_view key, double value, Index place = -1) {
    consider(StatedNumber{key, place, value});
  }
  void consider(std::string_view key, const std::vector<double>& values) {
    for (Index i = 0; i < std::ssize(values); ++i) consider(key, values[i], i);
  }
  void consider(const std::vector<contact::Law>& laws) {
    for (const auto& law : laws) {
      for (const auto& parameter : parameters(law))
        if (parameter.key != "exponent") consider(parameter.key, parameter.value);
    }
  }
  void consider(const std::vector<Drive>& drives) {
    for (Index k = 0; k < std::ssize(drives); ++k)
      for (const auto& piece : drives[static_cast<std::size_t>(k)].signal.piece) {
        consider({"amplitude", -1, piece.amplitude, k});
        consider(stated_frequency(drives, k, piece));
        consider({"table", -1, piece.power[0], k});
      }
  }
  [[noreturn]] void refuse() const {
    std::array<char, 256> text{};
    std::snprintf(
        text.data(), text.size(),
        "cannot be computed with in double precision: %s %.3g, with the other numbers, makes an energy, "
        "a force, a length or a time leave %.0e … %.0e (SI)",
        std::string(number_.key).c_str(), number_.value, smallest_size, largest_size);
    throw Unrepresentable(text.data(), number_);
  }

 private:
  double distance_ = 0;
  StatedNumber number_;
};

bool fits(const Scale& scale) {
  const double squared = scale.velocity * scale.velocity;
  const std::array units{scale.mass,       squared,        scale.length,  scale.time,
                         scale.momentum(), scale.energy(), scale.force(), scale.velocity / scale.time};
  return std::all_of(units.begin(), units.end(), [](double unit) { return fits(unit); });
}

/// The numbers of a power law; of any other its force and slopes at a natural indentation.
bool fits(const contact::Law& law, double length) {
  if (const auto* power = power_law(law)) return fits(power->stiffness) && is_bounded(power->damping);
  const auto f = smooth_force(law, length, 0);
  return fits(f.value) && is_bounded(f.by_indentation) && is_bounded(f.by_rate);
}

/// All but frequencies.
bool is_bounded(const Signal& signal) {
  return std::all_of(signal.piece.begin(), signal.piece.end(), [](const SignalPiece& p) {
    return is_bounded(p.start) && is_bounded(p.amplitude) && is_bounded(p.phase) &&
           std::all_of(p.power.begin(), p.power.end(), [](double c) { return is_bounded(c); });
  });
}

/// Laws, gaps, drives and natural sizes of the contacts of a scaled chain or network.
template <class Scaled>
bool contacts_fit(const Scaled& d) {
  for (const auto& drive : d.drive)
    if (!is_bounded(drive.signal) || !is_bounded(drive.change)) return false;
  for (std::size_t j = 0; j < d.law.size(); ++j)
    if (!fits(d.law[j], d.length[j]) || !is_bounded(d.gap[j]) || !fits(d.reduced_mass[j]) ||
        !fits(d.length[j]) || !fits(d.time[j]) || !is_bounded(d.gap[j] / d.speed * d.scale.time))
      return false;
  return true;
}

/// Throw unless the contacts can be told from rigid ones without rebound.
template <class Scaled>
void expect_resolved_damping(const Scaled& d, const std::vector<contact::Law>& laws) {
  for (std::size_t j = 0; j < d.law.size(); ++j) {
    const double ratio = damping_group(d, static_cast<Index>(j));
    if (ratio <= largest_damping_group) continue;
    std::array<char, 256> text{};
    std::snprintf(
        text.data(), text.size(),
        "cannot be computed with in double precision: contact %d is damped %.1e times as strongly as "
        "c = √(k m*), and %.0e is the most; it stops its balls without rebound",
        static_cast<int>(j + 1), ratio, largest_damping_group);
    throw Unrepresentable(
        text.data(), {"damping", static_cast<Index>(j), power_law(laws[j]) ? contact::damping(laws[j]) : 0});
  }
}

/// Throw unless drives do not turn much faster than contacts can follow.
template <class Scaled>
void expect_resolved_drives(const Scaled& d, const std::vector<Drive>& drives) {
  for (std::size_t k = 0; k < drives.size(); ++k)
    for (const auto& piece : d.drive[k].signal.piece) {
      if (piece.frequency <= largest_driven_angle) continue;
      std::array<char, 256> text{};
      std::snprintf(
          text.data(), text.size(),
          "cannot be computed with in double precision: drive %d turns by %.1e rad within the shortest "
          "natural time, and %.0e is the most",
          static_cast<int>(k + 1), piece.frequency, largest_driven_angle);
      throw Unrepresentable(text.data(), stated_frequency(drives, static_cast<Index>(k), piece));
    }
}

/// Something sets contacts in motion, but its square is lost to underflow. `spread` is the largest relative
/// speed at the start.
template <class Scaled>
bool loses_motion(const Scaled& d, double spread) {
  if (spread * spread >= smallest_size) return false;
  bool moves = spread > 0;
  for (std::size_t j = 0; j < d.law.size(); ++j) {
    if (!(d.gap[j] < 0)) continue;
    if (contact::stored_energy(d.law[j], -d.gap[j]) >= smallest_size) return false;
    moves = true;
  }
  return moves;
}

bool fits(const DimensionlessChain& d, const Chain& chain) {
  if (!fits(d.scale) || !fits(d.speed) || !contacts_fit(d)) return false;
  const double longest = *std::max_element(d.time.begin(), d.time.end());
  double energy = 0;
  for (std::size_t i = 0; i < d.mass.size(); ++i) {
    const bool is_wall = std::isinf(chain.mass[i]);
    if (!is_bounded(d.velocity[i]) || !is_bounded(d.gravity[i])) return false;
    if (is_wall ? !std::isinf(d.mass[i]) : !fits(d.mass[i])) return false;
    const double fall = d.gravity[i] * longest;  // speed gained while a contact lasts
    if (!is_wall) energy += d.mass[i] * (d.velocity[i] * d.velocity[i] + d.speed * d.speed + fall * fall);
  }
  if (!is_bounded(energy) || !is_bounded(energy * d.scale.energy())) return false;
  const auto [slowest, fastest] = std::minmax_element(d.velocity.begin(), d.velocity.end());
  return chain.gravity != 0 || !loses_motion(d, *fastest - *slowest);
}

/// Of the mass matrix at these velocities, whatever their units.
double twice_kinetic_energy(const Network& network) {
  const auto& v = network.velocity;
  const std::size_t n = v.size();
  double sum = 0;
  if (is_diagonal(network.mass, std::ssize(v))) {
    for (std::size_t i = 0; i < n; ++i)
      if (!std::isinf(network.mass[i])) sum += network.mass[i] * v[i] * v[i];
    return sum;
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) sum += std::abs(v[i] * network.mass[i * n + k] * v[k]);
  return sum;
}

bool fits(const DimensionlessNetwork& d, const Network& network) {
  if (!fits(d.scale) || !fits(d.speed) || !contacts_fit(d)) return false;
  double spread = 0;
  for (const auto& direction : d.direction)
    spread = std::max(spread, std::abs(gap_rate(direction, d.velocity)));
  for (const auto& push : d.response)
    for (const auto& term : push)
      if (!is_bounded(term.coefficient)) return false;
  for (const double v : d.velocity)
    if (!is_bounded(v)) return false;
  return is_bounded(twice_kinetic_energy(network)) && !loses_motion(d, spread);
}

bool fits(const Vector3& v) {
  return fits(v.e1) && fits(v.e2) && fits(v.e3);
}
bool is_bounded(const Vector3& v) {
  return is_bounded(v.e1) && is_bounded(v.e2) && is_bounded(v.e3);
}

bool fits(const DimensionlessMicrobody& d) {
  const auto& inertia = d.body.inertia;
  const double least = std::min({inertia.e1, inertia.e2, inertia.e3}), momentum = norm(d.momentum);
  if (!fits(d.scale) || !fits(d.body.mass) || !fits(inertia) || !is_bounded(d.velocity) ||
      !is_bounded(momentum * momentum / least) || !is_bounded(d.gravity) || !fits(d.speed))
    return false;
  for (std::size_t i = 0; i < d.tips(); ++i) {
    const auto& tip = d.body.tips[i];
    const auto& law = d.law[i];
    if (!fits(tip.radius) || !is_bounded(tip.centre) || !is_bounded(d.gap[i]) || !fits(law.stiffness) ||
        !is_bounded(law.adhesion) || !is_bounded(law.damping_hertz) || !is_bounded(law.damping_adhesion))
      return false;
  }
  return true;
}

Culprit culprit(const Chain& chain) {
  Culprit culprit;
  for (Index i = 0; i < std::ssize(chain.velocity); ++i)
    if (!prescribes(chain.drive, i)) culprit.consider("velocity", chain.velocity[i], i);
  culprit.consider(chain.drive);
  culprit.consider("mass", chain.mass);
  culprit.consider("gap", chain.gap);
  culprit.consider(chain.law);
  culprit.consider("gravity", chain.gravity);
  return culprit;
}

Culprit culprit(const Network& network) {
  Culprit culprit;
  for (Index i = 0; i < std::ssize(network.velocity); ++i)
    if (!prescribes(network.drive, i)) culprit.consider("velocity", network.velocity[i]);
  culprit.consider(network.drive);
  for (const double mass : network.mass) culprit.consider("mass", mass);
  for (const double gap : network.gap) culprit.consider("gap", gap);
  culprit.consider(network.law);
  return culprit;
}

Culprit culprit(const Microbody& body) {
  Culprit culprit;
  culprit.consider("normal_speed", body.velocity.e1);
  culprit.consider("tangential_velocity", norm(tangential(body.velocity)));
  culprit.consider("spin", norm(body.spin));
  for (const auto& tip : body.body.tips) culprit.consider("radius", tip.radius);
  for (const auto& law : body.law) {
    culprit.consider("stiffness", law.stiffness);
    culprit.consider("work_of_adhesion", law.adhesion);
    culprit.consider("damping_hertz", law.damping_hertz);
    culprit.consider("damping_adhesion", law.damping_adhesion);
  }
  culprit.consider("mass", body.body.mass);
  culprit.consider("gravity", body.gravity);
  return culprit;
}

}  // namespace

void expect_representable(const Chain& chain, const DimensionlessChain& scaled) {
  if (!fits(scaled, chain)) culprit(chain).refuse();
  expect_resolved_damping(scaled, chain.law);
  expect_resolved_drives(scaled, chain.drive);
}

void expect_representable(const Network& network, const DimensionlessNetwork& scaled) {
  if (!fits(scaled, network)) culprit(network).refuse();
  expect_resolved_damping(scaled, network.law);
  expect_resolved_drives(scaled, network.drive);
}

void expect_representable(const Microbody& body, const DimensionlessMicrobody& scaled) {
  if (!fits(scaled)) culprit(body).refuse();
}

void expect_representable(const Chain& chain) {
  DimensionlessChain scaled;
  make_dimensionless(chain, /*accuracy=*/1e-10, scaled);
}

void expect_representable(const Network& network) {
  DimensionlessNetwork scaled;
  make_dimensionless(network, /*accuracy=*/1e-10, scaled);
}

void expect_representable(const Microbody& body) {
  dimensionless(body);
}

}  // namespace mariotte::model
