// An HDF5 file that is either complete or not there.
#pragma once
#include <H5Cpp.h>

#include <filesystem>
#include <functional>
#include <string>

namespace mariotte::report::hdf5 {

/// Grows under a temporary name until `commit`; without it or `leave` nothing is left behind. All throw
/// FileError.
class NewFile {
 public:
  NewFile(std::filesystem::path path, std::filesystem::path temporary);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  H5::H5File& file() { return file_; }
  /// What HDF5 complains of in `action`, or the disk up to its end, is thrown as FileError that names the
  /// file.
  void guarded(const std::function<void()>& action) const;
  /// Once no dataset of it is open any more.
  void commit();
  /// The same, but the file keeps its temporary name, which is returned.
  std::filesystem::path leave();

 private:
  [[noreturn]] void fail(const std::string& reason) const;

  std::filesystem::path path_, temporary_;
  int problem_ = 0;  ///< of the disk, an errno
  H5::H5File file_;
};

}  // namespace mariotte::report::hdf5
