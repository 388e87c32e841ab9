// The mariotte command: one function per subcommand adds it to the command line.
#pragma once
#include <CLI/CLI.hpp>

namespace mariotte::command {

/// Parse the command line, do what it says and return the exit code. Never throws.
int command_line(int argc, char** argv) noexcept;

/// Each declares its options and, when chosen, runs and leaves its exit code in `code`.
void add_run(CLI::App& app, int& code);
void add_check(CLI::App& app, int& code);
void add_law(CLI::App& app, int& code);
void add_capture(CLI::App& app, int& code);
void add_fit(CLI::App& app, int& code);
void add_demo(CLI::App& app, int& code);
void add_sweep(CLI::App& app, int& code);
void add_report(CLI::App& app, int& code);
void add_explain(CLI::App& app, int& code);
void add_version(CLI::App& app, int& code);

/// Prints all the others as a man page or as completions.
void add_help_pages(CLI::App& app);

/// These run another program instead.
void add_reproduce(CLI::App& app);
void add_study(CLI::App& app);

}  // namespace mariotte::command
