// Runs the command in a folder of its own and keeps what it said.
#pragma once
#include <stdlib.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

namespace support {

namespace fs = std::filesystem;

inline constexpr const char* three_balls = R"(title = "Three balls"
[chain]
mass = [1.0, 1.0, 1.0]
velocity = [1, 0, 0]
gap = 0
[[chain.contact]]
law = "hertz"
stiffness = 1.0
)";

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

inline std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A fixture: a folder with three.toml in it, gone after the test.
struct Session {
  fs::path folder;
  fs::path said;  // beside the folder, so that the folder holds only what the command writes

  Session() {
    std::string name = (fs::temp_directory_path() / "mariotte-XXXXXX").string();
    said = ::mkdtemp(name.data());
    folder = said / "work";
    fs::create_directory(folder);
    write("three.toml", three_balls);
  }
  ~Session() { fs::remove_all(said); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
  std::size_t entries(const fs::path& of = "") const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder / of), fs::directory_iterator()));
  }

  /// Run a line of shell in the folder; $mariotte is the command.
  Outcome shell(const std::string& line) const {
    const std::string script = "mariotte='" MARIOTTE_COMMAND "'; cd '" + folder.string() + "' && { " + line +
                               "; } >'" + (said / "out").string() + "' 2>'" + (said / "err").string() + "'";
    const int status = std::system(script.c_str());
    return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            .out = content(said / "out"),
            .err = content(said / "err")};
  }
  Outcome mariotte(const std::string& arguments) const { return shell("\"$mariotte\" " + arguments); }
};

/// Whether a command line without sense was refused, with an error and no result.
inline bool is_refused(const Outcome& run) {
  return run.code == 2 && run.out.empty() && run.err.starts_with("mariotte: error: ");
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace support
