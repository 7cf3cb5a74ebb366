#include "stresslet/io/xdmf.hpp"

#include <fmt/format.h>

#include <iterator>

#include "stresslet/io/results_layout.hpp"

namespace stresslet {
namespace {

constexpr const char* opening = R"(<?xml version="1.0" ?>
<Xdmf Version="3.0">
 <Domain>
  <Grid Name="particles" GridType="Collection" CollectionType="Temporal">
)";
constexpr const char* closing = R"(  </Grid>
 </Domain>
</Xdmf>
)";

std::string numbers(const std::string& dataset, const std::string& shape) {
  return fmt::format(R"(<DataItem Dimensions="{}" NumberType="Float" Precision="8" Format="HDF">{}</DataItem>)", shape,
                     dataset);
}

std::string integers(const std::string& dataset, const std::string& shape) {
  return fmt::format(R"(<DataItem Dimensions="{}" NumberType="Int" Precision="4" Format="HDF">{}</DataItem>)", shape,
                     dataset);
}

std::string attribute(const char* name, const char* type, const std::string& data) {
  return fmt::format("    <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n", name, type,
                     data);
}

}  // namespace

std::string xdmf_text(std::span<const XdmfStep> steps, const std::string& results) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}", opening);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const std::string group = results + ":" + layout::snapshot_group(k) + "/";
    const std::string scalar = fmt::format("{}", steps[k].particles), vector = scalar + " 3";
    fmt::format_to(
        out,
        "   <Grid Name=\"particles\" GridType=\"Uniform\">\n    <Time Value=\"{}\"/>\n"
        "    <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\">{}</Topology>\n"
        "    <Geometry GeometryType=\"XYZ\">{}</Geometry>\n{}{}{}{}{}   </Grid>\n",
        steps[k].strain, scalar, integers(group + "id", scalar), numbers(group + "position", vector),
        attribute("velocity", "Vector", numbers(group + "velocity", vector)),
        attribute("angular_velocity", "Vector", numbers(group + "angular_velocity", vector)),
        attribute("radius", "Scalar", numbers(group + "radius", scalar)),
        attribute("species", "Scalar", integers(group + "species", scalar)),
        attribute("id", "Scalar", integers(group + "id", scalar)));
  }
  fmt::format_to(out, "{}", closing);
  return fmt::to_string(text);
}

}  // namespace stresslet
