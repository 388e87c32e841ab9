#include "mariotte/study/journal/journal_line.hpp"

#include <fmt/format.h>

#include <charconv>

#include "mariotte/study/journal/crc32.hpp"

namespace mariotte::study {
namespace {

constexpr std::string_view before_checksum = "{\"crc32\":\"", after_checksum = "\",";

/// `body` is what follows the checksum.
std::string sealed(const std::string& body) {
  return fmt::format("{}{:08x}{}{}\n", before_checksum, crc32(body), after_checksum, body);
}

bool needs_escape(char c) {
  return c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' ';
}

void append_escaped(std::string& out, std::string_view text) {
  for (std::size_t from = 0; from < text.size();) {
    std::size_t to = from;
    while (to < text.size() && !needs_escape(text[to])) ++to;
    out += text.substr(from, to - from);
    if (to < text.size()) {
      if (text[to] == '\n')
        out += "\\n";
      else if (static_cast<unsigned char>(text[to]) < ' ')
        out += fmt::format("\\u{:04x}", static_cast<unsigned char>(text[to]));
      else
        (out += '\\') += text[to];
    }
    from = to + 1;
  }
}

/// Undoes `append_escaped`; what else JSON allows does not occur behind a checksum that is right.
std::string unescaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const auto plain = text.substr(0, text.find('\\'));
    out += plain;
    text.remove_prefix(plain.size());
    if (text.size() < 2) break;
    if (text[1] == 'u' && text.size() >= 6) {
      int code = 0;
      std::from_chars(text.data() + 2, text.data() + 6, code, 16);
      out += static_cast<char>(code);
      text.remove_prefix(6);
    } else {
      out += text[1] == 'n' ? '\n' : text[1];
      text.remove_prefix(2);
    }
  }
  return out;
}

/// What follows the checksum, if it is right; else empty.
std::string_view opened(std::string_view line) {
  const std::size_t start = before_checksum.size() + 8 + after_checksum.size();
  if (line.size() <= start) return {};
  const auto body = line.substr(start);
  return line.substr(0, start) == fmt::format("{}{:08x}{}", before_checksum, crc32(body), after_checksum)
             ? body
             : std::string_view{};
}

/// Takes `key` and the number after it off the front.
bool take(std::string_view& text, std::string_view key, Index& number) {
  if (!text.starts_with(key)) return false;
  const auto [stop, error] = std::from_chars(text.data() + key.size(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return error == std::errc();
}

}  // namespace

std::string heading_line(std::string_view identity, Index points) {
  return sealed(fmt::format("\"sweep\":\"{}\",\"points\":{}}}", identity, points));
}

std::string rows_line(const Rows& rows) {
  std::string body =
      fmt::format("\"first\":{},\"count\":{},\"failed\":{},\"rows\":\"", rows.first, rows.count, rows.failed);
  body.reserve(body.size() + rows.text.size() + rows.text.size() / 16);
  append_escaped(body, rows.text);
  return sealed(body += "\"}");
}

bool is_heading(std::string_view line) {
  return opened(line).starts_with("\"sweep\":");
}

std::optional<Rows> read_rows(std::string_view line) {
  auto body = opened(line);
  Rows rows;
  if (!take(body, "\"first\":", rows.first) || !take(body, ",\"count\":", rows.count) ||
      !take(body, ",\"failed\":", rows.failed))
    return {};
  constexpr std::string_view before = ",\"rows\":\"", after = "\"}";
  if (!body.starts_with(before) || !body.ends_with(after)) return {};
  rows.text = unescaped(body.substr(before.size(), body.size() - before.size() - after.size()));
  return rows;
}

}  // namespace mariotte::study
