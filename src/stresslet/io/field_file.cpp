#include "stresslet/io/field_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/hdf5.hpp"

namespace stresslet {

namespace {

constexpr const char* format_name = "stresslet fields";

std::size_t components_of(const hdf5::Shape& shape) { return shape.size() == 4 ? shape[3] : 1; }

FieldFile read_content(const hdf5::File& file, bool header_only) {
  if (!file.has_attribute("/", "format") || file.text_attribute("/", "format") != format_name)
    throw hdf5::Failure("it is an HDF5 file of another kind");
  FieldFile content;
  content.step = file.attribute<std::int64_t>("/", "step");
  content.time = file.attribute<double>("/", "time");
  const auto origin = file.attribute_array<double>("/", "origin"),
             spacing = file.attribute_array<double>("/", "spacing");
  if (origin.size() != 3 || spacing.size() != 3) throw hdf5::Failure("its grid is damaged");
  std::copy_n(origin.begin(), 3, content.origin.begin());
  std::copy_n(spacing.begin(), 3, content.spacing.begin());
  for (const std::string& name : file.members("/")) {
    const std::string path = "/" + name;
    const hdf5::Shape shape = file.shape(path);
    if (shape.size() != 3 && shape.size() != 4) throw hdf5::Failure(path + " is no field");
    content.count = {shape[2], shape[1], shape[0]};
    content.fields.push_back({name, file.text_attribute(path, "unit"), file.text_attribute(path, "description"),
                              int(components_of(shape)),
                              header_only ? std::vector<double>{} : file.read<double>(path)});
  }
  return content;
}

const char* attribute_type(int components) {
  return components == 1 ? "Scalar" : components == 3 ? "Vector" : "Tensor6";
}

/// The step in "000001200.h5" or "000001200.h5.part"; none for files of other names.
std::optional<std::int64_t> step_in(const std::string& name, std::string_view ending) {
  const std::size_t digits = name.find_first_not_of("0123456789");
  if (digits < 9 || digits > 18 || name.substr(std::min(digits, name.size())) != ending) return std::nullopt;
  return std::stoll(name.substr(0, digits));
}

}  // namespace

std::string field_file_name(std::int64_t step) { return fmt::format("{:09}.h5", step); }

void write_field_file(const std::filesystem::path& target, const FieldFile& content) {
  AtomicFile atomic(target, AtomicFile::Start::empty);
  try {
    hdf5::File file = hdf5::File::create(atomic.part());
    file.set_attribute("/", "format", std::string(format_name));
    file.set_attribute("/", "step", content.step);
    file.set_attribute("/", "time", content.time);
    file.set_attribute<double>("/", "origin", std::span<const double>(content.origin));
    file.set_attribute<double>("/", "spacing", std::span<const double>(content.spacing));
    for (const Field& field : content.fields) {
      hdf5::Shape shape{content.count[2], content.count[1], content.count[0]};
      if (field.components > 1) shape.push_back(std::size_t(field.components));
      file.write<double>("/" + field.name, field.values, shape);
      file.set_attribute("/" + field.name, "unit", field.unit);
      file.set_attribute("/" + field.name, "description", field.description);
    }
    file.close();
  } catch (const hdf5::Failure& failure) {
    throw Error(ExitCode::internal, {target.string(), "the fields cannot be written", failure.what(),
                                     "check the free space there; the last commit is intact"});
  }
  atomic.commit();
}

FieldFile read_field_file(const std::filesystem::path& file, bool header_only) {
  if (!std::filesystem::is_regular_file(file))
    throw InputError({file.string(), "there is no such file of fields", "the name is wrong", "correct the name"});
  try {
    return read_content(hdf5::File::open_read_only(file), header_only);
  } catch (const hdf5::Failure& failure) {
    throw InputError({file.string(), "this is no readable file of fields", failure.what(),
                      "give a file that stresslet wrote into the folder 'fields' of a run"});
  }
}

std::vector<FieldFile> field_headers(const std::filesystem::path& results, std::int64_t last_step) {
  std::vector<FieldFile> headers;
  if (!std::filesystem::is_directory(results / fields_folder)) return headers;
  for (const auto& entry : std::filesystem::directory_iterator(results / fields_folder)) {
    const auto step = step_in(entry.path().filename().string(), ".h5");
    if (step && *step <= last_step) headers.push_back(read_field_file(entry.path(), true));
  }
  std::sort(headers.begin(), headers.end(), [](const auto& a, const auto& b) { return a.step < b.step; });
  return headers;
}

std::string fields_xdmf_text(const std::vector<FieldFile>& headers) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"3.0\">\n <Domain>\n"
                 "  <Grid Name=\"fields\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
  for (const FieldFile& h : headers) {
    const std::string cells = fmt::format("{} {} {}", h.count[2], h.count[1], h.count[0]);
    fmt::format_to(out,
                   "   <Grid Name=\"fields\" GridType=\"Uniform\">\n    <Time Value=\"{}\"/>\n"
                   "    <Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{} {} {}\"/>\n"
                   "    <Geometry GeometryType=\"ORIGIN_DXDYDZ\">"
                   "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">{} {} {}</DataItem>"
                   "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">{} {} {}</DataItem>"
                   "</Geometry>\n",
                   h.time, h.count[2] + 1, h.count[1] + 1, h.count[0] + 1, h.origin[2], h.origin[1], h.origin[0],
                   h.spacing[2], h.spacing[1], h.spacing[0]);
    for (const Field& field : h.fields)
      fmt::format_to(out,
                     "    <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Cell\"><DataItem Dimensions=\"{}{}\" "
                     "NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">{}/{}:/{}</DataItem></Attribute>\n",
                     field.name, attribute_type(field.components), cells,
                     field.components > 1 ? fmt::format(" {}", field.components) : "", fields_folder,
                     field_file_name(h.step), field.name);
    fmt::format_to(out, "   </Grid>\n");
  }
  fmt::format_to(out, "  </Grid>\n </Domain>\n</Xdmf>\n");
  return fmt::to_string(text);
}

void remove_field_files(const std::filesystem::path& results, std::int64_t after_step) {
  const std::filesystem::path folder = results / fields_folder;
  if (!std::filesystem::is_directory(folder)) return;
  std::vector<std::filesystem::path> old;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const auto step = step_in(name, ".h5");
    if (step_in(name, ".h5.part") || (step && *step > after_step)) old.push_back(entry.path());
  }
  for (const auto& file : old) std::filesystem::remove(file);
}

}  // namespace stresslet
