// Files that are either complete or not there.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mariotte/core/error.hpp"

namespace mariotte::report {

/// A file that could not be written; what() names it and says why.
struct FileError : Error {
  using Error::Error;
};

/// Write `text` under a temporary name beside `path`, flush it to the disk and rename it to `path`, replacing
/// what was there. Throws FileError and leaves nothing behind if that fails.
void write_file(const std::filesystem::path& path, const std::string& text);

/// Create `folder` to receive files of these names. Throws FileError if it cannot be written to or, unless
/// `overwrite`, if one of the files exists.
void prepare_folder(const std::filesystem::path& folder, const std::vector<std::string>& names,
                    bool overwrite);

/// Remove those of the files that exist, so that nothing of an earlier run stays beside a new one.
/// Throws FileError.
void remove_files(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace mariotte::report
