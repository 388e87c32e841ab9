#include "mariotte/scene/sweep_shape.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 14> sweep_keys{
    "key",    "variable", "from",   "to",     "count", "step",      "scale",
    "values", "zip",      "random", "design", "mean",  "deviation", "expression"};
constexpr std::array<std::string_view, 3> designs{"random", "latin", "sobol"};
constexpr std::array<std::string_view, 2> scales{"linear", "log"};
constexpr Index largest_seed = 1'000'000'000'000'000;  // still a whole number in a double

/// A number, a string, which may carry a unit, or true or false; of which dimension depends on the key and
/// shows when the sweep is run.
void expect_value(const Source& source, const Field& field) {
  const auto& value = field.node->value;
  if (!std::holds_alternative<double>(value) && !std::holds_alternative<std::int64_t>(value) &&
      !std::holds_alternative<std::string>(value) && !std::holds_alternative<bool>(value))
    reject(source, field, fault::wrong_type,
           std::string("expected a number or a string, got ") + kind(*field.node));
}

void expect_values(const Source& source, const Field& values) {
  if (!values.node->array() || values.node->array()->empty())
    reject(source, values, fault::wrong_type, "expected an array of at least one value");
  for (Index i = 0; i < static_cast<Index>(values.node->array()->size()); ++i)
    expect_value(source, element(values, i));
}

void expect_random(const Source& source, const Field& sweep, const Field& seed) {
  whole(source, seed, 0, largest_seed);
  if (const auto step = find(sweep, "step"))
    reject(source, *step, fault::misplaced, "does not go with 'random'");
}

/// Keys that mean nothing beside another.
void expect_without(const Source& source, const Field& sweep, const std::string& key,
                    std::initializer_list<const char*> others) {
  for (const auto* other : others)
    if (const auto field = find(sweep, other))
      reject(source, *field, fault::misplaced, "does not go with '" + key + "'");
}

/// A normal distribution has no ends.
void expect_normal(const Source& source, const Field& sweep) {
  for (const auto* key : {"mean", "deviation", "count", "random"})
    if (!find(sweep, key))
      reject(source, sweep, fault::missing,
             "'" + std::string(key) +
                 "' is missing (a normal distribution needs mean, deviation, count, random)");
  expect_without(source, sweep, "mean", {"from", "to", "step", "scale"});
  expect_value(source, *find(sweep, "mean"));
  expect_value(source, *find(sweep, "deviation"));
  whole(source, *find(sweep, "count"), 1, most_points);
  expect_random(source, sweep, *find(sweep, "random"));
}

void expect_range(const Source& source, const Field& sweep) {
  if (find(sweep, "mean") || find(sweep, "deviation")) return expect_normal(source, sweep);
  for (const auto* key : {"from", "to"}) {
    const auto field = find(sweep, key);
    if (!field)
      reject(source, sweep, fault::missing, "'" + std::string(key) + "' is missing (or give 'values')");
    expect_value(source, *field);
  }
  const auto count = find(sweep, "count");
  const auto step = find(sweep, "step");
  if (bool(count) == bool(step))
    reject(source, sweep, count ? fault::contradiction : fault::missing, "give either 'count' or 'step'");
  if (count) whole(source, *count, 1, most_points);
  if (step) expect_value(source, *step);
  if (const auto seed = find(sweep, "random")) expect_random(source, sweep, *seed);
}

/// A word that expressions can hold: letters, digits and _, no digit first.
void expect_word(const Source& source, const Field& variable) {
  const auto word = text(source, variable);
  const auto may_stand = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  if (word.empty() || std::isdigit(static_cast<unsigned char>(word[0])) ||
      !std::all_of(word.begin(), word.end(), may_stand))
    reject(source, variable, fault::out_of_range, "needs a name of letters, digits and _");
}

void expect_expression(const Source& source, const Field& sweep, const Field& expression) {
  text(source, expression);
  expect_without(
      source, sweep, "expression",
      {"variable", "from", "to", "count", "step", "scale", "values", "zip", "random", "mean", "deviation"});
}

/// What the table is about.
void expect_subject(const Source& source, const Field& sweep) {
  const auto key = find(sweep, "key"), variable = find(sweep, "variable");
  if (bool(key) == bool(variable))
    reject(source, sweep, key ? fault::contradiction : fault::missing,
           key ? "give either 'key' or 'variable'" : "'key' is missing (which value is swept)");
  if (key) text(source, *key);
  if (variable) expect_word(source, *variable);
}

void expect_design(const Source& source, const Field& sweep, const Field& design) {
  choice(source, design, "design", designs);
  if (!find(sweep, "random")) reject(source, design, fault::missing, "needs 'random', a seed");
}

void expect_sweep(const Source& source, const Field& sweep) {
  expect_keys(source, sweep, sweep_keys);
  expect_subject(source, sweep);
  if (const auto design = find(sweep, "design")) expect_design(source, sweep, *design);
  if (const auto expression = find(sweep, "expression")) return expect_expression(source, sweep, *expression);
  if (const auto scale = find(sweep, "scale")) choice(source, *scale, "scale", scales);
  if (const auto zip = find(sweep, "zip")) boolean(source, *zip);
  const auto values = find(sweep, "values");
  if (!values) return expect_range(source, sweep);
  expect_values(source, *values);
  expect_without(source, sweep, "values", {"from", "to", "count", "step", "random", "mean", "deviation"});
}

}  // namespace

void expect_sweeps(const Source& source, const Field& list) {
  if (!list.node->array()) reject(source, list, fault::wrong_type, "write [[sweep]], with two brackets");
  for (Index i = 0; i < static_cast<Index>(list.node->array()->size()); ++i)
    expect_sweep(source, element(list, i));
}

void expect_columns(const Source& source, const Field& columns) {
  if (!columns.node->array() || columns.node->array()->empty())
    reject(source, columns, fault::wrong_type, "expected an array of at least one result key");
  for (Index i = 0; i < static_cast<Index>(columns.node->array()->size()); ++i)
    text(source, element(columns, i));
}

}  // namespace mariotte::scene
