#include "mariotte/scene/toml_guard.hpp"

#include <string>

#include "mariotte/scene/toml_value.hpp"

namespace mariotte::scene {
namespace {

constexpr std::size_t deepest = 16;
constexpr std::string_view blanks = " \t\r\n";
constexpr char header = '(';
constexpr std::string_view word_characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_+-.:";

struct Character {
  char32_t code;
  std::size_t size;  ///< bytes; 0 if they are not UTF-8
};

/// The first character of a text that is not empty.
Character decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < size) return {0, 0};
  char32_t code = lead & (0x7f >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {0, 0};
    code = code << 6 | (byte(i) & 0x3f);
  }
  const bool overlong = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return overlong || surrogate || code > 0x10ffff ? Character{0, 0} : Character{code, size};
}

bool is_control(char32_t code) {
  return (code < 0x20 && code != '\t' && code != '\n') || code == 0x7f;
}

bool is_in(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

class Guard {
 public:
  Guard(const Source& source, std::string_view text) : source_(source), rest_(text) {}

  void run() {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);  // a byte order mark is allowed once
    while (!rest_.empty()) {
      if (rest_.front() == '#')
        skip_comment();
      else if (rest_.front() == '"' || rest_.front() == '\'')
        skip_string(rest_.front());
      else if (expects_value() && is_in(rest_.front(), word_characters))
        skip_value();
      else
        plain();
    }
  }

 private:
  void advance() {
    if (rest_.starts_with("\r\n")) rest_.remove_prefix(1);
    const auto [code, size] = decode(rest_);
    if (size == 0) reject(source_, place_, fault::not_toml, "not valid UTF-8");
    if (is_control(code)) reject(source_, place_, fault::not_toml, "control characters are not allowed");
    last_ = rest_.front();
    rest_.remove_prefix(size);
    place_ = code == '\n' ? Place{place_.line + 1, 1} : Place{place_.line, place_.column + 1};
  }

  void advance(std::size_t characters) {
    for (; characters > 0; --characters) advance();
  }

  bool at_line_end() const { return rest_.empty() || rest_.front() == '\n' || rest_.starts_with("\r\n"); }

  void skip_comment() {
    while (!at_line_end()) advance();
  }

  /// A backslash and what it escapes: one character, or the blanks of a continued line. What follows must be
  /// ASCII, or toml++ loses its way in its table of blanks.
  void skip_escape() {
    advance();
    const bool continued = !rest_.empty() && is_in(rest_.front(), blanks);
    while (!rest_.empty() && is_in(rest_.front(), blanks)) advance();
    if (rest_.empty()) return;
    if (static_cast<unsigned char>(rest_.front()) >= 0x80)
      reject(source_, place_, fault::not_toml, "only ASCII characters may follow a backslash");
    if (!continued) advance();
  }

  /// toml++ reads a number on into a string or bracket that touches it, and a scene needs no such thing.
  void expect_start(const char* what) {
    if (!is_in(last_, " \t\r\n=,[{"))
      reject(source_, place_, fault::not_toml, std::string("unexpected ") + what);
  }

  void skip_string(char quote) {
    expect_start("quote");
    const Place start = place_;
    const std::string three(3, quote);
    const bool multiline = rest_.starts_with(three);
    const std::string_view closing = multiline ? three : std::string_view(three).substr(0, 1);
    advance(closing.size());
    while (!rest_.starts_with(closing)) {
      if (rest_.empty() || (!multiline && at_line_end()))
        reject(source_, start, fault::not_toml, "the string does not end");
      if (quote == '"' && rest_.front() == '\\')
        skip_escape();
      else
        advance();
    }
    advance(closing.size());
    // Up to two quotes right before the closing ones belong to the string.
    for (int extra = 0; multiline && extra < 2 && rest_.starts_with(quote); ++extra) advance();
  }

  bool expects_value() const { return valued_ || open_.ends_with('['); }

  void skip_value() {
    const auto word = rest_.substr(0, rest_.find_first_not_of(word_characters));
    if (!is_plain_value(word))
      reject(source_, place_, fault::not_toml,
             "\"" + std::string(word) + "\" is no number" +
                 (lacks_digit(word) ? ": digits stand on both sides of the point"
                                    : ", and text stands between quotes"));
    advance(word.size());
    while (!rest_.empty() && is_in(rest_.front(), " \t")) advance();
    if (!at_line_end() && !is_in(rest_.front(), ",]}#"))
      reject(source_, place_, fault::not_toml,
             "expected a comma or the end of the line; a number with a unit stands between quotes");
  }

  void plain() {
    const char c = rest_.front();
    const Place here = place_;
    if (c == '[' || c == '{') expect_start("bracket");
    const auto before = rest_;
    advance();
    if (!is_in(c, word_characters) && !is_in(c, " \t\r\n,=[]{}"))
      reject(source_, here, fault::not_toml,
             "unexpected '" + std::string(before.substr(0, before.size() - rest_.size())) + "'");
    if (c == '=' && expects_value()) reject(source_, here, fault::not_toml, "unexpected '='");
    if (c == '[' || c == '{') open_ += c == '[' && !expects_value() ? header : c;
    if (open_.size() > deepest) reject(source_, here, fault::too_deep, "nested too deeply");
    if ((c == ']' || c == '}') && !open_.empty()) open_.pop_back();
    if (is_in(c, "=,[]{}\r\n")) dots_ = 0;
    if (is_in(c, "=,[{\r\n")) valued_ = c == '=';
    if (c == '.' && ++dots_ >= deepest) reject(source_, here, fault::too_deep, "too many dots in one key");
  }

  const Source& source_;
  std::string_view rest_;
  char last_ = '\n';  ///< byte before the rest
  Place place_;
  std::string open_;  ///< brackets, the innermost last; `header` for those around the name of a table
  std::size_t dots_ = 0;
  bool valued_ = false;  ///< an = came, and nothing after it that another key could follow
};

}  // namespace

void guard_toml(const Source& source, std::string_view text) {
  Guard(source, text).run();
}

}  // namespace mariotte::scene
