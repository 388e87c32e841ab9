#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "mariotte/core/error.hpp"

namespace mariotte::command {
namespace {

const std::map<std::string, std::string> programs = {
    {"icr-table", "icr_table"}, {"stiffness", "stiffness_study"}, {"work-precision", "work_precision"}};

/// The study's own program: installed beside this one, or built in the folder next to it.
std::filesystem::path find_program(const std::string& name) {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const auto& place : {here / name, here.parent_path() / name / name})
    if (std::filesystem::is_regular_file(place)) return place;
  throw Error(fmt::format("{} is not installed beside mariotte", name));
}

/// Becomes that program; returns only if it cannot.
void become(const std::filesystem::path& program, std::vector<std::string> arguments) {
  std::string name = program.filename();
  std::vector<char*> argv = {name.data()};
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  ::execv(program.c_str(), argv.data());
  throw Error(fmt::format("cannot start {}: {}", program.string(), std::strerror(errno)));
}

}  // namespace

void add_study(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("study", "Programs of their own: icr-table, stiffness, work-precision");
  command->footer(
      "Examples:\n  mariotte study icr-table --kappa 0.1:10:41:log --out kappa.csv\n  mariotte study "
      "stiffness --quick\n  mariotte study work-precision --help\n");
  command->require_subcommand(1);
  for (const auto& [study, program] : programs) {
    auto* one = command->add_subcommand(study, fmt::format("The same as {}", program));
    one->prefix_command();
    one->set_help_flag();
    one->callback([&code, one, name = program] {
      become(find_program(name), one->remaining());
      code = ExitCode::ok;
    });
  }
}

}  // namespace mariotte::command
