#include "stresslet/io/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "stresslet/io/hdf5_handle.hpp"

namespace stresslet::hdf5 {
namespace {

constexpr std::size_t chunk_elements = 1 << 16;  // 512 KiB of doubles: one chunk fits HDF5's chunk cache
constexpr hsize_t series_chunk = 512;            // small, as every column holds at least one chunk

Handle access_properties() {
  Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  check(H5Pset_libver_bounds(list, H5F_LIBVER_V110, H5F_LIBVER_V110), "set a property");
  check(H5Pset_fclose_degree(list, H5F_CLOSE_STRONG), "set a property");
  // Only files that nobody else knows of are written, and some network file systems cannot lock.
  check(H5Pset_file_locking(list, false, true), "set a property");
  return list;
}

Handle checked_chunks(const std::vector<hsize_t>& chunk) {
  Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
  check(H5Pset_obj_track_times(list, false), "set a property");
  if (!chunk.empty()) {
    check(H5Pset_chunk(list, int(chunk.size()), chunk.data()), "set the chunk size");
    check(H5Pset_fletcher32(list), "ask for checksums");
  }
  return list;
}

std::vector<hsize_t> chunk_of(const Shape& shape) {
  if (shape.empty() || element_count(shape) == 0) return {};
  std::vector<hsize_t> chunk(shape.begin(), shape.end());
  const std::size_t row = element_count(shape) / shape[0];
  chunk[0] = std::clamp<hsize_t>(chunk_elements / row, 1, shape[0]);
  return chunk;
}

std::string quoted(const std::filesystem::path& path) { return fmt::format("'{}'", path.string()); }

}  // namespace

bool File::has_signature(const std::filesystem::path& path) {
  std::array<char, 8> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return std::string_view(start.data(), start.size()) == "\x89HDF\r\n\x1a\n";
}

File File::create(const std::filesystem::path& path) {
  const Silence silence;
  const Handle access = access_properties();
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "make a property list");
  check(H5Pset_obj_track_times(creation, false), "set a property");  // of the root group: same data, same bytes
  check(H5Pset_file_space_strategy(creation, H5F_FSPACE_STRATEGY_FSM_AGGR, true, 1), "keep track of free space");
  return File(check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access), "create " + quoted(path)));
}

File File::open_read_only(const std::filesystem::path& path) {
  const Silence silence;
  return File(check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access_properties()), "open " + quoted(path)));
}

File File::open_read_write(const std::filesystem::path& path) {
  const Silence silence;
  return File(check(H5Fopen(path.c_str(), H5F_ACC_RDWR, access_properties()), "open " + quoted(path) + " to write"));
}

File::File(File&& other) noexcept : id_(std::exchange(other.id_, -1)) {}

File& File::operator=(File&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

File::~File() {
  const Silence silence;
  if (id_ >= 0) H5Fclose(id_);
}

void File::close() {
  const Silence silence;
  if (id_ < 0) return;
  check(H5Fflush(id_, H5F_SCOPE_GLOBAL), "flush the file");
  check(H5Fclose(std::exchange(id_, -1)), "close the file");
}

bool File::contains(const std::string& path) const {
  const Silence silence;
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    const std::string part = path.substr(0, end);
    if (part != "/" && check(H5Lexists(id_, part.c_str(), H5P_DEFAULT), "look for " + part) == 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::vector<std::string> File::members(const std::string& group) const {
  const Silence silence;
  const Handle handle(H5Gopen2(id_, group.c_str(), H5P_DEFAULT), H5Gclose, "open group " + group);
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  check(H5Literate(handle, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), "list group " + group);
  std::sort(names.begin(), names.end());
  return names;
}

void File::create_group(const std::string& path) {
  const Silence silence;
  const Handle group(H5Gcreate2(id_, path.c_str(), make_groups(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                     "create group " + path);
}

void File::remove(const std::string& path) {
  const Silence silence;
  check(H5Ldelete(id_, path.c_str(), H5P_DEFAULT), "remove " + path);
}

Shape File::shape(const std::string& path) const {
  const Silence silence;
  const Handle dataset = open_dataset(id_, path);
  return shape_of(Handle(H5Dget_space(dataset), H5Sclose, "read the shape of " + path));
}

Kind File::kind(const std::string& path) const {
  const Silence silence;
  const Handle dataset = open_dataset(id_, path);
  return kind_of(Handle(H5Dget_type(dataset), H5Tclose, "read the type of " + path));
}

template <Element T>
void File::write(const std::string& path, std::span<const T> values, const Shape& shape_wanted) {
  const Silence silence;
  if (values.size() != element_count(shape_wanted)) throw std::logic_error("shape does not fit the values: " + path);
  if (contains(path)) {
    const Kind same = kind_of(native_type<T>());
    if (kind(path) != same || shape(path) != shape_wanted) remove(path);
  }
  if (!contains(path)) {
    const std::vector<hsize_t> extent(shape_wanted.begin(), shape_wanted.end());
    const Handle space(H5Screate_simple(int(extent.size()), extent.data(), nullptr), H5Sclose, "make a shape");
    const Handle dataset(H5Dcreate2(id_, path.c_str(), native_type<T>(), space, make_groups(),
                                    checked_chunks(chunk_of(shape_wanted)), H5P_DEFAULT),
                         H5Dclose, "create dataset " + path);
  }
  if (values.empty()) return;
  check(H5Dwrite(open_dataset(id_, path), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "write " + path);
}

template <Element T>
void File::create_extendible(const std::string& path) {
  const Silence silence;
  const hsize_t none = 0, unlimited = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose, "make a shape");
  const Handle dataset(H5Dcreate2(id_, path.c_str(), native_type<T>(), space, make_groups(),
                                  checked_chunks({series_chunk}), H5P_DEFAULT),
                       H5Dclose, "create dataset " + path);
}

template <Element T>
void File::append(const std::string& path, std::span<const T> values) {
  const Silence silence;
  if (values.empty()) return;
  const Handle dataset = open_dataset(id_, path);
  const Shape before = shape_of(Handle(H5Dget_space(dataset), H5Sclose, "read the shape of " + path));
  if (before.size() != 1) throw std::logic_error("not one-dimensional: " + path);
  const hsize_t start = before[0], count = values.size(), total = start + count;
  check(H5Dset_extent(dataset, &total), "extend " + path);
  const Handle target(H5Dget_space(dataset), H5Sclose, "read the shape of " + path);
  check(H5Sselect_hyperslab(target, H5S_SELECT_SET, &start, nullptr, &count, nullptr), "select in " + path);
  const Handle source(H5Screate_simple(1, &count, nullptr), H5Sclose, "make a shape");
  check(H5Dwrite(dataset, native_type<T>(), source, target, H5P_DEFAULT, values.data()), "append to " + path);
}

template <Element T>
std::vector<T> File::read(const std::string& path) const {
  const Silence silence;
  const Handle dataset = open_dataset(id_, path);
  std::vector<T> values(element_count(shape_of(Handle(H5Dget_space(dataset), H5Sclose, "read the shape of " + path))));
  check(H5Dread(dataset, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read " + path);
  return values;
}

template void File::write<double>(const std::string&, std::span<const double>, const Shape&);
template void File::write<std::int32_t>(const std::string&, std::span<const std::int32_t>, const Shape&);
template void File::write<std::int64_t>(const std::string&, std::span<const std::int64_t>, const Shape&);
template void File::write<std::uint8_t>(const std::string&, std::span<const std::uint8_t>, const Shape&);
template void File::create_extendible<double>(const std::string&);
template void File::create_extendible<std::int64_t>(const std::string&);
template void File::append<double>(const std::string&, std::span<const double>);
template void File::append<std::int64_t>(const std::string&, std::span<const std::int64_t>);
template std::vector<double> File::read<double>(const std::string&) const;
template std::vector<std::int32_t> File::read<std::int32_t>(const std::string&) const;
template std::vector<std::int64_t> File::read<std::int64_t>(const std::string&) const;
template std::vector<std::uint8_t> File::read<std::uint8_t>(const std::string&) const;

}  // namespace stresslet::hdf5
