#include "friction_contacts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "law_numbers.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::stress_study {
namespace {

using report::exact;
using std::numbers::pi;

constexpr double energy = ball_mass * ball_speed * ball_speed;

/// A normal law with the stiffness that it has at its natural depth, as that of a power.
struct Normal {
  std::string text;
  double stiffness, exponent;
};

std::string law_text(std::string_view name, const contact::LawNumbers& numbers) {
  auto text = fmt::format("law = \"{}\"\n", name);
  for (const auto& key : named_law(name).keys)
    if (!key.may_be_missing || numbers.*key.number > 0)
      text += fmt::format("{} = {}\n", key.key, exact(numbers.*key.number));
  return text;
}

Normal some_power(Dice& dice, double depth, bool may_be_overdamped) {
  const double exponent = dice.chance(0.7) ? 1.5 : 1;
  const double stiffness = energy / std::pow(depth, exponent + 1);
  const double strongest = may_be_overdamped && dice.chance(0.2) ? 30 : 1;
  const double damping =
      dice.chance(0.6) ? 0 : dice.between(0.01, strongest) * stiffness * depth / ball_speed;
  return {fmt::format("law = \"viscoelastic\"\nexponent = {}\nstiffness = {}\ndamping = {}\n",
                      exact(exponent), exact(stiffness), exact(damping)),
          stiffness, exponent};
}

Normal some_walton_braun(Dice& dice, double depth) {
  const double stiffness = energy / (depth * depth);
  return {law_text("walton-braun",
                   {.loading_stiffness = stiffness, .unloading_stiffness = stiffness * dice.between(1, 10)}),
          stiffness, 1};
}

/// Half of those that adhere have a damper, up to one that takes all the energy. Drawn aside, so that the
/// other numbers of a scene stay what they are.
void maybe_damp(Dice dice, std::string_view name, contact::LawNumbers& sphere) {
  if (dice.chance(0.5)) return;
  const double mass = 2 * energy / (ball_speed * ball_speed), share = dice.between(1e-3, 1);
  const double modulus = sphere.effective_modulus, radius = sphere.effective_radius;
  if (name == "jkr") sphere.damping = share * std::sqrt(mass * modulus / radius);
  if (name == "dmt") sphere.damping = share * std::sqrt(mass * modulus * radius);
  if (name == "brach-dunn") sphere.damping_hertz = sphere.damping_adhesion = share / ball_speed;
}

/// Spheres that yield before or beyond their natural depth, or adhere, or both.
Normal some_sphere(Dice& dice, double depth, bool adheres) {
  const double radius = ball_radius / 2, stiffness = energy / std::pow(depth, 2.5);
  contact::LawNumbers sphere{.effective_modulus = 0.75 * stiffness / std::sqrt(radius),
                             .effective_radius = radius};
  const bool yields = !adheres || dice.chance(0.3);
  const double work = 0.05 * dice.between(1e-3, 1) * energy / (7.1 * std::pow(radius, 4.0 / 3));
  const double pressure =
      2 * sphere.effective_modulus / pi * std::sqrt(depth / radius) * dice.between(0.2, 1.2);
  if (adheres)
    sphere.work_of_adhesion = std::pow(std::pow(work, 3) * std::pow(sphere.effective_modulus, 2), 0.2);
  if (yields) sphere.yield_pressure = least_yield_pressure(sphere) + pressure;
  const char* sticky = dice.chance(0.5) ? "jkr" : dice.chance(0.5) ? "dmt" : "brach-dunn";
  const char* name = !adheres ? "thornton" : yields ? "thornton-ning" : sticky;
  maybe_damp(dice, name, sphere);
  return {law_text(name, sphere), stiffness, 1.5};
}

Normal some_branches(Dice& dice, double depth, bool may_adhere) {
  if (may_adhere && dice.chance(0.5)) return some_sphere(dice, depth, true);
  return dice.chance(0.5) ? some_sphere(dice, depth, false) : some_walton_braun(dice, depth);
}

/// Mindlin's law only beside powers.
std::string tangential(Dice& dice, const Normal& normal, double depth, bool may_be_rigid, bool is_power) {
  const double ratio = dice.uniform(0.2, 1.6),
               friction = dice.chance(0.2) ? dice.between(0.5, 3) : dice.uniform(0.02, 0.6);
  const auto words = [&](const char* law) {
    return fmt::format("tangential = \"{}\"\nfriction = {}\n", law, exact(friction));
  };
  const double kind = dice.uniform(0, 1);
  if (kind < 0.1) return "tangential = \"none\"\n";
  if (kind < 0.35 && may_be_rigid) return words("rigid");
  const double secant = ratio * normal.stiffness * std::pow(depth, normal.exponent - 1);
  if (kind < 0.6 || !is_power)
    return words("spring") + fmt::format("tangential_stiffness = {}\n", exact(secant));
  return words("mindlin") + fmt::format("tangential_stiffness = {}\n", exact(secant / std::sqrt(depth)));
}

}  // namespace

Contacts some_contacts(Dice& dice, const Allowed& allowed) {
  const double depth = ball_radius * dice.between(1e-5, 3e-3);
  const bool is_power = dice.chance(0.7);
  const auto normal =
      is_power ? some_power(dice, depth, allowed.overdamped) : some_branches(dice, depth, allowed.adhesion);
  const auto share = fmt::format("share = {}\n", dice.pick({0, 0.5, 1}));
  return {depth, depth / ball_speed,
          normal.text + share + tangential(dice, normal, depth, allowed.rigid, is_power)};
}

}  // namespace mariotte::stress_study
