#include "command_line/checks.hpp"

#include <CLI/CLI.hpp>

#include "mariotte/core/error.hpp"
#include "mariotte/flow/choose.hpp"

namespace mariotte::command {

std::string is_accuracy(const std::string& text) {
  double value = 0;
  const bool sensible = CLI::detail::lexical_cast(text, value) && value > 0 && value < 1;
  return sensible ? "" : "must be a number between 0 and 1, not " + text;
}

std::string is_flow(const std::string& text) {
  try {
    flow::parse_kind(text);
    return "";
  } catch (const InvalidParameter& problem) {
    return problem.what();
  }
}

}  // namespace mariotte::command
