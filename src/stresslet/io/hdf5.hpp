#pragma once
/// The part of HDF5 this project needs: groups, datasets, text and attributes, addressed by absolute path
/// ("/series/strain"). <hdf5.h> stays in hdf5.cpp. Arrays are row-major; chunks carry Fletcher-32 checksums and the
/// file format's own metadata is checksummed too, so that other readers notice damage. Never open a file that may be
/// damaged: HDF5 1.10 can crash while it lists the links of a group whose metadata was overwritten.
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace stresslet::hdf5 {

template <class T>
concept Element = std::same_as<T, double> || std::same_as<T, std::int32_t> || std::same_as<T, std::int64_t> ||
    std::same_as<T, std::uint8_t>;

enum class Kind { float64, int32, int64, uint8, text, other };

using Shape = std::vector<std::size_t>;

/// A call into HDF5 failed: what was attempted, on which object, and the library's most specific reason.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An open file. Every member throws Failure, and HDF5 itself prints nothing.
class File {
 public:
  /// Whether the file begins as an HDF5 file does; it may still be damaged.
  static bool has_signature(const std::filesystem::path& path);
  /// Creates or empties the file. Space freed by `remove` is reused, also after reopening.
  static File create(const std::filesystem::path& path);
  static File open_read_only(const std::filesystem::path& path);
  static File open_read_write(const std::filesystem::path& path);

  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;
  ~File();

  /// Flushes and closes; the destructor does the same but cannot report a failure.
  void close();

  bool contains(const std::string& path) const;
  /// Names in a group, sorted.
  std::vector<std::string> members(const std::string& group) const;
  void create_group(const std::string& path);
  void remove(const std::string& path);

  Shape shape(const std::string& path) const;
  Kind kind(const std::string& path) const;

  /// Writes a dataset of the given shape, replacing what stood there; missing groups are made.
  template <Element T>
  void write(const std::string& path, std::span<const T> values, const Shape& shape);
  template <Element T>
  void write(const std::string& path, const std::vector<T>& values) {
    write<T>(path, values, {values.size()});
  }
  /// Makes an empty one-dimensional dataset for `append`.
  template <Element T>
  void create_extendible(const std::string& path);
  template <Element T>
  void append(const std::string& path, std::span<const T> values);
  /// All elements in row-major order, converted to T.
  template <Element T>
  std::vector<T> read(const std::string& path) const;

  void write_text(const std::string& path, const std::string& text);
  std::string read_text(const std::string& path) const;

  bool has_attribute(const std::string& path, const std::string& name) const;
  std::vector<std::string> attribute_names(const std::string& path) const;
  Kind attribute_kind(const std::string& path, const std::string& name) const;
  template <Element T>
  void set_attribute(const std::string& path, const std::string& name, T value);
  template <Element T>
  void set_attribute(const std::string& path, const std::string& name, std::span<const T> values);
  void set_attribute(const std::string& path, const std::string& name, const std::string& text);
  void remove_attribute(const std::string& path, const std::string& name);
  template <Element T>
  T attribute(const std::string& path, const std::string& name) const;
  template <Element T>
  std::vector<T> attribute_array(const std::string& path, const std::string& name) const;
  std::string text_attribute(const std::string& path, const std::string& name) const;

 private:
  explicit File(std::int64_t id) : id_(id) {}
  std::int64_t id_ = -1;
};

}  // namespace stresslet::hdf5
