// The keys of what commands other than `mariotte run` print with --json.
#pragma once
#include <span>
#include <string_view>

namespace mariotte::report {

struct CommandKey {
  std::string_view key;      ///< "estimates[].value"
  std::string_view unit;     ///< SI; "1" for a pure number, empty for what has none
  std::string_view meaning;  ///< one line
};

/// One command, and what is to be said of its result as a whole.
struct CommandResult {
  std::string_view command;  ///< "`mariotte fit`"
  std::string_view about;    ///< may be empty
  std::span<const CommandKey> keys;
};

/// Of `law`, `law` with friction, `modes`, `restitution`, `capture`, `fit` and `uncertainty`.
extern const std::span<const CommandResult> command_results;

}  // namespace mariotte::report
