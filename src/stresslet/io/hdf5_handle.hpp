#pragma once
/// Internal to io/hdf5*.cpp: owned HDF5 identifiers, silenced error printing and errors as exceptions.
#include <hdf5.h>

#include <string>
#include <utility>

#include "stresslet/io/hdf5.hpp"

namespace stresslet::hdf5 {

static_assert(std::same_as<hid_t, std::int64_t>);

/// Stops HDF5 from printing its error stack while alive. Declare before any Handle.
class Silence {
 public:
  Silence() {
    // Every file is closed by its owner; at exit HDF5 would only print about files it failed to open.
    [[maybe_unused]] static const herr_t once = H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

[[noreturn]] inline void fail(const std::string& attempt) {
  std::string reason;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* entry, void* text) -> herr_t {
        auto& first = *static_cast<std::string*>(text);
        if (first.empty() && entry->desc) first = entry->desc;
        return 0;
      },
      &reason);
  throw Failure("cannot " + attempt + (reason.empty() ? "" : " (HDF5: " + reason + ")"));
}

/// Returns `result`, or throws if it is negative, HDF5's mark of failure.
template <class Result>
Result check(Result result, const std::string& attempt) {
  if (result < 0) fail(attempt);
  return result;
}

/// Owns an identifier of any kind.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const std::string& attempt) : id_(check(id, attempt)), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

template <Element T>
hid_t native_type() {
  if constexpr (std::same_as<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::same_as<T, std::int32_t>) return H5T_NATIVE_INT32;
  if constexpr (std::same_as<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::same_as<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

inline Kind kind_of(hid_t type) {
  switch (H5Tget_class(type)) {
    case H5T_STRING:
      return Kind::text;
    case H5T_FLOAT:
      return H5Tget_size(type) == 8 ? Kind::float64 : Kind::other;
    case H5T_INTEGER:
      if (H5Tget_sign(type) == H5T_SGN_NONE) return H5Tget_size(type) == 1 ? Kind::uint8 : Kind::other;
      return H5Tget_size(type) == 8 ? Kind::int64 : H5Tget_size(type) == 4 ? Kind::int32 : Kind::other;
    default:
      return Kind::other;
  }
}

inline Shape shape_of(hid_t space) {
  const int rank = check(H5Sget_simple_extent_ndims(space), "read a rank");
  std::vector<hsize_t> extent(std::size_t(rank) + 1);
  check(H5Sget_simple_extent_dims(space, extent.data(), nullptr), "read a shape");
  return Shape(extent.begin(), extent.begin() + rank);
}

inline std::size_t element_count(const Shape& shape) {
  std::size_t count = 1;
  for (std::size_t n : shape) count *= n;
  return count;
}

/// Link creation properties: missing groups are made, names are UTF-8.
inline Handle make_groups() {
  Handle list(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "make a property list");
  check(H5Pset_create_intermediate_group(list, 1), "set a property");
  check(H5Pset_char_encoding(list, H5T_CSET_UTF8), "set a property");
  return list;
}

inline Handle open_dataset(hid_t file, const std::string& path) {
  return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, "open dataset " + path};
}

}  // namespace stresslet::hdf5
