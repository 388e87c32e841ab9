// Datasets of an HDF5 file whose rows grow at the end.
#pragma once
#include <H5Cpp.h>

#include <string>
#include <vector>

namespace mariotte::report::hdf5 {

using Extent = std::vector<hsize_t>;

/// An attribute of a file or a dataset; none is written of an empty text.
void describe(const H5::H5Object& object, const std::string& name, const std::string& text);

class Rows {
 public:
  /// A dataset without rows; each will have the shape `row`, none for a single value.
  Rows(const H5::H5File& file, const std::string& name, const H5::DataType& type, const Extent& row = {});

  /// Values of a row.
  hsize_t width() const { return width_; }

  /// `values` are those of so many rows, one row after the other.
  void append(const void* values, hsize_t rows, const H5::DataType& type);

  /// An attribute; none is written of an empty text.
  void describe(const std::string& name, const std::string& text) const;

  const H5::DataSet& dataset() const { return dataset_; }

 private:
  Extent extent_;
  hsize_t width_ = 1;
  H5::DataSet dataset_;
};

}  // namespace mariotte::report::hdf5
