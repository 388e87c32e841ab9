// The command line of work_precision.
#pragma once

namespace mariotte::work_precision {

/// Measure what is asked for and print it. Returns the exit code: 0 ok, 2 usage, 6 file error, 4 anything
/// else that went wrong.
int command_line(int argc, char** argv) noexcept;

}  // namespace mariotte::work_precision
