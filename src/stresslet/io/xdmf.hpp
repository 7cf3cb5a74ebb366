#pragma once
/// The snapshots of results.h5 for ParaView: an XDMF 3 file with one time step per snapshot, time being the strain.
/// It holds no numbers of its own but points to the datasets. The list of vertices is the dataset `id`, which counts
/// 0 ... N-1: readers of XDMF 3 show no vertices without a list.
#include <cstddef>
#include <span>
#include <string>

namespace stresslet {

/// What XDMF says about one snapshot.
struct XdmfStep {
  double strain;
  std::size_t particles;
};

/// The XDMF text; `results` is the name of the HDF5 file in the same folder, step k its /snapshots/<k>.
std::string xdmf_text(std::span<const XdmfStep> steps, const std::string& results);

}  // namespace stresslet
