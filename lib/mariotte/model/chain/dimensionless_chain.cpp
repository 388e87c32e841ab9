#include "mariotte/model/chain/dimensionless_chain.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/contacts/scaled_law.hpp"
#include "mariotte/model/representable.hpp"

namespace mariotte::model {
namespace {

double reduced_mass(double a, double b) {
  if (std::isinf(a)) return std::isinf(b) ? 1 : b;
  return std::isinf(b) ? a : a / (1 + a / b);
}

}  // namespace

double reference_speed(const Chain& chain) {
  const auto [slowest, fastest] = std::minmax_element(chain.velocity.begin(), chain.velocity.end());
  const double spread = std::min(*fastest - *slowest, std::max(std::abs(*slowest), std::abs(*fastest)));
  double squared = spread * spread;
  for (std::size_t j = 0; j < chain.gap.size(); ++j) {
    squared += 2 * std::abs(chain.gravity) * std::max(0.0, chain.gap[j]);
    const double mass = reduced_mass(chain.mass[j], chain.mass[j + 1]);
    if (chain.gap[j] < 0) squared += 2 * contact::stored_energy(chain.law[j], -chain.gap[j]) / mass;
  }
  if (squared > 0) return std::sqrt(squared);
  // Nothing moves unless gravity presses touching balls together: the speed gained over a static indentation.
  if (chain.gravity == 0) return 1;
  double indentation = 0;
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    const double weight = reduced_mass(chain.mass[j], chain.mass[j + 1]) * std::abs(chain.gravity);
    indentation = std::max(indentation, contact::static_indentation(chain.law[j], weight));
  }
  return std::sqrt(2 * std::abs(chain.gravity) * indentation);
}

namespace {

/// The contact with the shortest natural time; it alone sets the units, so a mirrored chain has the same.
std::size_t quickest_contact(const Chain& chain, double speed, NaturalLength& natural_length) {
  std::size_t quickest = 0;
  double shortest = infinity;
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    const double length = natural_length(chain.law[j], reduced_mass(chain.mass[j], chain.mass[j + 1]), speed);
    if (length >= shortest) continue;
    shortest = length;
    quickest = j;
  }
  return quickest;
}

Scale choose_scale(const Chain& chain, double speed, std::size_t j, NaturalLength& natural_length) {
  Scale scale;
  scale.mass = power_of_two_below(2 * reduced_mass(chain.mass[j], chain.mass[j + 1]));
  scale.velocity = power_of_two_below(speed);
  scale.length = natural_length(chain.law[j], scale.mass, scale.velocity);
  scale.time = scale.length / scale.velocity;
  return scale;
}

/// Gravity towards decreasing position pulls a ball back to a wall on its left; upwards gravity mirrors that.
bool pulls_back(const Chain& chain) {
  if (chain.gravity == 0) return false;
  for (std::size_t j = 0; j + 1 < chain.mass.size(); ++j) {
    const auto below = chain.gravity > 0 ? j : j + 1, above = chain.gravity > 0 ? j + 1 : j;
    if (std::isinf(chain.mass[below]) && !std::isinf(chain.mass[above])) return true;
  }
  return false;
}

}  // namespace

void make_dimensionless(const Chain& chain, double accuracy, DimensionlessChain& d) {
  const double speed = reference_speed(chain);
  NaturalLength natural_length;
  const auto quickest = quickest_contact(chain, speed, natural_length);
  d.scale = choose_scale(chain, speed, quickest, natural_length);
  d.speed = speed / d.scale.velocity;
  d.slow = slow_share(accuracy) * d.speed;
  d.faint = d.faint_depth = 1;
  d.falls_back = pulls_back(chain);
  for (auto* list : {&d.mass, &d.inverse_mass, &d.gap, &d.velocity, &d.gravity, &d.reduced_mass, &d.length,
                     &d.time, &d.shallow})
    list->clear();
  d.law.clear();
  const auto& reference = chain.law[quickest];
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    d.mass.push_back(chain.mass[i] / d.scale.mass);
    d.inverse_mass.push_back(1 / d.mass[i]);
    d.velocity.push_back(chain.velocity[i] / d.scale.velocity);
    d.gravity.push_back(std::isinf(chain.mass[i]) ? 0 : chain.gravity * d.scale.time / d.scale.velocity);
  }
  NaturalLength slow_length;
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    d.law.push_back(scaled(chain.law[j], d.scale, reference));
    d.gap.push_back(chain.gap[j] / d.scale.length);
    d.reduced_mass.push_back(reduced_mass(d.mass[j], d.mass[j + 1]));
    d.length.push_back(natural_length(d.law[j], d.reduced_mass[j], d.speed));
    d.shallow.push_back(slow_length(d.law[j], d.reduced_mass[j], d.slow));
    d.time.push_back(d.length[j] / d.speed);
  }
  expect_representable(chain, d);
}

void fade_later(DimensionlessChain& d, double accuracy) {
  d.faint = std::min(1.0, slow_share(accuracy) * d.speed / d.slow);
  d.faint_depth = std::pow(d.faint, 0.8);  // of Hertz contacts; linear ones fade a little early
}

void copy_slice(const DimensionlessChain& whole, Index first, Index last, DimensionlessChain& slice) {
  slice.scale = whole.scale;
  slice.speed = whole.speed;
  slice.slow = whole.slow;
  slice.faint = whole.faint;
  slice.faint_depth = whole.faint_depth;
  slice.falls_back = whole.falls_back;
  const auto copy = [&](auto list, Index end) {
    (slice.*list).assign((whole.*list).begin() + first, (whole.*list).begin() + end);
  };
  using D = DimensionlessChain;
  for (const auto list : {&D::mass, &D::inverse_mass, &D::velocity, &D::gravity}) copy(list, last + 1);
  for (const auto list : {&D::gap, &D::reduced_mass, &D::length, &D::time, &D::shallow}) copy(list, last);
  copy(&D::law, last);
}

}  // namespace mariotte::model
