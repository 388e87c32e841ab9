#include "error_catalogue.hpp"

#include "error_pages.hpp"

namespace mariotte::command {
namespace {

constexpr std::string_view group_mark = "## ", entry_mark = "### ", fence = "```", comment = "<!--";
constexpr std::size_t code_size = 4;

std::string_view take_line(std::string_view& text) {
  const auto line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.size(), line.size() + 1));
  return line;
}

/// What stands between two headings, its examples indented.
std::string plain(std::string_view text) {
  std::string out;
  bool example = false;
  while (!text.empty()) {
    const auto line = take_line(text);
    if (line.starts_with(fence))
      example = !example;
    else if (!line.starts_with(comment))
      out.append(example ? "  " : "").append(line).append("\n");
  }
  return out;
}

std::string_view take_until_heading(std::string_view& text) {
  auto end = std::min(text.find("\n## "), text.find("\n### "));
  end = end == text.npos ? text.size() : end + 1;
  const auto before = text.substr(0, end);
  text.remove_prefix(end);
  return before;
}

}  // namespace

std::vector<ErrorEntry> error_catalogue() {
  std::vector<ErrorEntry> entries;
  std::string_view rest = error_pages, group;
  take_until_heading(rest);
  while (!rest.empty()) {
    const auto heading = take_line(rest);
    const auto body = take_until_heading(rest);
    if (heading.starts_with(entry_mark)) {
      const auto name = heading.substr(entry_mark.size());
      entries.push_back({group, name.substr(0, code_size), name.substr(code_size + 1), plain(body)});
    } else {
      group = heading.substr(group_mark.size());
    }
  }
  return entries;
}

}  // namespace mariotte::command
