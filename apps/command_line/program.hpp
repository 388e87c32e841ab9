// The frame of a program: parse, act, tell the shell.
#pragma once
#include "command_line/declaration.hpp"

namespace mariotte::command {

/// Does what the command line asks of `program` and returns the exit code. Anything thrown becomes a message
/// under the program's name and an exit code.
int run_program(const Command& program, int argc, char** argv) noexcept;

}  // namespace mariotte::command
