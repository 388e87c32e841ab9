#include "mariotte/model/chain/dimensionless_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/model/contacts/bound.hpp"
#include "mariotte/model/contacts/start_balance.hpp"
#include "mariotte/model/representable.hpp"

namespace mariotte::model {
namespace {

double reduced_mass(double a, double b) {
  if (std::isinf(a)) return std::isinf(b) ? 1 : b;
  return std::isinf(b) ? a : a / (1 + a / b);
}

std::vector<double> reduced_masses(const Chain& chain) {
  std::vector<double> masses;
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    masses.push_back(reduced_mass(chain.mass[j], chain.mass[j + 1]));
  return masses;
}

/// Masses and gravity in the units of `d`.
void scale_balls(const Chain& chain, DimensionlessChain& d) {
  for (auto* list : {&d.mass, &d.inverse_mass, &d.gravity}) list->clear();
  for (const double mass : chain.mass) {
    d.mass.push_back(mass / d.scale.mass);
    d.inverse_mass.push_back(1 / d.mass.back());
    d.gravity.push_back(std::isinf(mass) ? 0 : chain.gravity * d.scale.time / d.scale.velocity);
  }
}

/// See DimensionlessChain::is_faint. What rounding leaves of a sum is that of its heaviest ball.
void find_faint(DimensionlessChain& d) {
  constexpr double share = 1e3;
  const Index contacts = std::ssize(d.reduced_mass), heaviest = heaviest_ball(d);
  d.is_faint.assign(contacts, false);
  const auto pass = [&](Index ball, Index contact, double& summed) {
    summed = std::max(summed, d.mass[ball]);
    d.is_faint[contact] = summed >= share * d.reduced_mass[contact];
    if (d.is_faint[contact]) summed = 0;
  };
  double from_left = 0, from_right = 0;
  for (Index j = 0; j < heaviest; ++j) pass(j, j, from_left);
  for (Index i = contacts; i > heaviest; --i) pass(i, i - 1, from_right);
}

/// v̇_j − v̇_{j+1} at the start, of balls that are no walls.
std::vector<double> start_approach(const Chain& chain) {
  const auto force = start_forces({chain.law, chain.gap, chain.velocity});
  std::vector<double> rate(chain.mass.size(), 0), approach;
  for (std::size_t i = 0; i < rate.size(); ++i) {
    const double pushed = (i > 0 ? force[i - 1] : 0) - (i < force.size() ? force[i] : 0);
    rate[i] = std::isinf(chain.mass[i]) ? 0 : pushed / chain.mass[i] - chain.gravity;
  }
  for (const auto& drive : chain.drive) {
    const auto ball = drive.direction.front().dof;
    rate[ball] += start_force(drive) / chain.mass[ball];
  }
  for (std::size_t j = 0; j < force.size(); ++j) approach.push_back(rate[j] - rate[j + 1]);
  return approach;
}

/// The largest speed at which a ball follows one farther on, or what starts indented parts.
double largest_meeting(const Chain& chain) {
  double largest = 0, fastest = chain.velocity.front();
  for (std::size_t j = 0; j < chain.gap.size(); ++j) {
    const double next = chain.velocity[j + 1];
    largest = std::max(largest, fastest - next);
    if (chain.gap[j] < 0) largest = std::max(largest, next - chain.velocity[j]);
    fastest = std::max(fastest, next);
  }
  return largest;
}

/// Of the velocities: that of what can meet, unless something brings back what flies apart.
double given_speed(const Chain& chain) {
  const auto [slowest, fastest] = std::minmax_element(chain.velocity.begin(), chain.velocity.end());
  const double spread = std::min(*fastest - *slowest, std::max(std::abs(*slowest), std::abs(*fastest)));
  if (chain.gravity != 0 || !chain.drive.empty()) return spread;
  return of_what_meets(largest_meeting(chain), spread);
}

SquaredSpeeds squared_speeds(const Chain& chain) {
  const double given = given_speed(chain);
  SquaredSpeeds speeds{.given = given * given};
  for (std::size_t j = 0; j < chain.gap.size(); ++j) {
    speeds.given += 2 * std::abs(chain.gravity) * std::max(0.0, chain.gap[j]);
    const double mass = reduced_mass(chain.mass[j], chain.mass[j + 1]);
    if (chain.gap[j] < 0) speeds.release(chain.law[j], -chain.gap[j], mass);
    speeds.adhesion = std::max(speeds.adhesion, 2 * well_energy(chain.law[j]) / mass);
  }
  for (const auto& drive : chain.drive) speeds.drive(drive, 1 / chain.mass[drive.direction.front().dof]);
  if (speeds.released > 0)
    speeds.unbalanced = unbalanced_speeds({chain.law, chain.gap, chain.velocity}, reduced_masses(chain),
                                          start_approach(chain));
  return speeds;
}

/// The root, or that of a static indentation.
double speed_of(const Chain& chain, double squared) {
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

}  // namespace

Index heaviest_ball(const DimensionlessChain& chain) {
  const auto& list = chain.inverse_mass;
  return list.rend() - std::min_element(list.rbegin(), list.rend()) - 1;
}

Speeds speeds(const Chain& chain) {
  const auto squared = squared_speeds(chain);
  const double largest = speed_of(chain, squared.all());
  return {largest, largest * squared.accurate_share()};
}

void make_dimensionless(const Chain& chain, double accuracy, DimensionlessChain& d) {
  d.reduced_mass.clear();
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    d.reduced_mass.push_back(reduced_mass(chain.mass[j], chain.mass[j + 1]));
  const StatedContacts stated{chain.law, chain.gap, chain.velocity};
  const auto speeds = squared_speeds(chain);
  scale_contacts(stated, speed_of(chain, speeds.all()), accuracy * speeds.in_balance(), d);
  take_speeds(speeds, d);
  scale_balls(chain, d);
  find_faint(d);
  d.falls_back = falls_back(chain);
  d.drive.clear();
  for (const auto& drive : chain.drive) {
    auto response = drive.direction;
    for (auto& [ball, coefficient] : response) coefficient /= chain.mass[ball];
    d.drive.push_back(in_units(drive, std::move(response), d.scale));
  }
  expect_representable(chain, d);
}

void restate(const Chain& chain, DimensionlessChain& d) {
  restate_contacts({chain.law, chain.gap, chain.velocity}, d);
  scale_balls(chain, d);
}

void fade_later(DimensionlessChain& d, double accuracy) {
  d.fade_speed_ratio = std::min(1.0, noise_share(accuracy) * d.speed / d.noise_speed);
  d.fade_depth_ratio =
      std::pow(d.fade_speed_ratio, 0.8);  // of Hertz contacts; linear ones fade a little early
}

void copy_slice(const DimensionlessChain& whole, Index first, Index last, DimensionlessChain& slice) {
  using Whole = DimensionlessChain;
  constexpr std::array<std::vector<double> Whole::*, 4> of_balls = {&Whole::mass, &Whole::inverse_mass,
                                                                    &Whole::velocity, &Whole::gravity};
  constexpr std::array<std::vector<double> Whole::*, 5> of_contacts = {
      &Whole::gap, &Whole::reduced_mass, &Whole::length, &Whole::time, &Whole::noise_depth};
  const auto copy = [&](const auto& from, auto& to, Index end) {
    to.assign(from.begin() + first, from.begin() + end);
  };
  for (const auto list : of_balls) copy(whole.*list, slice.*list, last + 1);
  for (const auto list : of_contacts) copy(whole.*list, slice.*list, last);
  copy(whole.law, slice.law, last);
  copy(whole.is_faint, slice.is_faint, last);
  slice.scale = whole.scale;
  slice.speed = whole.speed;
  slice.reached_speed = whole.reached_speed;
  slice.noise_speed = whole.noise_speed;
  slice.fade_speed_ratio = whole.fade_speed_ratio;
  slice.fade_depth_ratio = whole.fade_depth_ratio;
  slice.falls_back = whole.falls_back;
}

}  // namespace mariotte::model
