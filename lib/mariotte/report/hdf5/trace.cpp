#include <algorithm>
#include <chrono>

#include "mariotte/impact/quantities/description.hpp"
#include "mariotte/report/hdf5/axes.hpp"
#include "mariotte/report/hdf5/new_file.hpp"
#include "mariotte/report/hdf5/rows.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/trace_file.hpp"

namespace mariotte::report {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_pending_values = 262144;  // values of one table: 2 MiB
constexpr std::chrono::seconds between_flushes(1);

/// Rows that wait to be written.
class Table {
 public:
  Table(const H5::H5File& file, const impact::Description& is, const hdf5::Extent& row)
      : rows_(file, std::string(is.key), H5::PredType::IEEE_F64LE, row) {
    rows_.describe("units", std::string(is.unit));
    rows_.describe("long_name", std::string(is.meaning));
  }

  void add(ConstState row) { pending_.insert(pending_.end(), row.begin(), row.end()); }
  std::size_t pending() const { return pending_.size(); }
  const H5::DataSet& dataset() const { return rows_.dataset(); }

  void write() {
    rows_.append(pending_.data(), pending_.size() / rows_.width(), H5::PredType::NATIVE_DOUBLE);
    pending_.clear();
  }

 private:
  hdf5::Rows rows_;
  std::vector<double> pending_;
};

/// The axis of the balls or contacts of these places.
H5::DataSet write_numbers(const H5::H5File& file, const char* name, const std::vector<Index>& places) {
  std::vector<std::int64_t> number(places.begin(), places.end());
  for (auto& each : number) ++each;
  const hsize_t count = number.size();
  auto axis = file.createDataSet(name, H5::PredType::STD_I64LE, H5::DataSpace(1, &count));
  axis.write(number.data(), H5::PredType::NATIVE_INT64);
  hdf5::make_axis(axis, name);
  return axis;
}

class Hdf5Trace final : public TraceFile {
 public:
  Hdf5Trace(const std::filesystem::path& path, const std::vector<Index>& balls,
            const std::vector<Index>& contacts, const Attributes& origin)
      : target_(path, part_name(path)) {
    target_.guarded([&] {
      const auto& file = target_.file();
      for (const auto& [name, words] : origin) hdf5::describe(file, name, words);
      const auto ball = write_numbers(file, "ball", balls);
      const auto contact = write_numbers(file, "contact", contacts);
      const auto& [time, velocity, gap, force] = impact::sampled;
      tables_ = {{file, time, {}},
                 {file, velocity, {balls.size()}},
                 {file, gap, {contacts.size()}},
                 {file, force, {contacts.size()}}};
      attach_axes(ball, contact);
      flush();
    });
  }

  void add(const impact::Sample& sample) override {
    tables_[0].add({&sample.time, 1});
    tables_[1].add(sample.velocity);
    tables_[2].add(sample.gap);
    tables_[3].add(sample.force);
    const auto is_full = [](const Table& table) { return table.pending() >= most_pending_values; };
    if (Clock::now() - flushed_ > between_flushes || std::any_of(tables_.begin(), tables_.end(), is_full))
      target_.guarded([&] { flush(); });
  }

  void commit() override {
    close();
    target_.commit();
  }
  std::filesystem::path leave() override {
    close();
    return target_.leave();
  }

 private:
  void attach_axes(const H5::DataSet& ball, const H5::DataSet& contact) {
    const auto& time = tables_[0].dataset();
    hdf5::make_axis(time, "time");
    for (std::size_t k = 1; k < tables_.size(); ++k) {
      hdf5::attach(tables_[k].dataset(), 0, time);
      hdf5::attach(tables_[k].dataset(), 1, k == 1 ? ball : contact);
    }
  }

  void close() {
    target_.guarded([&] { flush(); });
    tables_.clear();
  }

  void flush() {
    for (auto& table : tables_) table.write();
    target_.file().flush(H5F_SCOPE_GLOBAL);
    flushed_ = Clock::now();
  }

  hdf5::NewFile target_;
  std::vector<Table> tables_;
  Clock::time_point flushed_;
};

}  // namespace

std::unique_ptr<TraceFile> new_hdf5_trace(const std::filesystem::path& path, const std::vector<Index>& balls,
                                          const std::vector<Index>& contacts, const Attributes& origin) {
  return std::make_unique<Hdf5Trace>(path, balls, contacts, origin);
}

}  // namespace mariotte::report
