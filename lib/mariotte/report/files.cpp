#include "mariotte/report/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace mariotte::report {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw FileError("cannot write " + path.string() + ": " + reason);
}

std::filesystem::path temporary_name(const std::filesystem::path& path) {
  return path.parent_path() / fmt::format(".{}.{}.tmp", path.filename().string(), ::getpid());
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// 0, or the errno of the first step that failed.
int write_new(const std::filesystem::path& path, const std::string& text) {
  ::unlink(path.c_str());
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int problem = write_all(file, text) && ::fsync(file) == 0 ? 0 : errno;
  if (::close(file) != 0 && problem == 0) problem = errno;
  return problem;
}

}  // namespace

void write_file(const std::filesystem::path& path, const std::string& text) {
  const auto temporary = temporary_name(path);
  int problem = write_new(temporary, text);
  if (problem == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) problem = errno;
  if (problem == 0) return;
  ::unlink(temporary.c_str());
  fail(path, std::strerror(problem));
}

void prepare_folder(const std::filesystem::path& folder, const std::vector<std::string>& names,
                    bool overwrite) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) fail(folder, problem.message());
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, std::strerror(errno));
  for (const auto& name : names)
    if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(folder / name)))
      fail(folder / name, "it exists already (--force overwrites)");
}

void remove_files(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::error_code problem;
  for (const auto& name : names) {
    std::filesystem::remove(folder / name, problem);
    if (problem) fail(folder / name, problem.message());
  }
}

}  // namespace mariotte::report
