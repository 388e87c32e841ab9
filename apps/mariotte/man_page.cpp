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

std::string option(const CLI::Option& one) {
  const auto value =
      one.get_items_expected_max() > 0 && !one.get_positional() ? " " + one.get_type_name() : "";
  return fmt::format(".TP\n\\fB{}\\fR\\fI{}\\fR\n{}\n", roff(one.get_name(false, true)), roff(value),
                     roff(one.get_description()));
}

std::string options(const CLI::App& app) {
  std::string text;
  for (const auto* one : app.get_options()) text += option(*one);
  return text;
}

std::string command(const CLI::App& one) {
  return fmt::format(".SS \"mariotte {}\"\n{}.\n{}.PP\n.nf\n{}\n.fi\n", roff(one.get_name()),
                     roff(one.get_description()), options(one), roff(one.get_footer()));
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& version) {
  auto text = fmt::format(".TH MARIOTTE 1 \"\" \"mariotte {}\" \"User Commands\"\n", version);
  text += ".SH NAME\nmariotte \\- follows stiff impacts from contact to contact\n";
  text += ".SH SYNOPSIS\n\\fBmariotte\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n";
  text += fmt::format(".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}.SH COMMANDS\n", roff(app.get_description()),
                      options(app));
  for (const auto* one : app.get_subcommands([](const CLI::App*) { return true; })) text += command(*one);
  return text + fmt::format(".SH EXAMPLES AND EXIT STATUS\n.nf\n{}\n.fi\n", roff(app.get_footer()));
}

}  // namespace mariotte::command
