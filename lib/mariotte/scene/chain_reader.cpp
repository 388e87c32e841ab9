#include "mariotte/scene/chain_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/model/chain/equilibrium.hpp"
#include "mariotte/scene/balls.hpp"
#include "mariotte/scene/contact_law.hpp"
#include "mariotte/scene/contacts.hpp"
#include "mariotte/scene/drive_reader.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/touching.hpp"

namespace mariotte::scene {
namespace {

constexpr auto chain_keys = law_keys_and(std::array<std::string_view, 18>{
    "precompression", "start", "diameter", "taper", "repeat", "balls", "mass", "radius", "material",
    "velocity", "gap", "gravity", "wall", "wall_material", "ball", "contact", "precompressed", "drive"});

double read_gravity(const Source& source, const Field& chain, const std::optional<Field>& of_run) {
  const auto own = find(chain, "gravity");
  if (own && of_run) reject(source, *of_run, fault::contradiction, "gravity is given by 'chain.gravity' too");
  const auto field = own ? own : of_run;
  return field ? number(source, *field, dimension::acceleration, Domain::finite) : 0;
}

void expect_motion(const Source& source, const Field& chain, const model::Chain& model) {
  const auto wall = [](double mass) { return std::isinf(mass); };
  for (std::size_t i = 1; i < model.mass.size(); ++i)
    if (wall(model.mass[i - 1]) && wall(model.mass[i]))
      reject(source, find(chain, "mass").value_or(chain), fault::impossible,
             "balls " + std::to_string(i) + " and " + std::to_string(i + 1) +
                 " are both walls (of infinite mass); a contact needs a ball");
}

/// Whether the row starts in static equilibrium; then its closed contacts are indented so.
bool start_at_rest(const Source& source, const Field& chain, model::Chain& model) {
  constexpr std::array<std::string_view, 2> starts{"gaps", "equilibrium"};
  const auto start = find(chain, "start"), force = find(chain, "precompression");
  const bool by_gaps = start && choice(source, *start, "start", starts) == 0;
  if (by_gaps && force)
    reject(source, *force, fault::contradiction, "'start' says that the row starts by its gaps");
  if (by_gaps || !(start || force)) return false;
  const auto& cause = force ? *force : *start;
  if (const auto field = find(chain, "precompressed"))
    reject(source, *field, fault::contradiction, "static equilibrium says how far contacts are indented");
  const double pressure =
      optional_number(source, chain, "precompression", dimension::stiffness(0), Domain::positive, 0);
  try {
    put_at_rest(model, pressure);
  } catch (const InvalidParameter& error) {
    reject(source, cause, error.fault, error.what());
  }
  return true;
}

std::vector<double> radii(const std::vector<Ball>& balls) {
  std::vector<double> result;
  for (const auto& ball : balls) {
    if (!ball.radius) return {};
    result.push_back(*ball.radius);
  }
  return result;
}

/// Balls, drives and laws. Returns the balls. Drives and laws are read whatever the balls have wrong.
std::vector<Ball> read_parts(Source& source, const Field& chain, const Layout& layout, model::Chain& model) {
  std::vector<Ball> balls;
  ErrorList errors;
  const bool known = errors.attempt([&] { balls = read_balls(source, chain, layout); });
  if (!known) balls.assign(layout.balls(), Ball{.mass = 1, .radius = {}, .material = {}, .velocity = {}});
  errors.attempt([&] { model.drive = read_drives(source, chain, balls); });
  if (!known) errors.attempt([&] { check_laws(source, chain, layout); });
  if (known) errors.attempt([&] { model.law = read_laws(source, chain, layout, balls); });
  errors.raise();
  for (const auto& ball : balls) {
    model.mass.push_back(*ball.mass);
    model.velocity.push_back(ball.velocity.value_or(0));
  }
  return balls;
}

void read_indentations(const Source& source, const Field& chain, const Layout& layout, model::Chain& model) {
  if (const auto field = find(chain, "precompressed")) model.precompressed = boolean(source, *field);
  model.gap = read_gaps(source, chain, layout, model.precompressed);
}

}  // namespace

ResolvedChain read_chain(Source& source, const Field& chain, const std::optional<Field>& gravity) {
  if (!chain.node->table()) expect_keys(source, chain, chain_keys);  // says that it is no table
  model::Chain model;
  std::vector<Ball> balls;
  ErrorList errors;
  errors.attempt([&] { expect_keys(source, chain, chain_keys); });
  errors.attempt([&] { model.gravity = read_gravity(source, chain, gravity); });
  Layout layout;
  const auto read_rest = [&] {
    ErrorList of_rest;
    of_rest.attempt([&] { balls = read_parts(source, chain, layout, model); });
    of_rest.attempt([&] { read_indentations(source, chain, layout, model); });
    of_rest.raise();
  };
  if (errors.attempt([&] { layout = read_layout(source, chain); })) {
    errors.attempt(read_rest);
  } else {
    layout = guess_layout(chain);
    errors.attempt_on_a_guess(read_rest);
  }
  errors.raise();
  expect_motion(source, chain, model);
  const bool at_rest = start_at_rest(source, chain, model);
  return {std::move(model), radii(balls), touching(balls), at_rest};
}

}  // namespace mariotte::scene
