#include <fmt/format.h>

#include "help_pages.hpp"

namespace mariotte::command {
namespace {

const auto any = [](const CLI::App*) { return true; };

std::string words(const CLI::App& app) {
  std::string text;
  for (const auto* one : app.get_subcommands(any)) text += one->get_name() + " ";
  for (const auto* one : app.get_options())
    for (const auto& name : one->get_lnames()) text += "--" + name + " ";
  return text;
}

std::string cases(const CLI::App& app) {
  std::string text;
  for (const auto* one : app.get_subcommands(any))
    text += fmt::format("    {}) words='{}' ;;\n", one->get_name(), words(*one));
  return text;
}

}  // namespace

// A word that is no option is a file, where the command takes one.
std::string bash_completion(const CLI::App& app) {
  return fmt::format(R"(_mariotte() {{
  local words='{}' word="${{COMP_WORDS[COMP_CWORD]}}"
  if [ "$COMP_CWORD" -gt 1 ]; then case "${{COMP_WORDS[1]}}" in
{}    *) words= ;;
  esac; fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  if [ "$COMP_CWORD" -gt 1 ] && [ "${{word#-}}" = "$word" ]; then
    COMPREPLY+=($(compgen -f -- "$word"))
  fi
}}
complete -o filenames -F _mariotte mariotte
)",
                     words(app), cases(app));
}

}  // namespace mariotte::command
