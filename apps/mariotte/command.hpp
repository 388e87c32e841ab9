// The mariotte command: one function per subcommand declares it.
#pragma once
#include "command_line/declaration.hpp"

namespace mariotte::command {

/// Parse the command line, do what it says and return the exit code. Never throws.
int command_line(int argc, char** argv) noexcept;

Command run_command();
Command check_command();
Command law_command();
Command capture_command();
Command restitution_command();
Command modes_command();
Command sensitivity_command();
Command uncertainty_command();
Command fit_command();
Command demo_command();
Command init_command();
Command sweep_command();
Command report_command();
Command materials_command();
Command explain_command();
Command version_command();

/// These run another program instead.
Command reproduce_command();
Command study_command();

/// These print all the others, which must outlive them, as a man page or as completions.
Command man_command(const Command& program);
Command completion_command(const Command& program);

}  // namespace mariotte::command
