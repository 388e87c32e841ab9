// The example scenes, which are part of the program.
#pragma once
#include <string>

#include "command_line/declaration.hpp"

namespace mariotte::command {

/// All names, in alphabetical order.
Words example_names();

struct Example {
  std::string scene;
  std::string data;  ///< measurements to fit it to, as CSV; mostly empty
};

/// Throws UsageError for a name that there is not, with the nearest.
Example example(const std::string& name);

}  // namespace mariotte::command
