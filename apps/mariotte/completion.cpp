#include <fmt/format.h>

#include "help_pages.hpp"

namespace mariotte::command {
namespace {

std::string words(const HelpPage& page) {
  std::string text;
  for (const auto& one : page.commands) text += one.name + " ";
  for (const auto& one : page.options)
    for (const auto& name : one.long_names) text += "--" + name + " ";
  return text;
}

std::string cases(const HelpPage& program) {
  std::string text;
  for (const auto& one : program.commands)
    text += fmt::format("    {}) words='{}' ;;\n", one.name, words(one));
  return text;
}

}  // namespace

// A word that is no option is a file, where the command takes one.
std::string bash_completion(const HelpPage& program) {
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
                     words(program), cases(program));
}

}  // namespace mariotte::command
