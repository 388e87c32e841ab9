// The laws that scenes can name: the one list that the reader, its messages and the pages follow.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/contact/tabulated.hpp"
#include "mariotte/core/dimension.hpp"

namespace mariotte::contact {

/// The numbers of a law in SI units; each law reads its own.
struct LawNumbers {
  double stiffness = 0, exponent = 1.5, damping = 0;
  double loading_stiffness = 0, unloading_stiffness = 0;
  double effective_modulus = 0, effective_radius = 0;
  double yield_pressure = 0, work_of_adhesion = 0;
  double damping_hertz = 0, damping_adhesion = 0;
  std::vector<LawPoint> points = {};
};

/// A number that scenes give a law.
struct LawKey {
  std::string_view key;
  double LawNumbers::*number;
  Dimension (*dimension)(double exponent);
  std::string_view unit;
  bool may_be_missing = false;  ///< it is 0 then
};

/// A law as scenes name it. Laws of one's own are handed to models in C++, and need no entry.
struct NamedLaw {
  std::string_view name;           ///< as scenes spell it
  std::string_view force;          ///< formula
  std::optional<double> exponent;  ///< its own; scenes choose n ≥ 1 if it has a key "exponent"
  std::span<const LawKey> keys;    ///< what it needs
  /// Damping over stiffness and relaxation time; 0 if a relaxation time says nothing of it.
  double (*relaxation)(double exponent) = nullptr;
  bool has_table = false;  ///< its points are in a file, under the key "table"
  Law (*make)(const LawNumbers& numbers);

  /// The key of that name, or null.
  const LawKey* find(std::string_view key) const;
  /// The damping that a restitution can stand for, or null.
  const LawKey* damping() const { return find("damping"); }
};

/// In the order of the pages.
extern const std::span<const NamedLaw> named_laws;

/// "linear, hertz or viscoelastic": all names, for messages; and those of laws with a damping.
std::string names_of_laws();
std::string names_of_damped_laws();

/// The law that goes on pulling until its indentation ends, instead of one that is cut off at f = 0.
Law uncut(Law law);
/// The law that it was before; another law is itself.
const Law& cut(const Law& law);
inline bool is_uncut(const Law& law) {
  return &cut(law) != &law;
}

}  // namespace mariotte::contact
