#include "mariotte/scene/toml_value.hpp"

#include <cstddef>
#include <string>

namespace mariotte::scene {
namespace {

constexpr std::string_view decimals = "0123456789";

bool take(std::string_view& rest, std::string_view one_of) {
  if (rest.empty() || one_of.find(rest.front()) == std::string_view::npos) return false;
  rest.remove_prefix(1);
  return true;
}

/// Digits with single _ between them.
bool take_digits(std::string_view& rest, std::string_view digits) {
  do {
    if (!take(rest, digits)) return false;
    while (take(rest, digits)) continue;
  } while (take(rest, "_"));
  return true;
}

bool is_integer_of_base(std::string_view word) {
  const std::string_view digits = word.starts_with("0x")   ? "0123456789abcdefABCDEF"
                                  : word.starts_with("0o") ? "01234567"
                                                           : "01";
  word.remove_prefix(2);
  return take_digits(word, digits) && word.empty();
}

bool is_decimal(std::string_view word) {
  take(word, "+-");
  if (word == "inf" || word == "nan") return true;
  const auto whole = word;
  if (!take_digits(word, decimals)) return false;
  if (whole.starts_with('0') && whole.size() - word.size() > 1) return false;
  if (take(word, ".") && !take_digits(word, decimals)) return false;
  if (take(word, "eE")) {
    take(word, "+-");
    if (!take_digits(word, decimals)) return false;
  }
  return word.empty();
}

}  // namespace

bool is_plain_value(std::string_view word) {
  if (word == "true" || word == "false") return true;
  if (word.size() > 2 && word[0] == '0' && std::string_view("xob").find(word[1]) != std::string_view::npos)
    return is_integer_of_base(word);
  return is_decimal(word);
}

bool lacks_digit(std::string_view word) {
  std::string padded(word);
  if (const auto point = padded.find('.'); point != std::string::npos) padded.replace(point, 1, "0.0");
  return !is_plain_value(word) && is_plain_value(padded);
}

}  // namespace mariotte::scene
