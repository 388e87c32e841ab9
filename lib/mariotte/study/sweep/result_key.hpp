// Numbers of a result by their key, which is the path to them in its JSON.
//
//     KEY = name { "." name | "[" index "]" }      indices count from 0; ".count" is the length of an array
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mariotte/core/error.hpp"
#include "mariotte/study/fault.hpp"

namespace mariotte::study {

using Json = nlohmann::ordered_json;

/// A key that no result has; what() names it and the nearest known one.
struct ColumnError : Error {
  explicit ColumnError(const std::string& what) : Error(what, fault::unknown_column) {}
};

/// A key, ready to be looked up.
struct ResultKey {
  Json::json_pointer pointer;
  bool counts = false;  ///< the elements of the array it leads to
};

ResultKey result_key(const std::string& key);

/// What the key leads to; nan if this result has nothing there, or nothing that is a number.
double number(const Json& result, const ResultKey& key);

/// The keys with `[*]` written out for a result like this one, each once: "icr[*]" as "icr[0]", "icr[1]", …;
/// without any keys, those that say most about it. Throws ColumnError for a key that leads to no number in
/// it, unless only an index is beyond the end of its array.
std::vector<std::string> expand_columns(const std::vector<std::string>& keys, const Json& example);

}  // namespace mariotte::study
