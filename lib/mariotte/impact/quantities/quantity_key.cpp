#include "mariotte/impact/quantities/quantity_key.hpp"

#include <charconv>

namespace mariotte::impact {
namespace {

constexpr std::string_view count_ending = ".count";

/// The index that stands between brackets.
std::optional<Index> parse_index(std::string_view text) {
  if (text == "*") return every_index;
  Index index = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return index < 0 ? from_end(index) : index;
}

}  // namespace

std::optional<Key> parse_key(std::string_view text) {
  Key key;
  key.counts = text.ends_with(count_ending);
  if (key.counts) text.remove_suffix(count_ending.size());
  while (!text.empty()) {
    const auto open = std::min(text.find('['), text.size());
    key.pattern += text.substr(0, open);
    if (open == text.size()) break;
    const auto close = text.find(']', open);
    if (close == std::string_view::npos || key.indices.size() == Indices().size()) return std::nullopt;
    const auto index = parse_index(text.substr(open + 1, close - open - 1));
    if (!index) return std::nullopt;
    key.indices.push_back(*index);
    key.pattern += "[]";
    text.remove_prefix(close + 1);
  }
  if (key.counts) key.pattern += "[]";
  return key;
}

double number(const Value& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* index = std::get_if<Index>(&value)) return static_cast<double>(*index);
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mariotte::impact
