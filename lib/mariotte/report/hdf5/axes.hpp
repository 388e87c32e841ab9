// Axes of datasets as HDF5's dimension scales, which h5py, xarray and netCDF find by themselves.
#pragma once
#include <H5Cpp.h>

#include <string>

namespace mariotte::report::hdf5 {

/// Makes a dataset an axis of this name.
void make_axis(const H5::DataSet& axis, const std::string& name);

/// Dimension `number` of the data, from 0, is counted along this axis.
void attach(const H5::DataSet& data, unsigned number, const H5::DataSet& axis);

}  // namespace mariotte::report::hdf5
