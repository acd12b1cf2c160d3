#pragma once
// Internal to results/: HDF5 files in memory, with the C interface of HDF5.
//
// A file is composed in memory (core driver of HDF5) and then written by write_whole(). So HDF5 never has to
// handle a full disk or a missing folder, which it reports late and retries until the program ends.

#include <fmt/format.h>
#include <hdf5.h>

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
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

/// What the two kinds of files in memory share: the name of the file on disk, and the check of every call.
class MemoryFile {
 protected:
  /// `verb`: "write" or "read", for messages.
  MemoryFile(std::string file, const char* verb) : file_(std::move(file)), verb_(verb) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors become exceptions, not text on stderr
  }
  /// Throws std::runtime_error where HDF5 has returned an error.
  template <class Result>
  Result check(Result result, const std::string& path) const {
    if (result < 0)
      throw std::runtime_error(fmt::format("cannot {} {} (HDF5, {}): {}", verb_, file_, path, reason()));
    return result;
  }
  /// Access to a file in memory.
  Handle core_access() const {
    Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "/"), H5Pclose);
    check(H5Pset_fapl_core(access, 1 << 20, 0), "/");
    return access;
  }
  std::string file_;

 private:
  const char* verb_;
};

/// An HDF5 file that is composed in memory. Errors throw std::runtime_error naming the file that it is to
/// become.
class Image : MemoryFile {
 public:
  explicit Image(std::string file) : MemoryFile(std::move(file), "write"), id_(create()) {}

  /// Values row by row; groups on the way to `path` are created. T is double or long long.
  template <class T>
  void dataset(const std::string& path, const std::vector<T>& values, std::vector<hsize_t> shape) {
    dataset(path, memory_type<T>(), values.data(), std::move(shape));
  }
  void dataset(const std::string& path, hid_t type, const void* values, std::vector<hsize_t> shape) {
    const Handle space(check(H5Screate_simple(int(shape.size()), shape.data(), nullptr), path), H5Sclose);
    const Handle links(check(H5Pcreate(H5P_LINK_CREATE), path), H5Pclose);
    check(H5Pset_create_intermediate_group(links, 1), path);
    const Handle creation(check(H5Pcreate(H5P_DATASET_CREATE), path), H5Pclose);
    check(H5Pset_obj_track_times(creation, 0),
          path);  // no times, so that equal results give equal files
    const Handle set(
        check(H5Dcreate2(id_, path.c_str(), type, space, links, creation, H5P_DEFAULT), path), H5Dclose);
    if (values) check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path);
  }
  /// One text, byte for byte.
  void text(const std::string& path, const std::string& text) {
    dataset(path, H5T_NATIVE_UCHAR, text.data(), {text.size()});
  }

  /// Attributes of the dataset or group at `path`.
  void attribute(const std::string& path, const std::string& name, double value) {
    attribute(path, name, H5T_NATIVE_DOUBLE, &value);
  }
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
    const Handle access = core_access();
    const Handle creation(check(H5Pcreate(H5P_FILE_CREATE), "/"), H5Pclose);
    check(H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
          "/");  // columns keep their order
    return {check(H5Fcreate(file_.c_str(), H5F_ACC_TRUNC, creation, access), "/"), H5Fclose};
  }

  void attribute(const std::string& path, const std::string& name, hid_t type, const void* value) {
    const Handle space(check(H5Screate(H5S_SCALAR), path), H5Sclose);
    const Handle a(check(H5Acreate_by_name(id_, path.c_str(), name.c_str(), type, space, H5P_DEFAULT,
                                           H5P_DEFAULT, H5P_DEFAULT),
                         path),
                   H5Aclose);
    check(H5Awrite(a, type, value), path);
  }

  Handle id_;
};

/// An HDF5 file that is read from bytes in memory. Errors throw std::runtime_error naming the file that
/// it came from.
class Opened : MemoryFile {
 public:
  Opened(std::string file, std::string_view bytes) : MemoryFile(std::move(file), "read"), id_(open(bytes)) {}

  /// Number of values of a dataset.
  std::size_t length(const std::string& path) const {
    const Handle set(check(H5Dopen2(id_, path.c_str(), H5P_DEFAULT), path), H5Dclose);
    const Handle space(check(H5Dget_space(set), path), H5Sclose);
    return std::size_t(check(H5Sget_simple_extent_npoints(space), path));
  }
  /// All of them; there must be `count`.
  void read(const std::string& path, hid_t type, void* values, std::size_t count) const {
    if (length(path) != count)
      throw std::runtime_error(fmt::format("cannot read {}: {} has another length", file_, path));
    if (count == 0) return;
    const Handle set(check(H5Dopen2(id_, path.c_str(), H5P_DEFAULT), path), H5Dclose);
    check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path);
  }
  std::string text(const std::string& path) const {
    std::string text(length(path), '\0');
    read(path, H5T_NATIVE_UCHAR, text.data(), text.size());
    return text;
  }

 private:
  Handle open(std::string_view bytes) const {
    const Handle access = core_access();
    check(H5Pset_file_image(access, const_cast<char*>(bytes.data()), bytes.size()), "/");  // it takes a copy
    const std::string name = file_ + " in memory";  // HDF5 insists that no file of that name exists
    return {check(H5Fopen(name.c_str(), H5F_ACC_RDONLY, access), "/"), H5Fclose};
  }
  Handle id_;
};

}  // namespace femsph::hdf5
