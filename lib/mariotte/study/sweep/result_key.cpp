#include "mariotte/study/sweep/result_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>

#include "mariotte/core/nearest.hpp"

namespace mariotte::study {
namespace {

constexpr std::size_t most_elements = 16;  // of a longer array the ends stand for all, unless asked

std::vector<std::string> steps(std::string_view key) {
  std::vector<std::string> all;
  for (std::size_t from = 0; from <= key.size();) {
    const auto to = std::min(key.find_first_of(".[]", from), key.size());
    if (to > from) all.emplace_back(key.substr(from, to - from));
    from = to + 1;
  }
  return all;
}

/// Element of an array, the first one for an index beyond its end; nullptr if it has none.
const Json* element(const Json& array, const std::string& step, const std::string& key) {
  std::size_t index = 0;
  const auto [stop, error] = std::from_chars(step.data(), step.data() + step.size(), index);
  if (error != std::errc() || stop != step.data() + step.size())
    throw ColumnError(fmt::format("'{}' needs an index in brackets, from 0, or * for all", key));
  if (array.empty()) return nullptr;
  return &array[index < array.size() ? index : 0];
}

const Json& member(const Json& node, const std::string& step, const std::string& key) {
  std::vector<std::string> known;
  if (node.is_object())
    for (const auto& [name, value] : node.items()) known.push_back(name);
  if (std::find(known.begin(), known.end(), step) != known.end()) return node[step];
  const std::vector<std::string_view> names(known.begin(), known.end());
  throw ColumnError(fmt::format("no result has '{}'{}", key, suggestion(step, names)));
}

/// Throws ColumnError unless a result like this one has a number there.
void expect_number(const std::string& key, const Json& example) {
  const Json* node = &example;
  for (const auto& step : steps(key)) {
    if (node->is_array() && step == "count") return;
    node = node->is_array() ? element(*node, step, key) : &member(*node, step, key);
    if (!node) return;
  }
  if (node->is_array()) element(*node, "", key);
  if (!node->is_number() && !node->is_null()) throw ColumnError(fmt::format("'{}' is no number", key));
}

void expand(const std::string& key, const Json& example, std::vector<std::string>& expanded) {
  const auto star = key.find("[*]");
  if (star == std::string::npos) {
    expect_number(key, example);
    expanded.push_back(key);
    return;
  }
  const auto count = key.substr(0, star) + ".count";
  expect_number(count, example);
  const double size = number(example, result_key(count));
  for (std::size_t i = 0; static_cast<double>(i) < size; ++i)
    expand(std::string(key).replace(star, 3, fmt::format("[{}]", i)), example, expanded);
}

/// The numbers that say most, of whatever kind the result is.
std::vector<std::string> default_keys(const Json& example) {
  std::vector<std::string> keys;
  for (const auto* name : {"final.velocity", "final.spin", "icr"})
    if (const double size = number(example, result_key(std::string(name) + ".count")); size > most_elements)
      keys.insert(keys.end(), {fmt::format("{}[0]", name), fmt::format("{}[{:.0f}]", name, size - 1)});
    else if (size > 0)
      keys.push_back(fmt::format("{}[*]", name));
  for (const auto* name : {"restitution.tip", "restitution.centre", "energy.final"})
    if (example.contains(result_key(name).pointer)) keys.emplace_back(name);
  return keys;
}

}  // namespace

ResultKey result_key(const std::string& key) {
  auto all = steps(key);
  const bool counts = !all.empty() && all.back() == "count";
  if (counts) all.pop_back();
  Json::json_pointer pointer;
  for (const auto& step : all) pointer /= step;
  return {.pointer = pointer, .counts = counts};
}

double number(const Json& result, const ResultKey& key) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!result.contains(key.pointer)) return none;
  const Json& value = result[key.pointer];
  if (key.counts) return value.is_array() ? static_cast<double>(value.size()) : none;
  return value.is_number() ? value.get<double>() : none;
}

std::vector<std::string> expand_columns(const std::vector<std::string>& keys, const Json& example) {
  std::vector<std::string> expanded;
  for (const auto& key : keys.empty() ? default_keys(example) : keys) expand(key, example, expanded);
  std::set<std::string> known;
  std::erase_if(expanded, [&](const auto& key) { return !known.insert(key).second; });
  return expanded;
}

}  // namespace mariotte::study
