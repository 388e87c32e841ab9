#include "mariotte/scene/drive_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mariotte/core/error.hpp"
#include "mariotte/model/fault.hpp"
#include "mariotte/scene/table_columns.hpp"

namespace mariotte::scene {
namespace {

using model::Driven;

constexpr std::array<std::string_view, 11> drive_keys{"end",      "number",    "direction",    "quantity",
                                                      "signal",   "amplitude", "frequency",    "phase",
                                                      "duration", "table",     "interpolation"};
constexpr std::array<std::string_view, 3> quantities{"position", "velocity", "force"};
constexpr std::array<std::string_view, 3> signals{"sine", "pulse", "table"};
constexpr std::array<std::string_view, 2> ends{"left", "right"};
constexpr std::array<std::string_view, 2> interpolations{"monotone", "linear"};
constexpr std::array dimensions{dimension::length, dimension::velocity, dimension::stiffness(0)};

/// The keys that each signal takes.
constexpr std::array<std::array<std::string_view, 3>, 3> keys_of{
    {{"amplitude", "frequency", "phase"}, {"amplitude", "duration", ""}, {"table", "interpolation", ""}}};

Field needed(const Source& source, const Field& table, const char* key) {
  if (const auto field = find(table, key)) return *field;
  reject(source, table, fault::missing, std::string("'") + key + "' is missing");
}

void expect_keys_of(const Source& source, const Field& table, std::size_t signal) {
  for (const auto& others : keys_of)
    for (const auto key : others) {
      const auto& own = keys_of[signal];
      if (key.empty() || std::find(own.begin(), own.end(), key) != own.end()) continue;
      if (const auto field = find(table, key))
        reject(source, *field, fault::misplaced,
               "does not belong to the signal '" + std::string(signals[signal]) + "'");
    }
}

model::Signal read_table(const Source& source, const Field& table, std::size_t quantity) {
  const auto path = needed(source, table, "table");
  const auto form = find(table, "interpolation");
  const bool linear = form && choice(source, *form, "interpolation", interpolations) == 1;
  std::vector<model::SignalPoint> points;
  const auto columns = read_columns(source, path, {"time", dimension::time},
                                    {std::string(quantities[quantity]), dimensions[quantity]});
  for (const auto& row : columns.rows) points.push_back({row.first, row.second});
  if (const auto fall = model::first_fall(points))
    reject(columns.file, columns.rows[*fall].place, fault::impossible, std::string(model::rule_of_signal));
  try {
    return linear ? model::straight_lines(points) : model::smooth_curve(points);
  } catch (const InvalidParameter& error) {
    reject(source, path, error.fault, error.what());
  }
}

/// Periods per time; an angle per time is 2π times as much.
double read_frequency(const Source& source, const Field& field) {
  const auto* text = std::get_if<std::string>(&field.node->value);
  for (const char* angle : {"rad", "deg"})
    if (text && text->find(angle) != std::string::npos)
      reject(source, field, fault::wrong_dimension,
             "counts periods, as \"10 Hz\"; an angular frequency is 2π times as much");
  return number(source, field, dimension::rate, Domain::positive);
}

model::Signal read_signal(const Source& source, const Field& table, std::size_t quantity) {
  const auto signal = choice(source, needed(source, table, "signal"), "signal", signals);
  expect_keys_of(source, table, signal);
  if (signals[signal] == "table") return read_table(source, table, quantity);
  const double amplitude =
      number(source, needed(source, table, "amplitude"), dimensions[quantity], Domain::finite);
  if (signals[signal] == "pulse")
    return model::half_sine(
        amplitude, number(source, needed(source, table, "duration"), dimension::time, Domain::positive));
  const double frequency = read_frequency(source, needed(source, table, "frequency"));
  const double phase = optional_number(source, table, "phase", dimension::none, Domain::finite, 0);
  return model::sine(amplitude, 2 * std::numbers::pi * frequency, phase);
}

/// All of a drive but what it moves.
model::Drive read_drive(const Source& source, const Field& table) {
  expect_keys(source, table, drive_keys);
  const auto quantity = choice(source, needed(source, table, "quantity"), "quantity", quantities);
  model::Drive drive{.direction = {},
                     .quantity = static_cast<Driven>(quantity),
                     .signal = read_signal(source, table, quantity)};
  if (!std::isfinite(start_velocity(drive) + start_force(drive)))
    reject(source, table, fault::unrepresentable, "is too fast for double precision");
  return drive;
}

void refuse_keys(const Source& source, const Field& table, std::initializer_list<const char*> others,
                 const char* why) {
  for (const auto* key : others)
    if (const auto field = find(table, key)) reject(source, *field, fault::misplaced, why);
}

}  // namespace

std::vector<Field> drive_tables(const Field& whole) {
  const auto field = find(whole, "drive");
  if (!field) return {};
  if (!field->node->array()) return {*field};
  std::vector<Field> tables;
  for (Index k = 0; k < std::ssize(*field->node->array()); ++k) tables.push_back(element(*field, k));
  return tables;
}

std::vector<model::Drive> read_drives(const Source& source, const Field& chain, std::span<Ball> balls) {
  std::vector<model::Drive> drives;
  for (const auto& table : drive_tables(chain)) {
    auto drive = read_drive(source, table);
    refuse_keys(source, table, {"number", "direction"}, "is for networks; a chain is driven at an 'end'");
    const auto end = needed(source, table, "end");
    const Index i = choice(source, end, "end", ends) == 0 ? 0 : std::ssize(balls) - 1;
    drive.direction = {{i, 1.0}};
    if (drive.quantity != Driven::force) {
      if (model::prescribes(drives, i))
        reject(source, end, fault::contradiction, "another drive moves this end already");
      balls[i].mass = infinity;
      balls[i].velocity = start_velocity(drive);
    } else if (std::isinf(*balls[i].mass)) {
      reject(source, end, fault::impossible, "a force moves no wall");
    }
    drives.push_back(std::move(drive));
  }
  return drives;
}

namespace {

/// Unit vector of the coordinates of ball i.
ContactDirection ball_direction(const Source& source, const Field& table, Index i, Index dimension) {
  const auto field = needed(source, table, "direction");
  const auto values = numbers(source, field, dimension::none, Domain::finite);
  expect_length(source, field, values.size(), static_cast<std::size_t>(dimension));
  double length = 0;
  for (const double value : values) length = std::hypot(length, value);
  if (!(length > 0)) reject(source, field, fault::out_of_range, "must not be zero");
  ContactDirection direction;
  for (Index k = 0; k < dimension; ++k) direction.push_back({i * dimension + k, values[k] / length});
  return direction;
}

void prescribe(const Source& source, const Field& number, const model::Drive& drive, model::Network& model) {
  const bool diagonal = model::is_diagonal(model.mass, std::ssize(model.velocity));
  for (const auto& [dof, coefficient] : drive.direction) {
    const bool wall = diagonal && std::isinf(model.mass[dof]);
    if (wall == (drive.quantity == Driven::force))
      reject(source, number, fault::impossible,
             wall ? "a force moves nothing of infinite mass" : "what moves as prescribed needs mass = inf");
    if (wall) model.velocity[dof] = coefficient * start_velocity(drive);
  }
}

}  // namespace

void read_drives(const Source& source, const Field& network, model::Network& model) {
  for (const auto& table : drive_tables(network)) {
    auto drive = read_drive(source, table);
    refuse_keys(source, table, {"end"}, "is for chains; a network is driven at a 'number'");
    const auto field = needed(source, table, "number");
    const Index width = model.dimension > 0 ? model.dimension : 1;
    const Index i = whole(source, field, 1, std::ssize(model.velocity) / width) - 1;
    if (model.dimension > 0) {
      drive.direction = ball_direction(source, table, i, model.dimension);
    } else {
      refuse_keys(source, table, {"direction"}, "is for balls");
      drive.direction = {{i, 1.0}};
    }
    prescribe(source, field, drive, model);
    model.drive.push_back(std::move(drive));
  }
}

}  // namespace mariotte::scene
