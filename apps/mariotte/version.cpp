#include <fmt/format.h>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/page/provenance.hpp"

namespace mariotte::command {

Command version_command() {
  return {.name = "version",
          .about = "Version of mariotte and of what it was built with",
          .footer = "Example:\n  mariotte version\n",
          .act = [] {
            const auto program = report::provenance();
            print(fmt::format("mariotte {}\nSUNDIALS {}\ncompiler {}\nbuild {}\n", program.version,
                              program.sundials, program.compiler, program.build_type));
            return ExitCode::ok;
          }};
}

}  // namespace mariotte::command
