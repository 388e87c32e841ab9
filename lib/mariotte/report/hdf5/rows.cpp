#include "mariotte/report/hdf5/rows.hpp"

#include <algorithm>

namespace mariotte::report::hdf5 {
namespace {

constexpr hsize_t values_per_chunk = 8192;  // 64 KiB of numbers

}  // namespace

Rows::Rows(const H5::H5File& file, const std::string& name, const H5::DataType& type, const Extent& row)
    : extent_{0} {
  for (const hsize_t columns : row) extent_.push_back(columns), width_ *= columns;
  Extent most = extent_, chunk = extent_;
  most[0] = H5S_UNLIMITED;
  chunk[0] = std::max<hsize_t>(1, values_per_chunk / width_);
  const int rank = static_cast<int>(extent_.size());
  H5::DSetCreatPropList layout;
  layout.setChunk(rank, chunk.data());
  if (type.getClass() == H5T_STRING && H5Zfilter_avail(H5Z_FILTER_DEFLATE)) layout.setDeflate(1);
  dataset_ = file.createDataSet(name, type, H5::DataSpace(rank, extent_.data(), most.data()), layout);
}

void Rows::append(const void* values, hsize_t rows, const H5::DataType& type) {
  if (rows == 0) return;
  Extent start(extent_.size(), 0), count = extent_;
  start[0] = extent_[0];
  count[0] = rows;
  extent_[0] += rows;
  dataset_.extend(extent_.data());
  auto there = dataset_.getSpace();
  there.selectHyperslab(H5S_SELECT_SET, count.data(), start.data());
  dataset_.write(values, type, H5::DataSpace(static_cast<int>(count.size()), count.data()), there);
}

void Rows::describe(const std::string& name, const std::string& text) const {
  hdf5::describe(dataset_, name, text);
}

void describe(const H5::H5Object& object, const std::string& name, const std::string& text) {
  if (text.empty()) return;
  H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);  // which h5py reads as text, not as bytes
  type.setCset(H5T_CSET_UTF8);
  object.createAttribute(name, type, H5::DataSpace()).write(type, text);
}

}  // namespace mariotte::report::hdf5
