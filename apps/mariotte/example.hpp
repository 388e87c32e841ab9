// The example scenes, which are part of the program.
#pragma once
#include <string>

#include "command_line/declaration.hpp"

namespace mariotte::command {

/// All names, in alphabetical order.
Words example_names();

/// The text of one. Throws UsageError for a name that there is not, with the nearest.
std::string example(const std::string& name);

}  // namespace mariotte::command
