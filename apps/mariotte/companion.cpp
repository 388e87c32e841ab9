#include "companion.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "command_line/fault.hpp"
#include "mariotte/core/error.hpp"

namespace mariotte::command {
namespace {

std::filesystem::path find_program(const std::string& name) {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const auto& place : {here / name, here.parent_path() / name / name})
    if (std::filesystem::is_regular_file(place)) return place;
  throw Error(fmt::format("{} is not installed beside mariotte", name), fault::not_installed);
}

}  // namespace

void become(const std::string& name, const std::vector<std::string>& arguments) {
  const auto program = find_program(name);
  std::vector<std::string> words = {name};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execv(program.c_str(), argv.data());
  throw Error(fmt::format("cannot start {}: {}", program.string(), std::strerror(errno)),
              fault::not_installed);
}

}  // namespace mariotte::command
