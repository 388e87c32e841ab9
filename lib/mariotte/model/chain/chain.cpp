#include "mariotte/model/chain/chain.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::model {
namespace {

[[noreturn]] void reject(const std::string& thing, std::size_t index, const std::string& rule) {
  throw InvalidParameter(thing + " " + std::to_string(index + 1) + ": " + rule);
}

void validate_ball(const Chain& chain, std::size_t i) {
  if (!(chain.mass[i] > 0)) reject("ball", i, "mass must be positive");
  if (!std::isfinite(chain.velocity[i])) reject("ball", i, "velocity must be finite");
}

void validate_law(std::size_t j, const contact::PowerLaw& law) {
  if (!(law.stiffness > 0) || !std::isfinite(law.stiffness))
    reject("contact", j, "stiffness must be positive and finite");
  if (!(law.damping >= 0) || !std::isfinite(law.damping))
    reject("contact", j, "damping must be finite and not negative");
  if (!(law.exponent >= 1) || !std::isfinite(law.exponent))
    reject("contact", j, "exponent must be finite and at least 1");
}

/// Where nothing tells how far the balls have fallen.
void expect_wall(const Chain& chain) {
  const auto is_force = [](const Drive& drive) { return drive.quantity == Driven::force; };
  const auto is_wall = [](double mass) { return std::isinf(mass); };
  if (chain.gravity != 0 && std::any_of(chain.drive.begin(), chain.drive.end(), is_force) &&
      std::none_of(chain.mass.begin(), chain.mass.end(), is_wall))
    throw InvalidParameter("a row on which gravity and a given force act needs a wall");
}

}  // namespace

void validate_contact(std::size_t j, const contact::Law& law, double gap, bool precompressed,
                      const char* whole) {
  if (const auto* power = power_law(law))
    validate_law(j, *power);
  else if (!std::get<contact::SharedLaw>(law))
    reject("contact", j, "has no law");
  if (!std::isfinite(gap)) reject("contact", j, "gap must be finite");
  if (gap < 0 && !precompressed)
    reject("contact", j, std::string("gap is negative but the ") + whole + " is not precompressed");
}

void expect_no_touch(std::size_t j, const contact::Law& law, double gap, double approach) {
  if (gap == 0 && approach == 0 && contact::adheres(law))
    reject("contact", j,
           "touches at rest, where its law attracts or not: give it a gap, or start it indented where its "
           "force is zero (precompressed)");
}

void validate(const Chain& chain) {
  const auto balls = chain.mass.size();
  if (balls < 2) throw InvalidParameter("a chain needs at least two balls");
  if (chain.velocity.size() != balls) throw InvalidParameter("a chain needs one velocity per ball");
  if (chain.law.size() != balls - 1 || chain.gap.size() != balls - 1)
    throw InvalidParameter("a chain of n balls needs n-1 contact laws and n-1 gaps");
  if (!std::isfinite(chain.gravity)) throw InvalidParameter("gravity must be finite");
  for (std::size_t i = 0; i < balls; ++i) validate_ball(chain, i);
  for (std::size_t j = 0; j + 1 < balls; ++j) {
    validate_contact(j, chain.law[j], chain.gap[j], chain.precompressed, "chain");
    expect_no_touch(j, chain.law[j], chain.gap[j], chain.velocity[j] - chain.velocity[j + 1]);
  }
  validate_drives(chain.drive, chain.velocity, [&](Index i) { return std::isinf(chain.mass[i]); });
  expect_wall(chain);
}

bool falls_back(const Chain& chain) {
  if (chain.gravity == 0) return false;
  for (std::size_t j = 0; j + 1 < chain.mass.size(); ++j) {
    const auto below = chain.gravity > 0 ? j : j + 1, above = chain.gravity > 0 ? j + 1 : j;
    if (std::isinf(chain.mass[below]) && !std::isinf(chain.mass[above])) return true;
  }
  return false;
}

bool comes_to_rest(const Chain& chain) {
  if (chain.gravity == 0) return false;
  const auto all = [](const auto& list, auto&& holds) {
    return std::all_of(list.begin(), list.end(), holds);
  };
  return std::isinf(chain.gravity > 0 ? chain.mass.front() : chain.mass.back()) &&
         all(chain.gap, [](double gap) { return gap == 0; }) &&
         all(chain.velocity, [&](double velocity) { return velocity == chain.velocity.front(); }) &&
         all(chain.law, [](const contact::Law& law) { return contact::dissipates(law); });
}

void expect_end(const Chain& chain, double max_time) {
  if (std::isfinite(max_time)) return;
  expect_end(chain.drive, max_time);
  if (comes_to_rest(chain))
    throw InvalidParameter("balls that stand on a wall under gravity come to rest there: give max_time");
  double fastest = -infinity;  // of the walls so far
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    if (!std::isinf(chain.mass[i])) continue;
    if (chain.velocity[i] < fastest)
      throw InvalidParameter("the walls approach each other without end: give max_time");
    fastest = std::max(fastest, chain.velocity[i]);
  }
}

double kinetic_energy(const Chain& chain, const std::vector<double>& velocity) {
  double twice = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i)
    if (std::isfinite(chain.mass[i])) twice += chain.mass[i] * velocity[i] * velocity[i];
  return twice / 2;
}

}  // namespace mariotte::model
