// The command line as other programs read it, made of the declarations that --help prints.
#pragma once
#include <string>

#include "command_line/parser.hpp"

namespace mariotte::command {

/// A page for man, in roff.
std::string man_page(const HelpPage& program, const std::string& version);

/// Completions for "bash", "zsh" or "fish".
std::string completion(const HelpPage& program, const std::string& shell);

}  // namespace mariotte::command
