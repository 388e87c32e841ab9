// The command line as other programs read it, made of the declarations that --help prints.
#pragma once
#include <string>

#include "command_line/parser.hpp"

namespace mariotte::command {

/// A page for man, in roff.
std::string man_page(const HelpPage& program, const std::string& version);

/// Completions for bash (and zsh by bashcompinit).
std::string bash_completion(const HelpPage& program);

}  // namespace mariotte::command
