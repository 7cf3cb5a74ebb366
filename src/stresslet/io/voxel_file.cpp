#include "stresslet/io/voxel_file.hpp"

#include <fmt/format.h>

#include <cstring>
#include <regex>

#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/hdf5.hpp"

namespace stresslet {

namespace {

struct Request {
  const std::filesystem::path& file;
  const std::array<int, 3>& size;
  const std::string& where;

  std::size_t count() const { return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]); }
  std::string shape() const { return fmt::format("({}, {}, {})", size[2], size[1], size[0]); }

  [[noreturn]] void refuse(const std::string& problem, const std::string& reason, const std::string& fix) const {
    throw InputError({where, fmt::format("{}: {}", file.string(), problem), reason, fix});
  }
  [[noreturn]] void refuse_size(const std::string& found) const {
    refuse(fmt::format("the voxels are of another size: {}", found),
           fmt::format("the domain has {} x {} x {} cells, so {} bytes or shape (nz, ny, nx) = {} are needed", size[0],
                       size[1], size[2], count(), shape()),
           "make voxels of this size, or choose domain.size and domain.resolution to match");
  }
};

std::vector<std::uint8_t> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

/// The header of a .npy file (NumPy enhancement proposal 1): magic, version, length, then a Python dictionary.
std::vector<std::uint8_t> read_npy(const Request& request, std::string_view text) {
  const auto byte = [&](std::size_t k) { return std::size_t(std::uint8_t(text[k])); };
  const auto damaged = [&] {
    request.refuse("this is not a NumPy file", "its header is damaged or of an unknown version",
                   "write it with numpy.save, or give raw bytes");
  };
  if (text.size() < 12 || text.substr(0, 6) != "\x93NUMPY") damaged();
  const bool long_header = byte(6) > 1;
  const std::size_t start = long_header ? 12 : 10;
  const std::size_t length =
      long_header ? byte(8) | byte(9) << 8 | byte(10) << 16 | byte(11) << 24 : byte(8) | byte(9) << 8;
  if (start + length > text.size()) damaged();
  const std::string header(text.substr(start, length));
  std::smatch found;
  if (!std::regex_search(header, found, std::regex("'descr': *'[|<>=]?([a-z]\\d*|\\?)'"))) damaged();
  const std::string kind = found[1];
  if (kind != "u1" && kind != "i1" && kind != "b1" && kind != "?")
    request.refuse(fmt::format("its items are of type {}", kind), "voxels are one byte each",
                   "save it as array.astype(numpy.uint8)");
  if (header.find("'fortran_order': False") == std::string::npos)
    request.refuse("its order is that of Fortran", "voxels are read with x fastest, shape (nz, ny, nx)",
                   "save numpy.ascontiguousarray(array)");
  if (!std::regex_search(header, found, std::regex("'shape': *\\(([0-9, ]*)\\)"))) damaged();
  std::vector<std::size_t> shape;
  const std::string numbers = found[1];
  const std::regex number("\\d{1,9}");
  for (std::sregex_iterator n(numbers.begin(), numbers.end(), number), end; n != end; ++n)
    shape.push_back(std::stoul(n->str()));
  const std::vector<std::size_t> wanted{std::size_t(request.size[2]), std::size_t(request.size[1]),
                                        std::size_t(request.size[0])};
  const bool flat = request.size[2] == 1 && shape == std::vector(wanted.begin() + 1, wanted.end());
  if (shape != wanted && !flat) request.refuse_size(fmt::format("shape ({})", numbers));
  const std::string_view content = text.substr(start + length);
  if (content.size() != request.count()) request.refuse_size(fmt::format("{} bytes of content", content.size()));
  return bytes_of(content);
}

std::vector<std::uint8_t> read_hdf5(const Request& request) {
  try {
    const hdf5::File file = hdf5::File::open_read_only(request.file);
    const hdf5::Shape shape = file.shape("/solid");
    if (shape != hdf5::Shape{std::size_t(request.size[2]), std::size_t(request.size[1]), std::size_t(request.size[0])})
      request.refuse_size(fmt::format("shape ({})", fmt::join(shape, ", ")));
    return file.read<std::uint8_t>("/solid");
  } catch (const hdf5::Failure& failure) {
    request.refuse("the voxels cannot be read", failure.what(), "give an HDF5 file with a dataset 'solid'");
  }
}

std::vector<std::uint8_t> read_raw(const Request& request, std::string_view text) {
  if (text.size() != request.count()) request.refuse_size(fmt::format("{} bytes", text.size()));
  return bytes_of(text);
}

}  // namespace

std::vector<std::uint8_t> read_voxels(const std::filesystem::path& file, const std::array<int, 3>& size,
                                      const std::string& where) {
  const Request request{file, size, where};
  if (!std::filesystem::is_regular_file(file))
    request.refuse("there is no such file", "the voxels of the solid are read from it", "correct the name");
  const std::string ending = file.extension().string();
  std::vector<std::uint8_t> voxels;
  if (ending == ".h5" || ending == ".hdf5")
    voxels = read_hdf5(request);
  else if (ending == ".npy")
    voxels = read_npy(request, read_whole_file(file));
  else
    voxels = read_raw(request, read_whole_file(file));
  for (std::uint8_t& voxel : voxels) voxel = voxel != 0;
  return voxels;
}

}  // namespace stresslet
