#include "lammps_cases.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/contact/named_laws.hpp"

namespace mariotte::work_precision {
namespace {

using contact::Law;
using contact::LawNumbers;
using model::TangentialLaw;

constexpr double radius = 0.01, mass = 0.03, half = radius / 2, reduced = mass / 2, poisson = 0.3;

model::Body ball(double place, const Vector3& velocity, double spin) {
  const double moment = 0.4 * mass * radius * radius;
  return {.mass = mass,
          .inertia = {moment, moment, moment},
          .spheres = {{{}, radius}},
          .position = {place, 0, 0},
          .velocity = velocity,
          .spin = {0, 0, spin}};
}

/// Head on, or past each other with spin.
model::Bodies pair(const Law& law, const model::Tangential& tangential = {}) {
  const bool is_oblique = tangential.law != TangentialLaw::none;
  model::Bodies bodies{.dimension = 2};
  bodies.body = {ball(0, {1, is_oblique ? 0.4 : 0, 0}, is_oblique ? 30 : 0), ball(2 * radius, {}, 0)};
  bodies.contact = {
      {.a = {0, 0}, .b = {1, 0}, .law = law, .tangential = tangential, .share = 0.5, .touching = true}};
  return bodies;
}

Law named(std::string_view name, const LawNumbers& numbers) {
  for (const auto& law : contact::named_laws)
    if (law.name == name) return law.make(numbers);
  return contact::Hertz{numbers.stiffness};
}

/// Of two equal balls of Young's modulus E.
double effective(double young) {
  return young / (2 * (1 - poisson * poisson));
}

/// LAMMPS' damping of Tsuji by the restitution.
double tsuji(double e) {
  return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

const std::string frictionless = " tangential linear_history 0 0 0";

std::vector<LammpsCase> damped() {
  const double k = 1e8, kn = k / std::sqrt(half);
  return {
      {"hooke, velocity", pair(contact::uncut(contact::Viscoelastic{k, 100, 1})),
       fmt::format("hooke {} 100 damping velocity", k) + frictionless},
      {"hertz, viscoelastic",
       pair(contact::uncut(contact::Viscoelastic{k, 2e5 * reduced * std::sqrt(half), 1.5})),
       fmt::format("hertz {:.17g} 2e5 damping viscoelastic", kn) + frictionless},
      {"hertz, tsuji",
       pair(contact::uncut(named("tsuji", {.stiffness = k, .damping = tsuji(0.8) * std::sqrt(reduced * k)}))),
       fmt::format("hertz {:.17g} 0.8 damping tsuji", kn) + frictionless}};
}

/// w is twice LAMMPS' cohesion.
std::vector<LammpsCase> adhesive() {
  const double young = 1e9, cohesion = 20;
  const LawNumbers numbers{
      .effective_modulus = effective(young), .effective_radius = half, .work_of_adhesion = 2 * cohesion};
  const auto keys = fmt::format(" {} 0 {} {} damping velocity", young, poisson, cohesion) + frictionless;
  return {{"jkr", pair(named("jkr", numbers)), "jkr" + keys},
          {"dmt", pair(named("dmt", numbers)), "dmt" + keys}};
}

LammpsCase mindlin(double young) {
  const double shear = young / (4 * (2 - poisson) * (1 + poisson));
  const model::Tangential tangential{TangentialLaw::mindlin, 0.2, 8 * shear * std::sqrt(half)};
  return {fmt::format("mindlin, E {:.0e} Pa", young),
          pair(contact::Hertz{4.0 / 3 * effective(young) * std::sqrt(half)}, tangential),
          fmt::format("hertz/material {} 0 {} damping velocity tangential mindlin_rescale/force NULL 0 0.2",
                      young, poisson)};
}

}  // namespace

std::vector<LammpsCase> lammps_cases() {
  std::vector<LammpsCase> cases{
      {"hertz", pair(contact::Hertz{1e8}),
       fmt::format("hertz {:.17g} 0 damping velocity", 1e8 / std::sqrt(half)) + frictionless}};
  for (const auto& list : {damped(), adhesive(), {mindlin(5e9), mindlin(5e11)}})
    cases.insert(cases.end(), list.begin(), list.end());
  return cases;
}

}  // namespace mariotte::work_precision
