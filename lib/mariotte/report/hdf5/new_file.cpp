#include "mariotte/report/hdf5/new_file.hpp"

#include <unistd.h>

#include <cstring>
#include <utility>

#include "mariotte/report/hdf5/file_driver.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/page/provenance.hpp"

namespace mariotte::report::hdf5 {

NewFile::NewFile(std::filesystem::path path, std::filesystem::path temporary)
    : path_(std::move(path)), temporary_(std::move(temporary)) {
  H5::Exception::dontPrint();
  remove_abandoned(path_);
  guarded([&] {
    file_ =
        H5::H5File(temporary_.string(), H5F_ACC_TRUNC, H5::FileCreatPropList::DEFAULT, remembering(problem_));
  });
}

NewFile::~NewFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());  // gone already if it was renamed
}

void NewFile::fail(const std::string& reason) const {
  throw FileError("cannot write " + path_.string() + ": " + reason, fault::unwritable, path_.string(),
                  problem_);
}

void NewFile::guarded(const std::function<void()>& action) const {
  try {
    action();
  } catch (const H5::Exception& problem) {
    fail(problem_ != 0 ? std::strerror(problem_) : "HDF5: " + problem.getDetailMsg());
  }
  if (problem_ != 0) fail(std::strerror(problem_));
}

void NewFile::commit() {
  guarded([&] { file_.close(); });
  put_in_place(temporary_, path_);
}

std::filesystem::path NewFile::leave() {
  guarded([&] { file_.close(); });
  return std::exchange(temporary_, {});
}

}  // namespace mariotte::report::hdf5

std::string mariotte::report::hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5::H5Library::getLibVersion(major, minor, release);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release);
}
