#include "mariotte/scene/sweep_shape.hpp"

#include <array>

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 7> keys{"key", "from", "to", "count", "step", "scale", "values"};
constexpr std::array<std::string_view, 2> scales{"linear", "log"};
constexpr Index most_points = 1'000'000'000;

/// A number or a string with a unit; of which dimension depends on the key and shows when the sweep is run.
void expect_value(const Source& source, const Field& field) {
  const auto& value = field.node->value;
  if (!std::holds_alternative<double>(value) && !std::holds_alternative<std::int64_t>(value) &&
      !std::holds_alternative<std::string>(value))
    reject(source, field, std::string("expected a number or a string with a unit, got ") + kind(*field.node));
}

void expect_values(const Source& source, const Field& values) {
  if (!values.node->array() || values.node->array()->empty())
    reject(source, values, "expected an array of at least one value");
  for (Index i = 0; i < static_cast<Index>(values.node->array()->size()); ++i)
    expect_value(source, element(values, i));
}

void expect_range(const Source& source, const Field& sweep) {
  for (const auto* key : {"from", "to"}) {
    const auto field = find(sweep, key);
    if (!field) reject(source, sweep, "'" + std::string(key) + "' is missing (or give 'values')");
    expect_value(source, *field);
  }
  const auto count = find(sweep, "count");
  const auto step = find(sweep, "step");
  if (bool(count) == bool(step)) reject(source, sweep, "give either 'count' or 'step'");
  if (count) whole(source, *count, 1, most_points);
  if (step) expect_value(source, *step);
}

void expect_sweep(const Source& source, const Field& sweep) {
  expect_keys(source, sweep, keys);
  const auto key = find(sweep, "key");
  if (!key) reject(source, sweep, "'key' is missing (which value is swept)");
  text(source, *key);
  if (const auto scale = find(sweep, "scale")) choice(source, *scale, "scale", scales);
  const auto values = find(sweep, "values");
  if (!values) return expect_range(source, sweep);
  expect_values(source, *values);
  for (const auto* other : {"from", "to", "count", "step"})
    if (const auto field = find(sweep, other)) reject(source, *field, "does not go with 'values'");
}

}  // namespace

void expect_sweeps(const Source& source, const Field& list) {
  if (!list.node->array()) reject(source, list, "write [[sweep]], with two brackets");
  for (Index i = 0; i < static_cast<Index>(list.node->array()->size()); ++i)
    expect_sweep(source, element(list, i));
}

}  // namespace mariotte::scene
