#include "mariotte/scene/overrides.hpp"

#include "mariotte/scene/key_path.hpp"
#include "mariotte/scene/toml.hpp"

namespace mariotte::scene {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Node parse_value(std::string_view text, const Place& place) {
  Node value{std::string(text), place};
  try {
    Node document = parse_toml({}, "value = " + std::string(text));
    if (document.table()->size() == 1 && document.table()->front().key == "value")
      value = std::move(document.table()->front().node);
  } catch (const SceneError&) {
    // Not TOML: it stays a string, so that units need no quotes within the shell's.
  }
  move_to(place, value);
  return value;
}

void apply(const std::string& override, Source& source, Node& root) {
  const auto equals = override.find('=');
  const auto key = trimmed(std::string_view(override).substr(0, equals));
  const Place place = add_origin(source, "--set " + std::string(key));
  if (equals == std::string::npos) reject(source, place, fault::leads_nowhere, "expected KEY=VALUE");

  const auto value = std::string_view(override).substr(equals + 1);
  locate(source, root, key, place) = parse_value(trimmed(value), place);
}

}  // namespace

void apply(const Overrides& overrides, Source& source, Node& root) {
  for (const auto& override : overrides) apply(override, source, root);
}

}  // namespace mariotte::scene
