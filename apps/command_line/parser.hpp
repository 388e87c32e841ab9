// Command lines parsed and described.
#pragma once
#include "command_line/declaration.hpp"

namespace mariotte::command {

/// Fills the targets of the options, and returns what was asked for: the act of the innermost command, or to
/// print help or version. Throws UsageError.
std::function<int()> parse(const Command& program, int argc, const char* const* argv);

/// A command as its help shows it, the options that every command has included.
struct HelpPage {
  struct Option {
    std::string names;  ///< "-v,--verbose"
    Words long_names;   ///< without dashes
    std::string value;  ///< what stands for its value; empty for a flag and for a word without dashes
    std::string about;
    Words choices;                   ///< values that a shell offers
    std::string default_value = {};  ///< where help shows one
    Words needs = {};                ///< names of options that must be given as well
  };
  std::string name, about, footer;
  std::vector<Option> options;
  std::vector<HelpPage> commands;
};

HelpPage help_page(const Command& command);

}  // namespace mariotte::command
