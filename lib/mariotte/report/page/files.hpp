// Files that are either complete or not there.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/core/error.hpp"
#include "mariotte/scene/fault.hpp"

namespace mariotte::report {

/// A file that could not be written; what() names it and says why.
struct FileError : Error {
  explicit FileError(const std::string& what, Fault kind = fault::unwritable, std::string file = {},
                     int problem = 0)
      : Error(what, kind), path(std::move(file)), number(problem) {}

  std::string path;  ///< of the file, if it is known
  int number;        ///< errno, if the system said why; else 0
};

/// Write `text` under a temporary name beside `path`, flush it to the disk and rename it to `path`, replacing
/// what was there. Throws FileError and leaves nothing behind if that fails.
void write_file(const std::filesystem::path& path, const std::string& text);

/// Where a file that is to appear at `path` grows, beside it: hidden; or, if its beginning is worth keeping,
/// for everybody to see.
std::filesystem::path temporary_name(const std::filesystem::path& path);
std::filesystem::path part_name(const std::filesystem::path& path);

/// Remove hidden beginnings of a file at `path` that killed processes left.
void remove_abandoned(const std::filesystem::path& path);

/// Its move to `path`, flushed to the disk, replacing what was there, unless that is a device or a pipe.
/// Throws FileError.
void put_in_place(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// The same for a text that comes in parts, which need not fit into memory together.
class NewFile {
 public:
  explicit NewFile(const std::filesystem::path& path) : NewFile(path, temporary_name(path)) {}
  NewFile(std::filesystem::path path, std::filesystem::path temporary);
  ~NewFile();  ///< without `commit` or `leave` nothing is left behind
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void append(std::string_view text);
  void commit();
  /// Keep what there is under its temporary name, which is returned.
  std::filesystem::path leave();

 private:
  [[noreturn]] void fail(int problem) const;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int file_ = -1;
};

/// Create `folder` to receive files of these names. Throws FileError if it cannot be written to or, unless
/// `overwrite`, if one of the files exists.
void prepare_folder(const std::filesystem::path& folder, const std::vector<std::string>& names,
                    bool overwrite);

/// Remove what a killed process left of files of these names that it had not finished.
void remove_unfinished(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Remove those of the files that exist, so that nothing of an earlier run stays beside a new one.
/// Throws FileError.
void remove_files(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace mariotte::report
