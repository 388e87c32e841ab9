#include "mariotte/scene/source.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mariotte/scene/scene.hpp"

namespace mariotte::scene {
namespace {

constexpr std::size_t longest_message = 300;
constexpr std::size_t most_warnings = 20;

bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
}

/// A message may quote the scene, which may hold line breaks, control characters or a megabyte of text.
std::string presentable(std::string text) {
  if (text.size() > longest_message) {
    std::size_t end = longest_message;
    while (end > 0 && continues_character(text[end])) --end;
    text = text.substr(0, end) + "…";
  }
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return text;
}

}  // namespace

std::string where(const Source& source, const Place& place) {
  if (place.origin >= 0) return presentable(source.origins[static_cast<std::size_t>(place.origin)]);
  return source.name + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

Place add_origin(Source& source, std::string origin) {
  source.origins.push_back(std::move(origin));
  return {.origin = static_cast<int>(source.origins.size()) - 1};
}

void reject(const Source& source, const Place& place, Fault fault, const std::string& message,
            const std::string& key) {
  SceneError error(where(source, place) + ": " + presentable(message), fault);
  error.place = where(source, place);
  if (place.origin < 0) std::tie(error.line, error.column) = std::tie(place.line, place.column);
  error.key = key;
  throw error;
}

void warn(Source& source, const Place& place, const std::string& message) {
  auto& list = source.warnings;
  auto warning = where(source, place) + ": " + presentable(message);
  if (std::find(list.begin(), list.end(), warning) != list.end()) return;
  if (list.size() < most_warnings)
    list.push_back(std::move(warning));
  else if (list.size() == most_warnings)
    list.push_back(source.name + ": more warnings of this kind are not shown");
}

}  // namespace mariotte::scene
