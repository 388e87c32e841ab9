#include "mariotte/report/page/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

namespace mariotte::report {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason, Fault kind, int number) {
  throw FileError("cannot write " + path.string() + ": " + reason, kind, path.string(), number);
}

/// `number` is an errno.
[[noreturn]] void fail(const std::filesystem::path& path, int number) {
  fail(path, std::strerror(number), fault::unwritable, number);
}

void refuse_device(const std::filesystem::path& path) {
  if (std::filesystem::is_other(std::filesystem::symlink_status(path)))
    fail(path, "it is a device or a pipe, and would be replaced", fault::unwritable, EEXIST);
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

/// Whether this is the temporary name that a process which is no more gave to a file.
bool is_abandoned(std::string_view name, const std::string& file) {
  const auto head = "." + file + ".";
  constexpr std::string_view tail = ".tmp";
  if (!name.starts_with(head) || !name.ends_with(tail) || name.size() <= head.size() + tail.size())
    return false;
  const auto number = name.substr(head.size(), name.size() - head.size() - tail.size());
  ::pid_t process = 0;
  const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), process);
  return problem == std::errc() && end == number.data() + number.size() && process > 0 &&
         ::kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace

void remove_abandoned(const std::filesystem::path& path) {
  std::error_code problem;
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  for (const auto& entry : std::filesystem::directory_iterator(folder, problem))
    if (is_abandoned(entry.path().filename().string(), path.filename().string()))
      std::filesystem::remove_all(entry.path(), problem);
}

std::filesystem::path temporary_name(const std::filesystem::path& path) {
  return path.parent_path() / fmt::format(".{}.{}.tmp", path.filename().string(), ::getpid());
}

std::filesystem::path part_name(const std::filesystem::path& path) {
  return path.parent_path() / fmt::format("{}.{}.part", path.filename().string(), ::getpid());
}

void put_in_place(const std::filesystem::path& temporary, const std::filesystem::path& path) {
  const int file = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = file >= 0 && ::fsync(file) == 0;
  const int problem = errno;
  if (file >= 0) ::close(file);
  if (!flushed) fail(path, problem);
  refuse_device(path);
  if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(path, errno);
}

NewFile::NewFile(std::filesystem::path path, std::filesystem::path temporary)
    : path_(std::move(path)), temporary_(std::move(temporary)) {
  refuse_device(path_);
  remove_abandoned(path_);
  ::unlink(temporary_.c_str());
  file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file_ < 0) fail(errno);
}

NewFile::~NewFile() {
  if (file_ >= 0) ::close(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());  // gone already if it was renamed
}

void NewFile::append(std::string_view text) {
  if (!write_all(file_, text)) fail(errno);
}

void NewFile::commit() {
  if (::close(std::exchange(file_, -1)) != 0) fail(errno);
  put_in_place(temporary_, path_);
}

std::filesystem::path NewFile::leave() {
  if (::close(std::exchange(file_, -1)) != 0) fail(errno);
  return std::exchange(temporary_, {});
}

void NewFile::fail(int problem) const {
  report::fail(path_, problem);
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  NewFile file(path);
  file.append(text);
  file.commit();
}

void prepare_folder(const std::filesystem::path& folder, const std::vector<std::string>& names,
                    bool overwrite) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) fail(folder, problem.value());
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, errno);
  for (const auto& name : names)
    if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(folder / name)))
      fail(folder / name, "it exists already (--force overwrites)", fault::exists, EEXIST);
}

void remove_unfinished(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::error_code problem;
  for (const auto& entry : std::filesystem::directory_iterator(folder, problem))
    for (const auto& name : names)
      if (const auto file = entry.path().filename().string();
          file.starts_with("." + name + ".") && file.ends_with(".tmp"))
        std::filesystem::remove_all(entry.path(), problem);
}

void remove_files(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::error_code problem;
  for (const auto& name : names) {
    std::filesystem::remove(folder / name, problem);
    if (problem) fail(folder / name, problem.value());
  }
}

}  // namespace mariotte::report
