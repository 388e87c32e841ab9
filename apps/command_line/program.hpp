// The frame of a program: parse, act, tell the shell.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace mariotte::command {

/// Parses the command line into what `app` was made to fill, then does `action` and returns its exit code;
/// help and version are printed instead. Anything thrown becomes a message under the name of the app and an
/// exit code.
int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& action) noexcept;

}  // namespace mariotte::command
