#include "mariotte/scene/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/core/counted.hpp"
#include "mariotte/core/nearest.hpp"
#include "mariotte/core/quantity.hpp"
#include "mariotte/scene/error_list.hpp"

namespace mariotte::scene {
namespace {

std::string joined(std::string_view path, std::string_view key) {
  return path.empty() ? std::string(key) : std::string(path) + "." + std::string(key);
}

/// "key: message", without the key where the place says it already.
std::string named(const Source& source, const Field& field, const std::string& message) {
  return where(source, field.place()).ends_with(" " + field.path) ? message : field.path + ": " + message;
}

[[noreturn]] void wrong_type(const Source& source, const Field& field, const std::string& wanted) {
  reject(source, field, fault::wrong_type, "expected " + wanted + ", got " + kind(*field.node));
}

void tell(ReadingLog& watch, const Node* node, const Dimension& dimension) {
  for (auto& reading : watch.readings)
    if (reading.node == node) reading.dimension = dimension;
}

void tell_text(ReadingLog& watch, const Node* node) {
  for (auto& reading : watch.readings)
    if (reading.node == node) reading.is_text = true;
}

double value_of(const Source& source, const Field& field, const Dimension& dimension) {
  if (source.watch) tell(*source.watch, field.node, dimension);
  if (const auto* real = std::get_if<double>(&field.node->value)) return *real;
  if (const auto* integer = std::get_if<std::int64_t>(&field.node->value))
    return static_cast<double>(*integer);
  if (const auto* quantity = std::get_if<std::string>(&field.node->value)) try {
      return parse_quantity(*quantity, dimension);
    } catch (const QuantityError& error) {
      reject(source, field, error.fault, error.what());
    }
  wrong_type(source, field, describe(dimension));
}

/// What is wrong with the value, or nullptr.
const char* objection(double value, Domain domain) {
  if (std::isnan(value)) return "must not be nan";
  if (domain == Domain::any) return nullptr;
  if (std::isinf(value) && !(domain == Domain::positive_or_infinite && value > 0)) return "must be finite";
  if (domain == Domain::finite) return nullptr;
  if (domain == Domain::not_negative) return value < 0 ? "must not be negative" : nullptr;
  return value > 0 ? nullptr : "must be positive";
}

std::string one_of(std::span<const std::string_view> known) {
  if (known.size() == 1) return " (it can only be '" + std::string(known.front()) + "')";
  std::string text;
  for (const auto word : known) text += (text.empty() ? " (one of: " : ", ") + std::string(word);
  return text + ")";
}

/// Keys that people look for in another table than theirs.
std::string elsewhere(std::string_view key) {
  struct Home {
    std::string_view key, hint;
  };
  constexpr std::string_view
      run = " (it belongs to [run])",
      material = " (it belongs to a material: material = { young = \"210 GPa\", ... })",
      top = " (it belongs above the first table)",
      incidence = " (it belongs to [incidence], beside a [body])",
      surface = " (it belongs to [surface], beside a [body])",
      sized = " (it belongs to what has that size: [chain], [network], [body] or [bodies])";
  constexpr std::array homes{
      Home{"accuracy", run},
      Home{"max_time", run},
      Home{"max_events", run},
      Home{"flow", run},
      Home{"until", run},
      Home{"impacts", " (it belongs to [run], beside a [body])"},
      Home{"title", top},
      Home{"columns", top},
      Home{"law", " (it belongs to the contacts: [chain], [network] or [bodies])"},
      Home{"gap", " (it belongs to [chain]: gap = [0, \"1 um\"] has one value per contact)"},
      Home{"young", material},
      Home{"poisson", material},
      Home{"density", material},
      Home{"yield_strength", material},
      Home{"angles", incidence},
      Home{"normal_speed", incidence},
      Home{"tangential_velocity", incidence},
      Home{"zeta_hertz", surface},
      Home{"zeta_adhesion", surface},
      Home{"damping_hertz", surface},
      Home{"damping_adhesion", surface},
      Home{"work_of_adhesion", surface},
      Home{"balls", " (it belongs to [chain])"},
      Home{"radius", sized},
      Home{"diameter", sized},
      Home{"friction", " (friction acts between [bodies], or on a [body]: surface.friction)"}};
  for (const auto& home : homes)
    if (key == home.key) return std::string(home.hint);
  return "";
}

}  // namespace

void reject(const Source& source, const Field& field, Fault fault, const std::string& message) {
  reject(source, field.place(), fault, named(source, field, message), field.path);
}

void warn(Source& source, const Field& field, const std::string& message) {
  warn(source, field.place(), named(source, field, message));
}

std::optional<Field> find(const Field& table, std::string_view key) {
  const auto* const entries = table.node->table();
  const Entry* const entry = entries ? find(*entries, key) : nullptr;
  if (!entry) return {};
  return Field{&entry->node, joined(table.path, key)};
}

Field element(const Field& array, Index index) {
  return {&(*array.node->array())[static_cast<std::size_t>(index)],
          array.path + "[" + std::to_string(index) + "]"};
}

void expect_keys(const Source& source, const Field& table, std::span<const std::string_view> known) {
  if (!table.node->table()) wrong_type(source, table, "a table");
  ErrorList errors;
  for (const auto& entry : *table.node->table())
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      errors.attempt([&] {
        const auto hint = elsewhere(entry.key), path = joined(table.path, entry.key);
        reject(source, entry.place, fault::unknown_key,
               "unknown key '" + path + "'" + (hint.empty() ? suggestion(entry.key, known) : hint), path);
      });
  errors.raise();
}

double number(const Source& source, const Field& field, const Dimension& dimension, Domain domain) {
  const double value = value_of(source, field, dimension);
  if (const char* const complaint = objection(value, domain))
    reject(source, field, fault::out_of_range, complaint);
  return value;
}

double optional_number(const Source& source, const Field& table, const char* key, const Dimension& dimension,
                       Domain domain, double otherwise) {
  const auto field = find(table, key);
  return field ? number(source, *field, dimension, domain) : otherwise;
}

std::vector<double> numbers(const Source& source, const Field& array, const Dimension& dimension,
                            Domain domain) {
  if (!array.node->array()) wrong_type(source, array, "an array");
  std::vector<double> values;
  for (Index i = 0; i < std::ssize(*array.node->array()); ++i)
    values.push_back(number(source, element(array, i), dimension, domain));
  return values;
}

void expect_length(const Source& source, const Field& array, std::size_t length, std::size_t wanted) {
  if (length != wanted)
    reject(source, array, fault::wrong_length,
           "needs " + counted(wanted, "value") + ", has " + std::to_string(length));
}

Index whole(const Source& source, const Field& field, Index least, Index most) {
  const double value = value_of(source, field, dimension::none);
  if (value != std::floor(value)) reject(source, field, fault::out_of_range, "must be a whole number");
  // The limits are far below 2^53, so nothing is lost in a double.
  if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)))
    reject(source, field, fault::out_of_range,
           "must be between " + std::to_string(least) + " and " + std::to_string(most));
  return static_cast<Index>(value);
}

Vector3 read_vector(const Source& source, const Field& field, const Dimension& dimension) {
  if (!field.node->array() || field.node->array()->size() != 3)
    reject(source, field, fault::wrong_length, "expected an array of three values");
  const auto at = [&](Index i) { return number(source, element(field, i), dimension, Domain::finite); };
  return {at(0), at(1), at(2)};
}

/// A terminal would take it for a command.
bool is_control(char c) {
  return (c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r') || c == '\x7f';
}

std::string text(const Source& source, const Field& field) {
  const auto* const value = std::get_if<std::string>(&field.node->value);
  if (!value) wrong_type(source, field, "a string");
  if (std::any_of(value->begin(), value->end(), is_control))
    reject(source, field, fault::wrong_type, "has a control character");
  if (source.watch) tell_text(*source.watch, field.node);
  return *value;
}

bool boolean(const Source& source, const Field& field) {
  const auto* const value = std::get_if<bool>(&field.node->value);
  if (!value) wrong_type(source, field, "true or false");
  return *value;
}

std::size_t choice(const Source& source, const Field& field, const char* noun,
                   std::span<const std::string_view> known) {
  const auto word = text(source, field);
  const auto found = std::find(known.begin(), known.end(), word);
  if (found == known.end())
    reject(source, field, fault::unknown_word,
           "unknown " + std::string(noun) + " '" + word + "'" + suggestion(word, known) + one_of(known));
  return static_cast<std::size_t>(found - known.begin());
}

}  // namespace mariotte::scene
