// The command line as other programs read it, made of the declarations that --help prints.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace mariotte::command {

/// A page for man, in roff.
std::string man_page(const CLI::App& app, const std::string& version);

/// Completions for bash (and zsh by bashcompinit).
std::string bash_completion(const CLI::App& app);

}  // namespace mariotte::command
