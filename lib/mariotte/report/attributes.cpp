#include "mariotte/report/attributes.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace mariotte::report {
namespace {

std::string words(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const auto& one : value) text += (text.empty() ? "" : "; ") + words(one);
  return text;
}

}  // namespace

Attributes attributes(const Json& provenance) {
  Attributes all = {{"program", "mariotte"}};
  for (const auto& [name, value] : provenance.items()) all.emplace_back(name, words(value));
  return all;
}

}  // namespace mariotte::report
