#include <fmt/format.h>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/page/provenance.hpp"

namespace mariotte::command {

void add_version(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("version", "Version of mariotte and of what it was built with");
  command->footer("Example:\n  mariotte version\n");
  command->callback([&code] {
    const auto program = report::provenance();
    print(fmt::format("mariotte {}\nSUNDIALS {}\ncompiler {}\nbuild {}\n", program.version, program.sundials,
                      program.compiler, program.build_type));
    code = ExitCode::ok;
  });
}

}  // namespace mariotte::command
