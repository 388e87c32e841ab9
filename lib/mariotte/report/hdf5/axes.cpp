#include "mariotte/report/hdf5/axes.hpp"

#include <hdf5_hl.h>

namespace mariotte::report::hdf5 {

void make_axis(const H5::DataSet& axis, const std::string& name) {
  if (H5DSset_scale(axis.getId(), name.c_str()) < 0) throw H5::DataSetIException("make_axis", name);
}

void attach(const H5::DataSet& data, unsigned number, const H5::DataSet& axis) {
  if (H5DSattach_scale(data.getId(), axis.getId(), number) < 0)
    throw H5::DataSetIException("attach", "an axis is refused");
}

}  // namespace mariotte::report::hdf5
