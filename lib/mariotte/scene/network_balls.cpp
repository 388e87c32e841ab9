#include "mariotte/scene/network_balls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/scene/contact_law.hpp"
#include "mariotte/scene/drive_reader.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/missed_meetings.hpp"
#include "mariotte/scene/touching.hpp"

namespace mariotte::scene {
namespace {

constexpr auto network_of_balls_keys = law_keys_and(std::array<std::string_view, 9>{
    "diameter", "ball", "mass", "radius", "material", "reach", "touching", "precompressed", "drive"});
constexpr std::array<std::string_view, 6> ball_keys{"diameter", "position", "velocity",
                                                    "mass",     "radius",   "material"};

/// The balls, with what was said of the bodies and where.
struct PlacedBalls {
  std::vector<Field> table;
  std::vector<Ball> body;
  std::vector<model::Ball> ball;
};

std::vector<double> read_coordinates(const Source& source, const Field& field, const Dimension& dimension) {
  auto values = numbers(source, field, dimension, Domain::finite);
  if (values.size() != 2 && values.size() != 3)
    reject(source, field, fault::wrong_length, "expected two values, or three");
  return values;
}

void place(const Source& source, const Field& table, Index i, PlacedBalls& balls) {
  auto& body = balls.body[i];
  const auto position = find(table, "position"), velocity = find(table, "velocity");
  if (!position) reject(source, table, fault::missing, "'position' is missing");
  if (!body.radius)
    reject(source, table, fault::missing, "ball " + std::to_string(i + 1) + " needs a radius");
  if (!std::isfinite(*body.radius))
    reject(source, table, fault::out_of_range,
           "ball " + std::to_string(i + 1) + " must have a finite radius");
  model::Ball ball{.position = read_coordinates(source, *position, dimension::length),
                   .velocity = {},
                   .mass = body.mass ? *body.mass : solid_sphere(source, table, body, i),
                   .radius = *body.radius};
  ball.velocity.assign(ball.position.size(), 0.0);
  if (velocity) {
    ball.velocity = read_coordinates(source, *velocity, dimension::velocity);
    expect_length(source, *velocity, ball.velocity.size(), ball.position.size());
  }
  body.mass = ball.mass;
  balls.ball.push_back(std::move(ball));
}

void read_ball(Source& source, const Field& table, Ball& body) {
  ErrorList errors;
  errors.attempt([&] { expect_keys(source, table, ball_keys); });
  errors.attempt([&] { read_properties(source, table, body); });
  errors.raise();
}

PlacedBalls read_placed(Source& source, const Field& network) {
  const auto list = *find(network, "ball");
  if (!list.node->array())
    reject(source, list, fault::wrong_type, "write [[network.ball]], with two brackets");
  Ball common;
  PlacedBalls balls;
  ErrorList errors;
  const bool known = errors.attempt([&] { read_properties(source, network, common); });
  for (Index i = 0; i < std::ssize(*list.node->array()); ++i) {
    const auto& table = balls.table.emplace_back(element(list, i));
    auto& body = balls.body.emplace_back(common);
    const bool own = errors.attempt_one_of_many([&] { read_ball(source, table, body); });
    if (known && own) errors.attempt_one_of_many([&] { place(source, table, i, balls); });
  }
  errors.raise();
  for (std::size_t i = 0; i < balls.ball.size(); ++i)
    expect_length(source, *find(balls.table[i], "position"), balls.ball[i].position.size(),
                  balls.ball[0].position.size());
  return balls;
}

double read_distance(const Source& source, const Field& network, std::string_view key, double standard) {
  const auto field = find(network, key);
  return field ? number(source, *field, dimension::length, Domain::not_negative) : standard;
}

double smallest_radius(const std::vector<model::Ball>& balls) {
  double least = infinity;
  for (const auto& ball : balls) least = std::min(least, ball.radius);
  return least;
}

/// Contact and gap of two balls; no direction if they are out of reach of each other.
model::BallContact contact_of(const Source& source, const PlacedBalls& balls, Index i, Index j,
                              double touching, double reach) {
  try {
    auto contact = model::ball_contact(balls.ball, i, j);
    if (std::abs(contact.gap) <= touching) contact.gap = 0;
    return contact.gap > reach ? model::BallContact{{}, contact.gap} : contact;
  } catch (const InvalidParameter& error) {
    reject(source, balls.table[j], error.fault, error.what());
  }
}

using Pairs = std::vector<std::pair<Index, Index>>;

/// The laws of contacts whose directions are known.
void read_laws(const Source& source, const LawTables& tables, const PlacedBalls& balls, const Pairs& pairs,
               model::Network& model) {
  Encounters encounters{.reduced_mass =
                            [&](Index c) {
                              const auto [i, j] = pairs[c];
                              return reduced_mass(balls.ball[i].mass, balls.ball[j].mass);
                            },
                        .speed = largest_approach(model)};
  ErrorList errors;
  for (const auto& pair : pairs)
    errors.attempt_one_of_many([&] {
      model.law.push_back(read_law(source, tables, std::ssize(model.law),
                                   {&balls.body[pair.first], &balls.body[pair.second]}, encounters));
    });
  errors.raise();
}

/// Says how far the nearest two are apart, since a `reach` of so much would do.
[[noreturn]] void reject_lonely(const Source& source, const Field& network,
                                const std::vector<model::Ball>& balls) {
  double least = infinity;
  std::string nearest;
  for (Index j = 1; j < std::ssize(balls); ++j)
    for (Index i = 0; i < j; ++i)
      if (const double gap = model::ball_contact(balls, i, j).gap; gap < least) {
        least = gap;
        nearest = fmt::format("; the nearest, {} and {}, are {:.4g} m apart", i + 1, j + 1, gap);
      }
  reject(source, network, fault::impossible,
         "no two balls are within 'reach' of each other, by default a hundredth of the smallest radius" +
             nearest);
}

void warn_of_missed_meetings(Source& source, const PlacedBalls& balls, double reach) {
  for (const auto& [i, j] : missed_meetings(balls.ball, reach))
    warn(source, balls.table[j],
         "balls " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
             " fly towards each other from beyond 'reach', and will pass through each other");
}

/// What a table of balls says of itself.
struct BallNetwork {
  PlacedBalls balls;
  double touching = 0, reach = 0;
};

BallNetwork read_balls(Source& source, const Field& network, const LawTables& tables) {
  BallNetwork read;
  ErrorList errors;
  errors.attempt([&] { expect_keys(source, network, network_of_balls_keys); });
  const bool one_law =
      errors.attempt([&] { expect_no_lists(source, network, law_keys, "for all contacts of balls"); });
  errors.attempt([&] { read.touching = read_distance(source, network, "touching", 0); });
  if (!errors.attempt([&] { read.balls = read_placed(source, network); }) && one_law)
    errors.attempt([&] { check_laws(source, tables, 1); });
  errors.attempt(
      [&] { read.reach = read_distance(source, network, "reach", 0.01 * smallest_radius(read.balls.ball)); });
  errors.raise();
  return read;
}

/// Contacts of balls that touch or are near each other.
Pairs add_contacts(Source& source, const BallNetwork& read, model::Network& model) {
  const auto& [balls, touching, reach] = read;
  Pairs pairs;
  for (const auto& [i, j] : model::near_pairs(balls.ball, std::max(reach, touching))) {
    auto [direction, gap, distance] = contact_of(source, balls, i, j, touching, reach);
    if (direction.empty()) continue;
    if (gap < 0 && !model.precompressed)
      reject(source, balls.table[j], fault::overlap,
             "balls " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
                 " overlap ('touching' is the distance taken as none; precompressed = true allows overlaps)");
    pairs.emplace_back(i, j);
    model.direction.push_back(std::move(direction));
    model.gap.push_back(gap);
    model.distance.push_back(distance);
  }
  return pairs;
}

}  // namespace

ResolvedNetwork read_ball_network(Source& source, const Field& network, bool precompressed) {
  const LawTables tables{network, {}};
  auto read = read_balls(source, network, tables);
  auto& balls = read.balls;
  ResolvedNetwork resolved{.network = model::free_balls(balls.ball), .radius = {}};
  auto& model = resolved.network;
  model.precompressed = precompressed;
  read_drives(source, network, model);
  const auto pairs = add_contacts(source, read, model);
  read_laws(source, tables, balls, pairs, model);
  for (const auto& ball : balls.ball) resolved.radius.push_back(ball.radius);
  for (const auto& [i, j] : pairs) resolved.touching.push_back(scene::touching(balls.body[i], balls.body[j]));
  warn_of_missed_meetings(source, balls, read.reach);
  if (model.law.empty()) reject_lonely(source, network, balls.ball);
  resolved.ball = std::move(balls.ball);
  resolved.reach = read.reach;
  return resolved;
}

}  // namespace mariotte::scene
