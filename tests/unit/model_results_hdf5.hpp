#pragma once
// Reads HDF5 files back with the plain C interface, which the writer does not use.

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace femsph::test {

struct Dataset {
  std::vector<hsize_t> shape;
  std::vector<double> values;  ///< integers too
  bool integer = false;
};

/// Throws if there is no such dataset.
inline Dataset read_hdf5(const std::string& file, const std::string& path) {
  const hid_t f = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t d = f < 0 ? -1 : H5Dopen2(f, path.c_str(), H5P_DEFAULT);
  if (d < 0) throw std::runtime_error("no dataset " + file + ":" + path);
  Dataset out;
  const hid_t space = H5Dget_space(d), type = H5Dget_type(d);
  out.integer = H5Tget_class(type) == H5T_INTEGER;
  out.shape.resize(H5Sget_simple_extent_ndims(space));
  H5Sget_simple_extent_dims(space, out.shape.data(), nullptr);
  out.values.resize(H5Sget_simple_extent_npoints(space));
  H5Dread(d, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.values.data());
  H5Tclose(type), H5Sclose(space), H5Dclose(d), H5Fclose(f);
  return out;
}

inline std::string read_text_attribute(const std::string& file, const std::string& path,
                                       const std::string& name) {
  const hid_t f = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t a = H5Aopen_by_name(f, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (a < 0) throw std::runtime_error("no attribute " + name + " of " + file + ":" + path);
  const hid_t type = H5Aget_type(a);
  std::string text(H5Tget_size(type), '\0');
  H5Aread(a, type, text.data());
  H5Tclose(type), H5Aclose(a), H5Fclose(f);
  return text.c_str();
}

/// Names in the root group, in the order they were made.
inline std::vector<std::string> root_names(const std::string& file) {
  const hid_t f = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->push_back(name);
    return 0;
  };
  H5Literate(f, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, add, &names);
  H5Fclose(f);
  return names;
}

}  // namespace femsph::test
