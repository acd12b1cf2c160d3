#pragma once
// Internal to results/: the little of HDF5's C interface that results need.
//
// A file is composed in memory (HDF5's core driver) and handed over as bytes, which write_whole() puts on the disk. So HDF5 never
// meets a full disk or a missing folder, which it reports late, and after a failed close keeps trying until the program ends.

#include <fmt/format.h>
#include <hdf5.h>

#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace femsph::hdf5 {

/// Owns one HDF5 identifier.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// The innermost reason on HDF5's error stack.
inline std::string reason() {
  std::string text = "unknown reason";
  const auto keep_last = [](unsigned, const H5E_error2_t* e, void* out) -> herr_t {
    if (e->desc) *static_cast<std::string*>(out) = e->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_last, &text);
  return text;
}

template <class T>
hid_t memory_type() {
  if constexpr (std::is_same_v<T, double>)
    return H5T_NATIVE_DOUBLE;
  else
    return H5T_NATIVE_INT64;
}

/// An HDF5 file in memory. Errors throw std::runtime_error naming the file that it is to become.
class Image {
 public:
  explicit Image(std::string file) : file_(std::move(file)), id_(create()) {}

  /// Values row by row; groups on the way to `path` are created. T is double or long long.
  template <class T>
  void dataset(const std::string& path, const std::vector<T>& values, std::vector<hsize_t> shape) {
    const Handle space(check(H5Screate_simple(int(shape.size()), shape.data(), nullptr), path), H5Sclose);
    const Handle links(check(H5Pcreate(H5P_LINK_CREATE), path), H5Pclose);
    check(H5Pset_create_intermediate_group(links, 1), path);
    const Handle set(check(H5Dcreate2(id_, path.c_str(), memory_type<T>(), space, links, H5P_DEFAULT, H5P_DEFAULT), path), H5Dclose);
    check(H5Dwrite(set, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path);
  }

  /// Attributes of the dataset or group at `path`.
  void attribute(const std::string& path, const std::string& name, double value) { attribute(path, name, H5T_NATIVE_DOUBLE, &value); }
  void attribute(const std::string& path, const std::string& name, const std::string& text) {
    const Handle type(check(H5Tcopy(H5T_C_S1), path), H5Tclose);
    check(H5Tset_size(type, text.size() + 1), path);
    check(H5Tset_cset(type, H5T_CSET_UTF8), path);
    attribute(path, name, type, text.c_str());
  }

  std::string bytes() const {
    check(H5Fflush(id_, H5F_SCOPE_GLOBAL), "/");
    std::string image(check(H5Fget_file_image(id_, nullptr, 0), "/"), '\0');
    check(H5Fget_file_image(id_, image.data(), image.size()), "/");
    return image;
  }

 private:
  Handle create() const {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors become exceptions, not text on stderr
    const Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "/"), H5Pclose);
    check(H5Pset_fapl_core(access, 1 << 20, 0), "/");
    const Handle creation(check(H5Pcreate(H5P_FILE_CREATE), "/"), H5Pclose);
    check(H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), "/");  // columns keep their order
    return {check(H5Fcreate(file_.c_str(), H5F_ACC_TRUNC, creation, access), "/"), H5Fclose};
  }

  void attribute(const std::string& path, const std::string& name, hid_t type, const void* value) {
    const Handle space(check(H5Screate(H5S_SCALAR), path), H5Sclose);
    const Handle a(check(H5Acreate_by_name(id_, path.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), path),
                   H5Aclose);
    check(H5Awrite(a, type, value), path);
  }

  template <class Result>
  Result check(Result result, const std::string& path) const {
    if (result < 0) throw std::runtime_error(fmt::format("cannot write {} (HDF5, {}): {}", file_, path, reason()));
    return result;
  }

  std::string file_;
  Handle id_;
};

}  // namespace femsph::hdf5
