#include <vector>

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/csv/sweep_csv.hpp"
#include "mariotte/report/hdf5/axes.hpp"
#include "mariotte/report/hdf5/new_file.hpp"
#include "mariotte/report/hdf5/rows.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/trace_file.hpp"

namespace mariotte::report {
namespace {

/// A column of a table: its head with unit, and its cells.
struct TitledColumn {
  std::string title;
  std::vector<double> value;
};

std::vector<TitledColumn> columns_of(std::string_view csv) {
  std::vector<TitledColumn> columns;
  std::vector<std::string> cells;
  for (bool is_head = true; !csv.empty(); csv.remove_prefix(csv.find('\n') + 1), is_head = false) {
    split(csv.substr(0, csv.find('\n')), cells);
    if (is_head)
      for (const auto& title : cells) columns.push_back({title, {}});
    else
      for (std::size_t i = 0; i < columns.size(); ++i) columns[i].value.push_back(number(cells.at(i)));
  }
  return columns;
}

H5::DataSet write_column(const H5::H5File& file, const TitledColumn& column) {
  const auto name = key_of_column(column.title);
  hdf5::Rows rows(file, name, H5::PredType::IEEE_F64LE);
  rows.describe("units", unit_of_column(column.title));
  rows.append(column.value.data(), column.value.size(), H5::PredType::NATIVE_DOUBLE);
  return rows.dataset();
}

}  // namespace

void write_hdf5_columns(const std::filesystem::path& path, const std::string& csv, const Attributes& origin) {
  hdf5::NewFile target(path, temporary_name(path));
  target.guarded([&] {
    for (const auto& [name, words] : origin) hdf5::describe(target.file(), name, words);
    const auto columns = columns_of(csv);
    const auto axis = write_column(target.file(), columns.front());
    hdf5::make_axis(axis, key_of_column(columns.front().title));
    for (std::size_t i = 1; i < columns.size(); ++i)
      hdf5::attach(write_column(target.file(), columns[i]), 0, axis);
  });
  target.commit();
}

}  // namespace mariotte::report
