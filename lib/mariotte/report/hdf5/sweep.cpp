#include <numeric>

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/hdf5/axes.hpp"
#include "mariotte/report/hdf5/new_file.hpp"
#include "mariotte/report/hdf5/rows.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/sweep_file.hpp"

namespace mariotte::report {
namespace {

constexpr Index most_pending_rows = 65536;  // rows

H5::StrType utf8_text() {
  H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
  type.setCset(H5T_CSET_UTF8);
  return type;
}

/// Cells that wait to be written.
class Column {
 public:
  virtual ~Column() = default;
  virtual void add(const std::string& cell) = 0;
  virtual void write() = 0;
  virtual const H5::DataSet& dataset() const = 0;
};

class NumberColumn final : public Column {
 public:
  NumberColumn(const H5::H5File& file, const study::Column& column)
      : rows_(file, column.key, H5::PredType::IEEE_F64LE) {
    rows_.describe("units", std::string(column.unit));
    rows_.describe("symbol", std::string(column.symbol));
    rows_.describe("long_name", std::string(column.meaning));
  }
  void add(const std::string& cell) override { pending_.push_back(number(cell)); }
  void write() override {
    rows_.append(pending_.data(), pending_.size(), H5::PredType::NATIVE_DOUBLE);
    pending_.clear();
  }

  const H5::DataSet& dataset() const override { return rows_.dataset(); }

 private:
  hdf5::Rows rows_;
  std::vector<double> pending_;
};

/// Text of any length; that of an empty cell takes no place.
class TextColumn final : public Column {
 public:
  TextColumn(const H5::H5File& file, const std::string& name)
      : type_(utf8_text()), rows_(file, name, type_) {}
  void add(const std::string& cell) override { pending_.push_back(cell); }
  void write() override {
    std::vector<const char*> starts;
    for (const auto& one : pending_) starts.push_back(one.empty() ? nullptr : one.c_str());
    rows_.append(starts.data(), starts.size(), type_);
    pending_.clear();
  }

  const H5::DataSet& dataset() const override { return rows_.dataset(); }

 private:
  H5::StrType type_;
  hdf5::Rows rows_;
  std::vector<std::string> pending_;
};

/// How many points lie along each axis.
void write_shape(const H5::H5File& file, const study::Design& design) {
  std::vector<std::int64_t> counts;
  for (const auto& axis : design.axes) counts.push_back(axis.count);
  const hsize_t axes = counts.size();
  file.createAttribute("shape", H5::PredType::STD_I64LE, H5::DataSpace(1, &axes))
      .write(H5::PredType::NATIVE_INT64, counts.data());
}

/// '/' separates groups in HDF5, and '.' is a group itself.
void expect_name(const std::filesystem::path& file, const std::string& column) {
  if (column != "." && column.find('/') == column.npos) return;
  throw FileError("cannot write " + file.string() + ": there '" + column +
                  "' is no name of a column; give it one without '/'");
}

class Hdf5Sweep final : public SweepFile {
 public:
  Hdf5Sweep(const std::filesystem::path& path, const study::Design& design,
            const std::vector<study::Column>& columns, const Attributes& origin)
      : target_(path, temporary_name(path)) {
    for (const auto& column : columns) expect_name(path, column.key);
    target_.guarded([&] {
      for (const auto& [name, words] : origin) hdf5::describe(target_.file(), name, words);
      write_shape(target_.file(), design);
      for (const auto& parameter : design.parameters)
        add_column({.key = parameter.key, .unit = parameter.unit}, is_numeric(parameter));
      for (const auto& column : columns) add_column(column, true);
      for (const char* words : {"ending", "reason"}) add_column({words}, false);
      points_ = std::make_unique<hdf5::Rows>(target_.file(), "point", H5::PredType::STD_I64LE);
      hdf5::make_axis(points_->dataset(), "point");
      for (const auto& column : columns_) hdf5::attach(column->dataset(), 0, points_->dataset());
    });
  }

  void add(std::string_view rows) override {
    for (; !rows.empty(); rows.remove_prefix(rows.find('\n') + 1)) {
      split(rows.substr(0, rows.find('\n')), cells_);
      for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i]->add(cells_.at(i));
      ++pending_;
    }
    if (pending_ >= most_pending_rows) target_.guarded([&] { write(); });
  }

  void commit() override {
    target_.guarded([&] { write(); });
    columns_.clear();
    points_.reset();
    target_.commit();
  }

 private:
  void add_column(const study::Column& column, bool is_numeric) {
    if (is_numeric)
      columns_.push_back(std::make_unique<NumberColumn>(target_.file(), column));
    else
      columns_.push_back(std::make_unique<TextColumn>(target_.file(), column.key));
  }
  void write() {
    for (auto& column : columns_) column->write();
    std::vector<std::int64_t> numbers(static_cast<std::size_t>(pending_));
    std::iota(numbers.begin(), numbers.end(), written_);
    points_->append(numbers.data(), numbers.size(), H5::PredType::NATIVE_INT64);
    written_ += pending_;
    pending_ = 0;
  }

  hdf5::NewFile target_;
  std::vector<std::unique_ptr<Column>> columns_;
  std::unique_ptr<hdf5::Rows> points_;  ///< numbers of the points, from 0: the axis of all columns
  Index pending_ = 0, written_ = 0;
  std::vector<std::string> cells_;
};

}  // namespace

std::unique_ptr<SweepFile> new_hdf5_sweep(const std::filesystem::path& path, const study::Design& design,
                                          const std::vector<study::Column>& columns,
                                          const Attributes& origin) {
  return std::make_unique<Hdf5Sweep>(path, design, columns, origin);
}

}  // namespace mariotte::report
