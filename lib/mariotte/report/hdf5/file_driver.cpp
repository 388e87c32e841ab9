#include "mariotte/report/hdf5/file_driver.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

namespace mariotte::report::hdf5 {
namespace {

constexpr haddr_t most_bytes = std::numeric_limits<off_t>::max();

/// What HDF5 hands from the properties to the open file.
struct Owner {
  int* problem;
};

/// Bytes that the disk has refused.
struct Refused {
  haddr_t start;
  std::string bytes;
};

/// An open file; HDF5 knows its base.
struct File : H5FD_t {
  int descriptor = -1;
  haddr_t end_of_addresses = 0, end = 0;
  int* problem = nullptr;
  std::vector<Refused> refused = {};
};

File& file_of(H5FD_t* known) {
  return static_cast<File&>(*known);
}
const File& file_of(const H5FD_t* known) {
  return static_cast<const File&>(*known);
}

int open_flags(unsigned flags) {
  int mode = flags & H5F_ACC_RDWR ? O_RDWR : O_RDONLY;
  if (flags & H5F_ACC_TRUNC) mode |= O_TRUNC;
  if (flags & H5F_ACC_CREAT) mode |= O_CREAT;
  if (flags & H5F_ACC_EXCL) mode |= O_EXCL;
  return mode | O_CLOEXEC;
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t properties, haddr_t) {
  const auto* owner = static_cast<const Owner*>(H5Pget_driver_info(properties));
  const int descriptor = ::open(name, open_flags(flags), 0666);
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
    *owner->problem = errno;
    if (descriptor >= 0) ::close(descriptor);
    return nullptr;
  }
  auto file = std::make_unique<File>();
  file->descriptor = descriptor;
  file->end = static_cast<haddr_t>(status.st_size);
  file->problem = owner->problem;
  return file.release();
}

herr_t close_file(H5FD_t* known) {
  const std::unique_ptr<File> file(&file_of(known));
  if (::close(file->descriptor) != 0 && *file->problem == 0) *file->problem = errno;
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t end_of_addresses(const H5FD_t* known, H5FD_mem_t) {
  return file_of(known).end_of_addresses;
}
herr_t set_end_of_addresses(H5FD_t* known, H5FD_mem_t, haddr_t address) {
  file_of(known).end_of_addresses = address;
  return 0;
}
haddr_t end_of_file(const H5FD_t* known, H5FD_mem_t) {
  return file_of(known).end;
}

/// Bytes read or written before the end of the file or a failure.
template <class Transfer>
std::size_t transferred(std::size_t size, const Transfer& transfer) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t part = transfer(done, size - done);
    if (part < 0 && errno == EINTR) continue;
    if (part <= 0) break;
    done += static_cast<std::size_t>(part);
  }
  return done;
}

/// Puts what the disk has refused over what was read from `start` on.
void put_refused(const File& file, haddr_t start, std::size_t size, char* bytes) {
  for (const auto& piece : file.refused) {
    const haddr_t from = std::max(start, piece.start);
    const haddr_t to = std::min<haddr_t>(start + size, piece.start + piece.bytes.size());
    if (from < to) std::memcpy(bytes + (from - start), piece.bytes.data() + (from - piece.start), to - from);
  }
}

herr_t read_bytes(H5FD_t* known, H5FD_mem_t, hid_t, haddr_t start, std::size_t size, void* buffer) {
  const File& file = file_of(known);
  auto* bytes = static_cast<char*>(buffer);
  const auto done = transferred(size, [&](std::size_t at, std::size_t left) {
    return ::pread(file.descriptor, bytes + at, left, static_cast<off_t>(start + at));
  });
  std::memset(bytes + done, 0, size - done);  // HDF5 may read beyond the end
  put_refused(file, start, size, bytes);
  return 0;
}

herr_t write_bytes(H5FD_t* known, H5FD_mem_t, hid_t, haddr_t start, std::size_t size, const void* buffer) {
  File& file = file_of(known);
  const auto* bytes = static_cast<const char*>(buffer);
  const auto write = [&](std::size_t at, std::size_t left) {
    return ::pwrite(file.descriptor, bytes + at, left, static_cast<off_t>(start + at));
  };
  const auto done = *file.problem == 0 ? transferred(size, write) : 0;
  if (done < size && *file.problem == 0) *file.problem = errno != 0 ? errno : EIO;
  if (done < size) file.refused.push_back({start, {bytes, size}});
  file.end = std::max<haddr_t>(file.end, start + size);
  return 0;
}

herr_t set_length(H5FD_t* known, hid_t, hbool_t) {
  File& file = file_of(known);
  if (file.end == file.end_of_addresses) return 0;
  if (*file.problem == 0 && ::ftruncate(file.descriptor, static_cast<off_t>(file.end_of_addresses)) != 0)
    *file.problem = errno;
  file.end = file.end_of_addresses;
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 0)
  driver.version = H5FD_CLASS_VERSION;
  driver.value = 511;  // of the numbers that HDF5 leaves to tests and programs of their own
#endif
  driver.name = "remembering";
  driver.maxaddr = most_bytes;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(Owner);
  driver.open = open_file;
  driver.close = close_file;
  driver.query = query;
  driver.get_eoa = end_of_addresses;
  driver.set_eoa = set_end_of_addresses;
  driver.get_eof = end_of_file;
  driver.read = read_bytes;
  driver.write = write_bytes;
  driver.truncate = set_length;
  const H5FD_mem_t kinds[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(kinds), std::end(kinds), std::begin(driver.fl_map));
  return driver;
}

}  // namespace

H5::FileAccPropList remembering(int& problem) {
  static const H5FD_class_t driver = driver_class();
  static const hid_t number = H5FDregister(&driver);
  const Owner owner{&problem};
  H5::FileAccPropList properties;
  properties.setDriver(number, &owner);
  return properties;
}

}  // namespace mariotte::report::hdf5
