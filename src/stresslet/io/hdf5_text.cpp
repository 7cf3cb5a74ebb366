/// Text datasets and attributes of hdf5::File.
#include "stresslet/io/hdf5_handle.hpp"

namespace stresslet::hdf5 {
namespace {

Handle utf8_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a text type");
  check(H5Tset_size(type, size), "make a text type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "make a text type");
  return type;
}

Handle open_attribute(hid_t file, const std::string& path, const std::string& name) {
  return {H5Aopen_by_name(file, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
          "open attribute " + name + " of " + path};
}

void write_attribute(const File& file, hid_t id, const std::string& path, const std::string& name, hid_t type,
                     hid_t space, const void* value) {
  const std::string attempt = "write attribute " + name + " of " + path;
  if (file.has_attribute(path, name)) check(H5Adelete_by_name(id, path.c_str(), name.c_str(), H5P_DEFAULT), attempt);
  const Handle attribute(
      H5Acreate_by_name(id, path.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      attempt);
  check(H5Awrite(attribute, type, value), attempt);
}

Handle scalar() { return {H5Screate(H5S_SCALAR), H5Sclose, "make a shape"}; }

}  // namespace

void File::write_text(const std::string& path, const std::string& text) {
  const Silence silence;
  if (contains(path)) remove(path);
  const std::string padded = text.empty() ? std::string(1, '\0') : text;
  const Handle type = utf8_type(padded.size());
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
  check(H5Pset_obj_track_times(properties, false), "set a property");
  const Handle dataset(H5Dcreate2(id_, path.c_str(), type, scalar(), make_groups(), properties, H5P_DEFAULT), H5Dclose,
                       "create dataset " + path);
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), "write " + path);
}

std::string File::read_text(const std::string& path) const {
  const Silence silence;
  const Handle dataset = open_dataset(id_, path);
  const Handle type(H5Dget_type(dataset), H5Tclose, "read the type of " + path);
  if (kind_of(type) != Kind::text || H5Tis_variable_str(type) > 0) throw Failure(path + " is not fixed-length text");
  std::string text(H5Tget_size(type), '\0');
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "read " + path);
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

bool File::has_attribute(const std::string& path, const std::string& name) const {
  const Silence silence;
  return check(H5Aexists_by_name(id_, path.c_str(), name.c_str(), H5P_DEFAULT), "look for attribute " + name) > 0;
}

std::vector<std::string> File::attribute_names(const std::string& path) const {
  const Silence silence;
  const Handle object(H5Oopen(id_, path.c_str(), H5P_DEFAULT), H5Oclose, "open " + path);
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  check(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), "list attributes of " + path);
  return names;
}

Kind File::attribute_kind(const std::string& path, const std::string& name) const {
  const Silence silence;
  const Handle attribute = open_attribute(id_, path, name);
  return kind_of(Handle(H5Aget_type(attribute), H5Tclose, "read the type of attribute " + name));
}

template <Element T>
void File::set_attribute(const std::string& path, const std::string& name, T value) {
  const Silence silence;
  write_attribute(*this, id_, path, name, native_type<T>(), scalar(), &value);
}

template <Element T>
void File::set_attribute(const std::string& path, const std::string& name, std::span<const T> values) {
  const Silence silence;
  const hsize_t count = values.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "make a shape");
  write_attribute(*this, id_, path, name, native_type<T>(), space, values.data());
}

void File::set_attribute(const std::string& path, const std::string& name, const std::string& text) {
  const Silence silence;
  const char* pointer = text.c_str();
  write_attribute(*this, id_, path, name, utf8_type(H5T_VARIABLE), scalar(), &pointer);
}

void File::remove_attribute(const std::string& path, const std::string& name) {
  const Silence silence;
  check(H5Adelete_by_name(id_, path.c_str(), name.c_str(), H5P_DEFAULT), "remove attribute " + name + " of " + path);
}

template <Element T>
std::vector<T> File::attribute_array(const std::string& path, const std::string& name) const {
  const Silence silence;
  const Handle attribute = open_attribute(id_, path, name);
  std::vector<T> values(
      element_count(shape_of(Handle(H5Aget_space(attribute), H5Sclose, "read the shape of attribute " + name))));
  check(H5Aread(attribute, native_type<T>(), values.data()), "read attribute " + name + " of " + path);
  return values;
}

template <Element T>
T File::attribute(const std::string& path, const std::string& name) const {
  const std::vector<T> values = attribute_array<T>(path, name);
  if (values.size() != 1) throw Failure("attribute " + name + " of " + path + " is not a single number");
  return values[0];
}

std::string File::text_attribute(const std::string& path, const std::string& name) const {
  const Silence silence;
  const Handle attribute = open_attribute(id_, path, name);
  const Handle stored(H5Aget_type(attribute), H5Tclose, "read the type of attribute " + name);
  if (kind_of(stored) != Kind::text || H5Tis_variable_str(stored) <= 0)
    throw Failure("attribute " + name + " of " + path + " is not variable-length text");
  char* pointer = nullptr;
  check(H5Aread(attribute, utf8_type(H5T_VARIABLE), &pointer), "read attribute " + name + " of " + path);
  const std::string text = pointer ? pointer : "";
  H5free_memory(pointer);
  return text;
}

template void File::set_attribute<double>(const std::string&, const std::string&, double);
template void File::set_attribute<std::int32_t>(const std::string&, const std::string&, std::int32_t);
template void File::set_attribute<std::int64_t>(const std::string&, const std::string&, std::int64_t);
template void File::set_attribute<double>(const std::string&, const std::string&, std::span<const double>);
template void File::set_attribute<std::int64_t>(const std::string&, const std::string&, std::span<const std::int64_t>);
template double File::attribute<double>(const std::string&, const std::string&) const;
template std::int32_t File::attribute<std::int32_t>(const std::string&, const std::string&) const;
template std::int64_t File::attribute<std::int64_t>(const std::string&, const std::string&) const;
template std::vector<double> File::attribute_array<double>(const std::string&, const std::string&) const;
template std::vector<std::int64_t> File::attribute_array<std::int64_t>(const std::string&, const std::string&) const;

}  // namespace stresslet::hdf5
