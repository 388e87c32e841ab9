// Contact laws by name and parameters, or from the materials of the balls that touch.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/scene/balls.hpp"
#include "mariotte/scene/restitution.hpp"

namespace mariotte::scene {

/// Keys that say what the law of a contact is.
inline constexpr std::array<std::string_view, 17> law_keys{"law",
                                                           "stiffness",
                                                           "damping",
                                                           "exponent",
                                                           "restitution",
                                                           "at",
                                                           "relaxation_time",
                                                           "separation",
                                                           "loading_stiffness",
                                                           "unloading_stiffness",
                                                           "effective_modulus",
                                                           "effective_radius",
                                                           "yield_pressure",
                                                           "work_of_adhesion",
                                                           "damping_hertz",
                                                           "damping_adhesion",
                                                           "table"};

/// Those and others, for lists of the keys that a table knows.
template <std::size_t n>
constexpr std::array<std::string_view, law_keys.size() + n> law_keys_and(
    const std::array<std::string_view, n>& others) {
  std::array<std::string_view, law_keys.size() + n> all{};
  std::copy(law_keys.begin(), law_keys.end(), all.begin());
  std::copy(others.begin(), others.end(), all.begin() + law_keys.size());
  return all;
}

/// Everything a scene says of laws: keys of the whole, one value or one per contact, and tables of contacts:
/// none, one for all, one per contact, or some that say their number.
struct LawTables {
  Field whole;
  std::vector<Field> contacts;
  std::map<Index, Field> numbered = {};

  /// The table of one contact, or the whole.
  const Field& place_of(Index contact) const {
    if (const auto found = numbered.find(contact); found != numbered.end()) return found->second;
    return contacts.empty() ? whole : contacts[contacts.size() == 1 ? 0 : contact];
  }
  /// What the scene says of one contact under one key; a list too short stands for itself, and is no value.
  std::optional<Field> find_for(Index contact, std::string_view key) const {
    if (auto own = find(place_of(contact), key); own && &place_of(contact) != &whole) return own;
    auto common = find(whole, key);
    const auto* const list = common ? common->node->array() : nullptr;
    return list && contact < std::ssize(*list) ? element(*common, contact) : common;
  }
};

/// The balls that a contact joins; null where it joins none.
struct BallPair {
  const Ball* left;
  const Ball* right;
};

/// What turns a restitution into a damping: the bodies of each contact, and what was found before.
struct Encounters {
  std::function<double(Index contact)> reduced_mass;  ///< asked for only where it is needed
  double speed = 0;                                   ///< the largest of approach [m/s]
  DampingSolver solver = {};
};

/// Throws SceneError.
contact::Law read_law(const Source& source, const LawTables& tables, Index contact, const BallPair& pair,
                      Encounters& encounters);

/// Rejects lists under keys of a table that have one value for all contacts; `why` ends the sentence.
void expect_no_lists(const Source& source, const Field& table, std::span<const std::string_view> keys,
                     const std::string& why);

/// Throws SceneError for what the first laws have wrong, whatever they are between.
void check_laws(const Source& source, const LawTables& tables, Index count);

}  // namespace mariotte::scene
