#include "mariotte/report/hdf5/new_file.hpp"

#include <unistd.h>

#include "mariotte/report/files.hpp"

namespace mariotte::report::hdf5 {

NewFile::NewFile(std::filesystem::path path) : path_(std::move(path)), temporary_(temporary_name(path_)) {
  H5::Exception::dontPrint();
  guarded([&] { file_ = H5::H5File(temporary_.string(), H5F_ACC_TRUNC); });
}

NewFile::~NewFile() {
  ::unlink(temporary_.c_str());  // gone already if it was renamed
}

void NewFile::guarded(const std::function<void()>& action) const {
  try {
    action();
  } catch (const H5::Exception& problem) {
    throw FileError("cannot write " + path_.string() + ": HDF5: " + problem.getDetailMsg());
  }
}

void NewFile::commit() {
  guarded([&] { file_.close(); });
  put_in_place(temporary_, path_);
}

}  // namespace mariotte::report::hdf5
