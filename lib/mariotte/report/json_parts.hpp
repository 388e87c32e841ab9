// Pieces that every JSON result is made of.
#pragma once
#include <optional>
#include <string>

#include "mariotte/report/json.hpp"

namespace mariotte::report {

inline Json nullable(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class Values, class Write>
Json list(const Values& values, const Write& write) {
  Json array = Json::array();
  for (const auto& value : values) array.push_back(write(value));
  return array;
}

/// What computed the result, and of which scene; null where there was none.
Json provenance_json(const std::string& scene_sha256);

}  // namespace mariotte::report
