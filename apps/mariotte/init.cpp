#include <filesystem>
#include <memory>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "example.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::command {
namespace {

struct Init {
  std::string name;
  std::string file;
  bool force = false;
};

int init(const Init& options) {
  const auto text = example(options.name);
  const auto file = options.file.empty() ? options.name + ".toml" : options.file;
  if (!options.force && std::filesystem::exists(std::filesystem::symlink_status(file)))
    throw report::FileError("cannot write " + file + ": it exists already (--force overwrites)",
                            fault::exists);
  report::write_file(file, text);
  note("wrote " + file + "; mariotte run " + file + " follows it");
  return ExitCode::ok;
}

constexpr const char* examples = R"(Examples:
  mariotte init triplet
  mariotte init tapered_chain mine.toml

mariotte demo --list lists the examples.
)";

}  // namespace

Command init_command() {
  auto options = std::make_shared<Init>();
  return {.name = "init",
          .about = "Write the scene of an example, to start from",
          .footer = examples,
          .options = {{"NAME", &options->name, "Which one", {.required = true, .choices = example_names()}},
                      {"FILE", &options->file, "Where to (default: NAME.toml here)", {.check = is_file_name}},
                      {"--force", &options->force, "Overwrite the file"}},
          .act = [options] { return init(*options); }};
}

}  // namespace mariotte::command
