#include "mariotte/report/files.hpp"
#include "mariotte/report/trace_file.hpp"

#ifndef MARIOTTE_HDF5

namespace mariotte::report {

std::unique_ptr<TraceFile> new_hdf5_trace(const std::filesystem::path& path, const std::vector<Index>&,
                                          const std::vector<Index>&) {
  throw FileError("cannot write " + path.string() + ": built without HDF5; name the file .csv");
}

}  // namespace mariotte::report

#else

#include <H5Cpp.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>

namespace mariotte::report {
namespace {

using Clock = std::chrono::steady_clock;
using Extent = std::vector<hsize_t>;

constexpr hsize_t values_per_chunk = 8192;    // 64 KiB
constexpr std::size_t most_pending = 262144;  // values of one table: 2 MiB
constexpr std::chrono::seconds between_flushes(1);

void name_unit(const H5::DataSet& table, const std::string& unit) {
  const H5::StrType text(H5::PredType::C_S1, unit.size() + 1);
  table.createAttribute("unit", text, H5::DataSpace()).write(text, unit);
}

/// Rows that grow at the end, each of the shape `row`: one number, or one per column.
class Table {
 public:
  Table(const H5::H5File& file, const char* name, const char* unit, const Extent& row) : extent_{0} {
    for (const hsize_t columns : row) extent_.push_back(columns), width_ *= columns;
    Extent most = extent_, chunk = extent_;
    most[0] = H5S_UNLIMITED;
    chunk[0] = std::max<hsize_t>(1, values_per_chunk / width_);
    const int rank = static_cast<int>(extent_.size());
    H5::DSetCreatPropList layout;
    layout.setChunk(rank, chunk.data());
    const H5::DataSpace space(rank, extent_.data(), most.data());
    table_ = file.createDataSet(name, H5::PredType::IEEE_F64LE, space, layout);
    name_unit(table_, unit);
  }

  void add(ConstState row) { pending_.insert(pending_.end(), row.begin(), row.end()); }
  std::size_t pending() const { return pending_.size(); }

  void write() {
    if (pending_.empty()) return;
    Extent start(extent_.size(), 0), count = extent_;
    start[0] = extent_[0];
    count[0] = pending_.size() / width_;
    extent_[0] += count[0];
    table_.extend(extent_.data());
    auto there = table_.getSpace();
    there.selectHyperslab(H5S_SELECT_SET, count.data(), start.data());
    const H5::DataSpace here(static_cast<int>(count.size()), count.data());
    table_.write(pending_.data(), H5::PredType::NATIVE_DOUBLE, here, there);
    pending_.clear();
  }

 private:
  Extent extent_;
  hsize_t width_ = 1;
  H5::DataSet table_;
  std::vector<double> pending_;
};

void write_numbers(const H5::H5File& file, const char* name, const std::vector<Index>& places) {
  std::vector<std::int64_t> number(places.begin(), places.end());
  for (auto& each : number) ++each;
  const hsize_t count = number.size();
  file.createDataSet(name, H5::PredType::STD_I64LE, H5::DataSpace(1, &count))
      .write(number.data(), H5::PredType::NATIVE_INT64);
}

class Hdf5Trace final : public TraceFile {
 public:
  Hdf5Trace(std::filesystem::path path, const std::vector<Index>& balls, const std::vector<Index>& contacts)
      : path_(std::move(path)), temporary_(temporary_name(path_)) {
    H5::Exception::dontPrint();
    guarded([&] {
      file_ = H5::H5File(temporary_.string(), H5F_ACC_TRUNC);
      write_numbers(file_, "ball", balls);
      write_numbers(file_, "contact", contacts);
      tables_ = {{file_, "time", "s", {}},
                 {file_, "velocity", "m/s", {balls.size()}},
                 {file_, "gap", "m", {contacts.size()}},
                 {file_, "force", "N", {contacts.size()}}};
      flush();
    });
  }
  ~Hdf5Trace() override {
    ::unlink(temporary_.c_str());  // gone already if it was renamed
  }

  void add(const impact::Sample& sample) override {
    tables_[0].add({&sample.time, 1});
    tables_[1].add(sample.velocity);
    tables_[2].add(sample.gap);
    tables_[3].add(sample.force);
    const auto is_full = [](const Table& table) { return table.pending() >= most_pending; };
    if (Clock::now() - flushed_ > between_flushes || std::any_of(tables_.begin(), tables_.end(), is_full))
      guarded([&] { flush(); });
  }

  void commit() override {
    guarded([&] {
      flush();
      tables_.clear();
      file_.close();
    });
    put_in_place(temporary_, path_);
  }

 private:
  void flush() {
    for (auto& table : tables_) table.write();
    file_.flush(H5F_SCOPE_GLOBAL);
    flushed_ = Clock::now();
  }
  template <class Action>
  void guarded(Action&& action) const {
    try {
      action();
    } catch (const H5::Exception& problem) {
      throw FileError("cannot write " + path_.string() + ": HDF5: " + problem.getDetailMsg());
    }
  }

  std::filesystem::path path_, temporary_;
  H5::H5File file_;
  std::vector<Table> tables_;
  Clock::time_point flushed_;
};

}  // namespace

std::unique_ptr<TraceFile> new_hdf5_trace(const std::filesystem::path& path, const std::vector<Index>& balls,
                                          const std::vector<Index>& contacts) {
  return std::make_unique<Hdf5Trace>(path, balls, contacts);
}

}  // namespace mariotte::report

#endif
