#include <fmt/format.h>

#include "help_pages.hpp"

namespace mariotte::command {
namespace {

/// Backslashes, hyphens and leading dots mean something to roff.
std::string roff(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts_line = i == 0 || text[i - 1] == '\n';
    if (starts_line && (text[i] == '.' || text[i] == '\'')) out += "\\&";
    if (text[i] == '-')
      out += "\\-";
    else if (text[i] == '\\')
      out += "\\e";
    else
      out += text[i];
  }
  return out;
}

/// " (default: 21; needs --out)".
std::string in_brackets(const HelpPage::Option& one) {
  std::string text;
  if (!one.default_value.empty()) text += "default: " + one.default_value;
  if (!one.needs.empty())
    text += fmt::format("{}needs {}", text.empty() ? "" : "; ", fmt::join(one.needs, ", "));
  return text.empty() ? "" : " (" + text + ")";
}

std::string option(const HelpPage::Option& one) {
  const auto value = one.value.empty() ? "" : " " + one.value;
  return fmt::format(".TP\n\\fB{}\\fR\\fI{}\\fR\n{}\n", roff(one.names), roff(value),
                     roff(one.about + in_brackets(one)));
}

std::string options(const HelpPage& page) {
  std::string text;
  for (const auto& one : page.options) text += option(one);
  return text;
}

std::string command(const HelpPage& one) {
  return fmt::format(".SS \"mariotte {}\"\n{}.\n{}.PP\n.nf\n{}\n.fi\n", roff(one.name), roff(one.about),
                     options(one), roff(one.footer));
}

}  // namespace

std::string man_page(const HelpPage& program, const std::string& version) {
  auto text = fmt::format(".TH MARIOTTE 1 \"\" \"mariotte {}\" \"User Commands\"\n", version);
  text += ".SH NAME\nmariotte \\- follows stiff impacts from contact to contact\n";
  text += ".SH SYNOPSIS\n\\fBmariotte\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n";
  text += fmt::format(".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}.SH COMMANDS\n", roff(program.about),
                      options(program));
  for (const auto& one : program.commands) text += command(one);
  return text + fmt::format(".SH EXAMPLES AND EXIT STATUS\n.nf\n{}\n.fi\n", roff(program.footer));
}

}  // namespace mariotte::command
