// The stored references of chains and bodies: JSON files of cases in extended precision.
#pragma once
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace mariotte::measuring {

/// The "cases" of a file by its name, such as "chain/triplets". Throws std::out_of_range if it is not among
/// the stored ones.
const nlohmann::json& cases(const std::string& name);

/// Equal up to the rounding of a number that was written and read.
bool same(double a, double b);

/// The first case of a file that `matches`. Throws std::out_of_range if there is none.
template <class Matches>
const nlohmann::json& find_case(const std::string& name, const Matches& matches) {
  for (const auto& one : cases(name))
    if (matches(one)) return one;
  throw std::out_of_range("there is no such reference in " + name);
}

}  // namespace mariotte::measuring
