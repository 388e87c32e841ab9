#include <fmt/format.h>

#include <numbers>

#include "family.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::stress_study {
namespace {

using report::exact;

/// What a scene file says of a body.
struct Keys {
  std::string shape = "sphere";
  double radius = 2.45e-6, ratio = 4, density = 1350, stiffness = 1.74e9, adhesion = 0.38;
  double zeta_hertz = 1.5, zeta_adhesion = 0.5, friction = 0.15, speed = 5;
  std::array<double, 2> tangential{};
  std::array<double, 3> angles{}, spin{};
  double gravity = 0;
  int impacts = 1;
  bool indented = false;
};

std::string text(const Keys& k) {
  const auto body = k.shape == "sphere" ? "" : "length_ratio = " + exact(k.ratio) + "\n";
  const auto zeta = k.adhesion > 0 ? fmt::format("zeta_hertz = {}\nzeta_adhesion = {}\n", exact(k.zeta_hertz),
                                                 exact(k.zeta_adhesion))
                                   : fmt::format("damping_hertz = {}\n", exact(0.01 * k.zeta_hertz));
  return fmt::format(
      "[run]\nimpacts = {}\ngravity = {}\n[body]\nshape = \"{}\"\nradius = {}\n{}density = {}\n[surface]\n"
      "law = \"brach-dunn\"\nstiffness = {}\nwork_of_adhesion = {}\n{}friction = {}\n{}[incidence]\n"
      "normal_speed = {}\ntangential_velocity = [{}, {}]\nangles = [{}, {}, {}]\nspin = [{}, {}, {}]\n",
      k.impacts, exact(k.gravity), k.shape, exact(k.radius), body, exact(k.density), exact(k.stiffness),
      exact(k.adhesion), zeta, exact(k.friction), k.indented ? "lever = \"indented\"\n" : "", exact(k.speed),
      exact(k.tangential[0]), exact(k.tangential[1]), exact(k.angles[0]), exact(k.angles[1]),
      exact(k.angles[2]), exact(k.spin[0]), exact(k.spin[1]), exact(k.spin[2]));
}

/// The scene of these keys; without its turning and spin if tip 1 would not be the first to touch.
Scene scene_of(Keys keys) {
  for (const bool plain : {false, true}) {
    if (plain) keys.angles = {}, keys.spin = {};
    const auto words = text(keys);
    try {
      return {.model = Body{std::get<model::Microbody>(scene::parse(words, "stress").model), words}};
    } catch (const scene::SceneError&) {
      if (plain) throw;
    }
  }
  throw Error("a body without turning and spin was refused");
}

/// Size, speed and surface of a body, in the range of experiments.
Keys any_surface(Dice& dice) {
  Keys k;
  k.radius = dice.between(5e-7, 1e-5);
  k.ratio = dice.uniform(0, 12);
  k.speed = dice.between(0.3, 50);
  k.adhesion = dice.chance(0.2) ? 0 : dice.between(0.01, 0.5);
  k.zeta_hertz = dice.chance(0.2) ? 0 : dice.uniform(0, 2);
  k.zeta_adhesion = dice.chance(0.2) ? 0 : dice.uniform(0, 1);
  k.friction = dice.chance(0.2) ? 0 : dice.uniform(0, 1.5);
  return k;
}

Keys sphere_keys(Dice& dice) {
  auto k = any_surface(dice);
  if (dice.chance(0.5)) k.friction = 0;
  if (dice.chance(0.7)) k.tangential = {k.speed * dice.uniform(-2, 2), 0};
  if (dice.chance(0.3)) k.spin = {0, 0, k.speed / k.radius * dice.uniform(-2, 2)};
  return k;
}

/// In the plane of e1 and e3: turned about e2.
Keys planar_keys(Dice& dice) {
  auto k = any_surface(dice);
  k.shape = dice.chance(0.5) ? "rod" : "dumbbell";
  k.angles[1] = dice.uniform(-1.5, 1.5);
  if (dice.chance(0.5)) k.tangential[1] = k.speed * dice.uniform(-2, 2);
  if (dice.chance(0.3)) k.spin[1] = k.speed / (k.radius * (1 + k.ratio / 2)) * dice.uniform(-1, 1);
  return k;
}

Keys spatial_keys(Dice& dice) {
  auto k = planar_keys(dice);
  k.angles = {dice.uniform(-3, 3), k.angles[1], dice.uniform(-3, 3)};
  for (double& v : k.tangential) v = k.speed * dice.uniform(-1, 1);
  const double turning = dice.chance(0.4) ? 0 : k.speed / (k.radius * (1 + k.ratio / 2));
  for (double& w : k.spin) w = turning * dice.uniform(-0.5, 0.5);
  return k;
}

Keys any_keys(Dice& dice) {
  const double kind = dice.uniform(0, 1);
  return kind < 0.3 ? sphere_keys(dice) : kind < 0.6 ? planar_keys(dice) : spatial_keys(dice);
}

Scene sphere(Dice& dice) {
  return scene_of(sphere_keys(dice));
}
Scene planar_body(Dice& dice) {
  return scene_of(planar_keys(dice));
}
Scene spatial_body(Dice& dice) {
  return scene_of(spatial_keys(dice));
}

Scene frictionless(Dice& dice) {
  auto k = any_keys(dice);
  k.friction = 0;
  return scene_of(k);
}

Scene secondary_impacts(Dice& dice) {
  auto k = dice.chance(0.6) ? planar_keys(dice) : spatial_keys(dice);
  k.impacts = dice.whole(2, 4);
  if (dice.chance(0.1)) k.gravity = 9.81;
  return scene_of(k);
}

Scene nearly_flat(Dice& dice) {
  auto k = planar_keys(dice);
  k.angles[1] = 0.5 * std::numbers::pi - dice.between(1e-6, 0.1);
  k.impacts = dice.whole(1, 3);
  return scene_of(k);
}

Scene slow(Dice& dice) {
  auto k = any_keys(dice);
  const double factor = dice.between(0.01, 0.5);
  k.speed *= factor;
  for (double& v : k.tangential) v *= factor;
  for (double& w : k.spin) w *= factor;
  return scene_of(k);
}

Scene strong_damping(Dice& dice) {
  auto k = any_keys(dice);
  k.zeta_hertz = dice.between(1, 300);
  k.zeta_adhesion = dice.between(0.1, 10);
  return scene_of(k);
}

Scene any_size(Dice& dice) {
  auto k = any_keys(dice);
  const double radius = dice.between(1e-8, 1e-2), factor = k.radius / radius;
  k.radius = radius;
  for (double& w : k.spin) w *= factor;
  k.stiffness = dice.between(1e7, 1e12);
  k.indented = dice.chance(0.3);
  return scene_of(k);
}

}  // namespace

std::vector<Family> body_families() {
  return {{"sphere", sphere},
          {"planar body", planar_body},
          {"spatial body", spatial_body},
          {"frictionless body", frictionless},
          {"secondary impacts", secondary_impacts},
          {"nearly flat", nearly_flat},
          {"slow body", slow},
          {"damped body", strong_damping},
          {"any size", any_size}};
}

}  // namespace mariotte::stress_study
