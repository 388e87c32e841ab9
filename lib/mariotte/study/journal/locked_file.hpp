// A file that one process at a time adds lines to.
#pragma once
#include <chrono>
#include <filesystem>
#include <string_view>

#include "mariotte/core/error.hpp"
#include "mariotte/study/fault.hpp"

namespace mariotte::study {

/// A journal that cannot be read or written, is in use, or belongs to another sweep; what() says which.
struct JournalError : Error {
  explicit JournalError(const std::string& what, Fault kind = fault::unwritable) : Error(what, kind) {}
};

class LockedFile {
 public:
  /// Opens the file, makes it if it is not there, and waits at most `patience` for another process that
  /// holds it. Like all that follows, throws JournalError.
  explicit LockedFile(std::filesystem::path path, std::chrono::milliseconds patience = {});
  ~LockedFile();
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Adds a line and returns where it begins. All or nothing: one that does not fit on the disk is taken
  /// back.
  std::size_t append(std::string_view line);

  /// Cuts the file after its first `size` bytes.
  void cut(std::size_t size);

  /// Waits until all is on the disk.
  void flush();

 private:
  void lock(std::chrono::milliseconds patience) const;

  std::filesystem::path path_;
  int file_;
};

}  // namespace mariotte::study
