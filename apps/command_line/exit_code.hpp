// What a program tells the shell.
#pragma once
#include <functional>

#include "command_line/fault.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/hybrid/ending.hpp"

namespace mariotte::command {

/// Scripts rely on these numbers.
enum ExitCode : int {
  ok = 0,
  check_failed = 1,
  usage = 2,
  bad_scene = 3,
  solver_failed = 4,
  limit = 5,
  bad_file = 6
};

/// A command line that makes no sense.
struct UsageError : Error {
  explicit UsageError(const std::string& what, Fault kind = fault::bad_argument) : Error(what, kind) {}
};

/// The exit code of a run that ended this way, and what was wrong with it unless the code is ok.
ExitCode exit_code(hybrid::Ending ending);
Fault fault_of(hybrid::Ending ending);

/// Do `action` and return its exit code; an exception becomes a message on stderr and its own exit code.
int guarded(const std::function<int()>& action) noexcept;

}  // namespace mariotte::command
