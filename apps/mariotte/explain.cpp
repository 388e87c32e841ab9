#include <fmt/format.h>

#include <cctype>
#include <memory>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "error_catalogue.hpp"
#include "mariotte/core/nearest.hpp"

namespace mariotte::command {
namespace {

std::string list(const std::vector<ErrorEntry>& entries) {
  std::string text;
  std::string_view group;
  for (const auto& entry : entries) {
    if (entry.group != group) text += fmt::format("{}{}\n", text.empty() ? "" : "\n", entry.group);
    group = entry.group;
    text += fmt::format("  {}  {}\n", entry.code, entry.title);
  }
  return text;
}

std::string page(const std::vector<ErrorEntry>& entries, std::string code) {
  for (char& c : code) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::vector<std::string_view> codes;
  for (const auto& entry : entries) {
    if (entry.code == code) return fmt::format("{} {}\n{}", entry.code, entry.title, entry.text);
    codes.push_back(entry.code);
  }
  throw UsageError(
      fmt::format("unknown code '{}'{} (mariotte explain lists all)", code, suggestion(code, codes)),
      fault::unknown_argument);
}

constexpr const char* explain_examples = R"(Examples:
  mariotte explain          all kinds of errors
  mariotte explain S010     one of them: what it means, how to mend it, an example

The code stands at the end of every message of an error.
)";

}  // namespace

Command explain_command() {
  auto asked = std::make_shared<std::string>();
  Words codes;
  for (const auto& entry : error_catalogue()) codes.emplace_back(entry.code);
  return {.name = "explain",
          .about = "Explain an error by its code",
          .footer = explain_examples,
          .options = {{"CODE",
                       asked.get(),
                       "Code at the end of a message, such as S010 (default: list all)",
                       {.choices = codes}}},
          .act = [asked] {
            const auto entries = error_catalogue();
            print(asked->empty() ? list(entries) : page(entries, *asked));
            return ExitCode::ok;
          }};
}

}  // namespace mariotte::command
