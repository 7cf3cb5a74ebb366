#include "stresslet/io/xdmf.hpp"

#include <fmt/format.h>

#include <iterator>

#include "stresslet/io/results_layout.hpp"

namespace stresslet {
namespace {

std::string data_item(const std::string& dataset, const std::string& shape, bool integer) {
  return fmt::format(R"(<DataItem Dimensions="{}" NumberType="{}" Precision="{}" Format="HDF">{}</DataItem>)", shape,
                     integer ? "Int" : "Float", integer ? 4 : 8, dataset);
}

}  // namespace

std::string xdmf_text(std::span<const XdmfStep> steps, const std::string& results) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"3.0\">\n <Domain>\n"
                 "  <Grid Name=\"particles\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const std::size_t n = steps[k].particles;
    const std::string group = results + ":" + layout::snapshot_group(k) + "/";
    fmt::format_to(out,
                   "   <Grid Name=\"particles\" GridType=\"Uniform\">\n    <Time Value=\"{}\"/>\n"
                   "    <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\"/>\n"
                   "    <Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
                   steps[k].strain, n, data_item(group + "position", fmt::format("{} 3", n), false));
    for (const char* name : {"velocity", "angular_velocity"})
      fmt::format_to(out, "    <Attribute Name=\"{}\" AttributeType=\"Vector\" Center=\"Node\">{}</Attribute>\n", name,
                     data_item(group + name, fmt::format("{} 3", n), false));
    for (const char* name : {"radius", "species", "id"})
      fmt::format_to(out, "    <Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Node\">{}</Attribute>\n", name,
                     data_item(group + name, fmt::format("{}", n), name[0] != 'r'));
    fmt::format_to(out, "   </Grid>\n");
  }
  fmt::format_to(out, "  </Grid>\n </Domain>\n</Xdmf>\n");
  return fmt::to_string(text);
}

}  // namespace stresslet
