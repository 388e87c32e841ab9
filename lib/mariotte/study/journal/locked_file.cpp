#include "mariotte/study/journal/locked_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <thread>

namespace mariotte::study {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int problem) {
  throw JournalError(fmt::format("{}: {}: {}", path.string(), what, std::strerror(problem)));
}

}  // namespace

LockedFile::LockedFile(std::filesystem::path path, std::chrono::milliseconds patience)
    : path_(std::move(path)), file_(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) fail(path_, "cannot open", errno);
  try {
    lock(patience);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

LockedFile::~LockedFile() {
  ::close(file_);
}

void LockedFile::lock(std::chrono::milliseconds patience) const {
  constexpr auto pause = std::chrono::milliseconds(50);
  for (; ::flock(file_, LOCK_EX | LOCK_NB) != 0; patience -= pause) {
    if (errno != EWOULDBLOCK) fail(path_, "cannot lock", errno);
    if (patience <= patience.zero())
      throw JournalError(path_.string() + ": another sweep is writing it", fault::journal_in_use);
    std::this_thread::sleep_for(pause);
  }
}

std::size_t LockedFile::append(std::string_view line) {
  const off_t start = ::lseek(file_, 0, SEEK_END);
  while (!line.empty()) {
    const ssize_t written = ::write(file_, line.data(), line.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int problem = errno;
      cut(static_cast<std::size_t>(start));
      fail(path_, "cannot write", problem);
    }
    line.remove_prefix(static_cast<std::size_t>(written));
  }
  return static_cast<std::size_t>(start);
}

void LockedFile::cut(std::size_t size) {
  if (::ftruncate(file_, static_cast<off_t>(size)) != 0) fail(path_, "cannot cut a torn line off", errno);
}

void LockedFile::flush() {
  if (::fdatasync(file_) != 0) fail(path_, "cannot write", errno);
}

}  // namespace mariotte::study
