// Reading values out of a tree: every function either returns a checked value or throws a SceneError that
// names the key and its place.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/core/dimension.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/core/vector3.hpp"
#include "mariotte/scene/source.hpp"

namespace mariotte::scene {

/// A value of the scene and the key that leads to it, as in "chain.velocity[0]".
struct Field {
  const Node* node;
  std::string path;

  const Place& place() const { return node->place; }
};

/// Values a number may take; nan is never one.
enum class Domain {
  any,  ///< infinite, too
  finite,
  positive,  ///< and finite
  positive_or_infinite,
  not_negative,  ///< and finite
};

[[noreturn]] void reject(const Source& source, const Field& field, Fault fault, const std::string& message);
void warn(Source& source, const Field& field, const std::string& message);

/// The value of a key, if the table has it, and is one.
std::optional<Field> find(const Field& table, std::string_view key);

/// Element of an array. `array` must be one, and long enough.
Field element(const Field& array, Index index);

/// Rejects what is no table, or has keys that are not among the known ones.
void expect_keys(const Source& source, const Field& table, std::span<const std::string_view> known);

/// A number, or a string with a unit of this dimension [SI].
double number(const Source& source, const Field& field, const Dimension& dimension, Domain domain);

/// The same of a key that may be missing.
double optional_number(const Source& source, const Field& table, const char* key, const Dimension& dimension,
                       Domain domain, double otherwise);

/// An array of such numbers.
std::vector<double> numbers(const Source& source, const Field& array, const Dimension& dimension,
                            Domain domain);

/// Rejects an array that has another length than it needs.
void expect_length(const Source& source, const Field& array, std::size_t length, std::size_t wanted);

/// A whole number between `least` and `most`.
Index whole(const Source& source, const Field& field, Index least, Index most);

/// An array of three finite numbers of this dimension.
Vector3 read_vector(const Source& source, const Field& field, const Dimension& dimension);

std::string text(const Source& source, const Field& field);
bool boolean(const Source& source, const Field& field);

/// Index of a string among the known ones; `noun` is what they are ("law").
std::size_t choice(const Source& source, const Field& field, const char* noun,
                   std::span<const std::string_view> known);

}  // namespace mariotte::scene
