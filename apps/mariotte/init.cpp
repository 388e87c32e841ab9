#include <filesystem>
#include <memory>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/named_files.hpp"
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

void expect_new(const std::filesystem::path& file) {
  if (std::filesystem::exists(std::filesystem::symlink_status(file)))
    throw report::FileError("cannot write " + file.string() + ": it exists already (--force overwrites)",
                            fault::exists);
}

/// The command that the scene is for.
std::string next_step(const Example& example, const std::string& file, const std::string& data) {
  if (!example.data.empty()) return "fit " + file + " " + data;
  return example.scene.find("[[sweep]]") == std::string::npos ? "run " + file
                                                              : "sweep " + file + " --out results";
}

int init(const Init& options) {
  const auto what = example(options.name);
  const auto file = options.file.empty() ? options.name + ".toml" : options.file;
  const auto data = std::filesystem::path(file).replace_extension("csv").string();
  const bool has_data = !what.data.empty();
  if (has_data) expect_distinct({{"FILE", {file}}, {"its measurements", {data}}});
  if (!options.force) {
    expect_new(file);
    if (has_data) expect_new(data);
  }
  report::write_file(file, what.scene);
  if (has_data) report::write_file(data, what.data);
  note("wrote " + file + (has_data ? " and " + data : "") + "; next: mariotte " +
       next_step(what, file, data));
  return ExitCode::ok;
}

constexpr const char* init_examples = R"(Examples:
  mariotte init triplet
  mariotte init tapered_chain mine.toml

mariotte demo --list lists the examples.
)";

}  // namespace

Command init_command() {
  auto options = std::make_shared<Init>();
  return {.name = "init",
          .about = "Write the scene of an example, to start from",
          .footer = init_examples,
          .options = {{"NAME", &options->name, "Which one", {.required = true, .choices = example_names()}},
                      {"FILE", &options->file, "Where to (default: NAME.toml here)", {.check = is_file_name}},
                      {"--force", &options->force, "Overwrite the file"}},
          .act = [options] { return init(*options); }};
}

}  // namespace mariotte::command
