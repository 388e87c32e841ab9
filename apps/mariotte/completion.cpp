#include <fmt/format.h>

#include "help_pages.hpp"

namespace mariotte::command {
namespace {

/// Figures are known to the program that computes them.
constexpr const char* listed_figures =
    R"(mariotte reproduce --help 2>/dev/null | sed -n '/^Figures:/,/^$/s/^  \([a-z0-9-]*\) .*/\1/p')";
constexpr const char* has_figures = "reproduce";

bool is_word(const HelpPage::Option& option) {
  return option.long_names.empty();
}

std::string in_one_line(const Words& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

/// What may follow a command: its own commands, its options, and the values of its words.
Words words(const HelpPage& page) {
  Words all;
  for (const auto& one : page.commands) all.push_back(one.name);
  for (const auto& one : page.options) {
    for (const auto& name : one.long_names) all.push_back("--" + name);
    if (is_word(one)) all.insert(all.end(), one.choices.begin(), one.choices.end());
  }
  return all;
}

/// Calls visit("run --flow", values) for every option with values to offer.
void each_choice(const HelpPage& program, auto visit) {
  for (const auto& command : program.commands)
    for (const auto& option : command.options)
      for (const auto& name : option.long_names)
        if (!option.choices.empty()) visit(command.name + " --" + name, in_one_line(option.choices));
}

std::string bash_cases(const HelpPage& program) {
  std::string text;
  for (const auto& one : program.commands)
    text += one.name == has_figures
                ? fmt::format("    {}) words=\"all $({})\" ;;\n", one.name, listed_figures)
                : fmt::format("    {}) words='{}' ;;\n", one.name, in_one_line(words(one)));
  return text;
}

// A word that is no option is a file, where the command takes one.
std::string bash(const HelpPage& program) {
  std::string choices;
  each_choice(program, [&](const std::string& place, const std::string& values) {
    choices +=
        fmt::format("    '{}') COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", place, values);
  });
  return fmt::format(R"(_mariotte() {{
  local words='{}' word="${{COMP_WORDS[COMP_CWORD]}}"
  if [ "$COMP_CWORD" -gt 1 ]; then case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}" in
{}  esac; case "${{COMP_WORDS[1]}}" in
{}    *) words= ;;
  esac; fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  if [ "$COMP_CWORD" -gt 1 ] && [ "${{word#-}}" = "$word" ]; then
    COMPREPLY+=($(compgen -f -- "$word"))
  fi
}}
complete -o filenames -F _mariotte mariotte
)",
                     in_one_line(words(program)), choices, bash_cases(program));
}

/// Between single quotes, for zsh and fish.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return "'" + out + "'";
}

std::string zsh(const HelpPage& program) {
  std::string commands, choices, cases;
  for (const auto& one : program.commands) {
    commands += fmt::format("      {}\n", quoted(one.name + ":" + one.about));
    cases += one.name == has_figures
                 ? fmt::format("    {}) compadd -- all $({}) ;;\n", one.name, listed_figures)
                 : fmt::format("    {}) compadd -- {} ;;\n", one.name, in_one_line(words(one)));
  }
  each_choice(program, [&](const std::string& place, const std::string& values) {
    choices += fmt::format("    '{}') compadd -- {}; return ;;\n", place, values);
  });
  return fmt::format(R"(#compdef mariotte
_mariotte() {{
  if (( CURRENT == 2 )); then
    local -a commands=(
{}    )
    _describe command commands
    return
  fi
  case "$words[2] $words[CURRENT-1]" in
{}  esac
  case "$words[2]" in
{}  esac
  _files
}}
_mariotte "$@"
)",
                     commands, choices, cases);
}

std::string fish(const HelpPage& program) {
  std::string text;
  for (const auto& command : program.commands) {
    text += fmt::format("complete -c mariotte -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                        quoted(command.about));
    const auto after = fmt::format("complete -c mariotte -n '__fish_seen_subcommand_from {}'", command.name);
    if (command.name == has_figures)
      text += fmt::format("{} -f -a {}\n", after, quoted(fmt::format("({})", listed_figures)));
    for (const auto& option : command.options) {
      const auto values = option.choices.empty() ? "" : " -x -a " + quoted(in_one_line(option.choices));
      for (const auto& name : option.long_names)
        text += fmt::format("{} -l {} -d {}{}\n", after, name, quoted(option.about),
                            option.value.empty() || !values.empty() ? values : " -r");
      if (is_word(option) && !values.empty())
        text += after + " -f -a " + quoted(in_one_line(option.choices)) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string completion(const HelpPage& program, const std::string& shell) {
  return shell == "zsh" ? zsh(program) : shell == "fish" ? fish(program) : bash(program);
}

}  // namespace mariotte::command
