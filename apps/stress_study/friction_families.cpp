// Bodies that touch each other with friction and spin, as scene files; sizes are those of small balls.
#include <fmt/format.h>

#include <numbers>

#include "family.hpp"
#include "friction_contacts.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::stress_study {
namespace {

using report::exact;
using std::numbers::pi;
using Components = std::vector<double>;

constexpr double radius = ball_radius, mass = ball_mass, speed = ball_speed;

std::string array(const Components& values) {
  std::string all;
  for (const double value : values) all += (all.empty() ? "" : ", ") + exact(value);
  return "[" + all + "]";
}

/// One body, its mass centre at `position`.
std::string body(Dice& dice, const Components& position, const Components& velocity, double spin,
                 const std::string& shape, double lightness = 1) {
  const bool plane = position.size() == 2;
  auto text =
      fmt::format("[[bodies.body]]\nmass = {}\nposition = {}\nvelocity = {}\n{}",
                  exact(mass * lightness * dice.uniform(0.5, 2)), array(position), array(velocity), shape);
  if (spin == 0) return text;
  const auto part = [&] { return spin * dice.uniform(-1, 1); };
  return text + "spin = " + (plane ? exact(part()) : array({part(), part(), part()})) + "\n";
}

const std::string ball = "shape = \"ball\"\nradius = " + exact(radius) + "\n";

/// A body with several spheres, which turns: a rod, a dumbbell or a block, in the plane.
std::string long_body(Dice& dice) {
  const auto angle = fmt::format("angle = {}\n", exact(dice.uniform(-pi, pi)));
  const int kind = dice.whole(0, 2);
  if (kind == 2)
    return angle + fmt::format("shape = \"block\"\nsize = [{}, {}]\n", exact(1.6 * radius), exact(radius));
  return angle + fmt::format("shape = \"{}\"\nradius = {}\nlength = {}\n", kind ? "rod" : "dumbbell",
                             exact(0.5 * radius), exact(dice.uniform(1.1, 2.2) * radius));
}

Scene scene_of(int dimension, const Contacts& contacts, const std::string& rest, double max_time) {
  const auto text = fmt::format("[run]\nmax_time = {}\n[bodies]\ndimension = {}\n{}{}", exact(max_time),
                                dimension, contacts.text, rest);
  return {.model = Group{std::get<model::Bodies>(scene::parse(text, "stress").model), text},
          .max_time = max_time};
}

const std::string floor_in_plane = "[[bodies.plane]]\nnormal = [0, 1]\n",
                  floor_in_space = "[[bodies.plane]]\nnormal = [0, 0, 1]\n";

std::string touching(const std::string& a, const std::string& b) {
  return fmt::format("[[bodies.contact]]\nbetween = [{}, {}]\ntouching = true\n", a, b);
}

/// Spin whose speed at the surface is that of the scene, or none.
double some_spin(Dice& dice) {
  return dice.chance(0.4) ? 0 : dice.between(0.01, 2) * speed / radius;
}

/// A ball that strikes a plane at any angle, in the plane or in space.
Scene oblique_ball(Dice& dice) {
  const auto contacts = some_contacts(dice);
  const double angle = dice.chance(0.2) ? 0 : dice.uniform(0, 0.5 * pi - 0.05);
  const double along = speed * std::sin(angle), down = -speed * std::cos(angle), spin = some_spin(dice);
  if (dice.chance(0.5))
    return scene_of(
        2, contacts,
        body(dice, {0, radius}, {along, down}, spin, ball) + floor_in_plane + touching("\"plane 1\"", "1"),
        100 * contacts.time / std::cos(angle));
  const double way = dice.uniform(-pi, pi);
  return scene_of(
      3, contacts,
      body(dice, {0, 0, radius}, {along * std::cos(way), along * std::sin(way), down}, spin, ball) +
          floor_in_space + touching("\"plane 1\"", "1"),
      100 * contacts.time / std::cos(angle));
}

/// Two balls that meet off centre, with spins.
Scene two_balls(Dice& dice) {
  const int dimension = dice.whole(2, 3);
  const auto contacts = some_contacts(dice);
  const double offset = 2 * radius * dice.uniform(0, 0.95),
               apart = std::sqrt(4 * radius * radius - offset * offset) + radius * dice.between(1e-3, 0.3);
  Components first{-apart, 0}, second{0, offset}, fast{speed, 0}, slow{0, 0.3 * speed * dice.uniform(-1, 1)};
  if (dimension == 3)
    for (auto* part : {&first, &second, &fast, &slow}) part->push_back(0);
  if (dimension == 3) slow[2] = 0.3 * speed * dice.uniform(-1, 1);
  return scene_of(
      dimension, contacts,
      body(dice, first, fast, some_spin(dice), ball) + body(dice, second, slow, some_spin(dice), ball),
      3 * radius / speed);
}

/// Balls that touch in a row, struck obliquely.
Scene struck_row(Dice& dice) {
  const auto contacts = some_contacts(dice, {.adhesion = false});
  const double angle = dice.uniform(-0.6, 0.6);
  std::string text =
      body(dice, {0, 0}, {speed * std::cos(angle), speed * std::sin(angle)}, some_spin(dice), ball);
  const int count = dice.whole(2, 5);
  for (int i = 1; i < count; ++i) {
    const double bend = dice.chance(0.5) ? 0 : dice.uniform(-0.3, 0.3);
    text += body(dice, {2 * radius * i * std::cos(bend), 2 * radius * i * std::sin(bend)}, {0, 0}, 0, ball);
  }
  return scene_of(2, contacts, text, 300 * contacts.time);
}

/// Three balls in space that come together at about one instant.
Scene ring(Dice& dice) {
  const auto contacts = some_contacts(dice, {.adhesion = false});
  std::string text;
  for (int i = 0; i < 3; ++i) {
    const double way = 2 * pi / 3 * i, far = 2 / std::sqrt(3.0) * radius + radius * dice.between(1e-4, 1e-2);
    const Components velocity{-speed * std::cos(way) + 0.2 * dice.uniform(-1, 1),
                              -speed * std::sin(way) + 0.2 * dice.uniform(-1, 1), 0.2 * dice.uniform(-1, 1)};
    text += body(dice, {far * std::cos(way), far * std::sin(way), 0}, velocity, some_spin(dice), ball);
  }
  return scene_of(3, contacts, text, 100 * contacts.time + 0.1 * radius / speed);
}

/// Something long that falls on a floor with one end first, and hits it again.
Scene dropped(Dice& dice) {
  const auto contacts = some_contacts(dice, {.adhesion = false});
  const std::string gravity = dice.chance(0.5) ? "gravity = [0, -9.81]\n" : "";
  const Components velocity{speed * dice.uniform(-1, 1), -speed * dice.uniform(0.1, 1)};
  return scene_of(
      2, contacts,
      gravity + body(dice, {0, 2.5 * radius}, velocity, some_spin(dice), long_body(dice)) + floor_in_plane,
      8 * radius / speed);
}

/// A ball on a floor under gravity, pushed or spun, which another one may strike.
Scene on_the_floor(Dice& dice) {
  const auto contacts = some_contacts(dice, {.rigid = false, .adhesion = false, .overdamped = false});
  std::string text = "gravity = [0, -9.81]\n" +
                     body(dice, {0, radius}, {speed * dice.uniform(0, 1), 0}, some_spin(dice), ball);
  const bool struck = dice.chance(0.5);
  const double apart = 2 * radius + contacts.depth * dice.between(1, 30), rise = dice.uniform(0, 0.5);
  if (struck)
    text += body(dice, {-apart * std::cos(rise), radius + apart * std::sin(rise)},
                 {2 * speed * std::cos(rise), -2 * speed * std::sin(rise)}, some_spin(dice), ball);
  return scene_of(2, contacts, text + floor_in_plane + touching("\"plane 1\"", "1"), 60 * contacts.time);
}

/// A ball on a floor, much lighter than the one that strikes it from above; both may have flown a long way.
Scene light_between(Dice& dice) {
  const auto contacts = some_contacts(dice, {.rigid = false, .adhesion = false});
  const double lightness = dice.between(1e-3, 1), aside = 0.3 * radius * dice.uniform(-1, 1);
  const double gap = dice.chance(0.5) ? 0 : radius * dice.between(1e-4, 3);
  const double apart = 2 * radius + contacts.depth * dice.between(1, 30);
  const auto floor = gap == 0 ? touching("\"plane 1\"", "1") : "";
  return scene_of(2, contacts,
                  body(dice, {0, radius + gap}, {0, 0}, some_spin(dice), ball, lightness) +
                      body(dice, {aside, radius + gap + std::sqrt(apart * apart - aside * aside)},
                           {0.1 * speed * dice.uniform(-1, 1), -speed}, some_spin(dice), ball) +
                      floor_in_plane + floor,
                  40 * contacts.time + 2 * gap / speed);
}

/// A ball between a resting floor and a wall that moves.
Scene moving_wall(Dice& dice) {
  const auto contacts = some_contacts(dice, {.rigid = false, .adhesion = false, .overdamped = false});
  const auto wall = fmt::format("[[bodies.plane]]\npoint = [{}, 0]\nnormal = [-1, 0]\nvelocity = [{}, {}]\n",
                                exact(1.5 * radius), exact(-speed * dice.uniform(0, 1)),
                                exact(speed * dice.uniform(-1, 1)));
  return scene_of(2, contacts,
                  body(dice, {0, 1.2 * radius}, {speed, -speed * dice.uniform(0, 1)}, some_spin(dice), ball) +
                      floor_in_plane + wall,
                  3 * radius / speed);
}

}  // namespace

std::vector<Family> friction_families() {
  return {{"oblique ball", oblique_ball},    {"two balls", two_balls},
          {"row with friction", struck_row}, {"ring", ring},
          {"dropped body", dropped},         {"on the floor", on_the_floor},
          {"light between", light_between},  {"moving wall", moving_wall}};
}

}  // namespace mariotte::stress_study
