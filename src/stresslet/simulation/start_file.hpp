#pragma once
/// Files that a case may name: start configurations (results of a run, extended XYZ or CSV) and tables of sizes.
#include "stresslet/particles/box.hpp"
#include "stresslet/particles/sizes/table.hpp"
#include "stresslet/particles/state.hpp"
#include "stresslet/simulation/case.hpp"

namespace stresslet {

struct StartConfiguration {
  ParticleState state;
  Box box;
};

/// Reads suspension.file: the last state in a run's results.h5; the last frame of an extended XYZ file (box from its
/// Lattice, or suspension.box); or a CSV file with columns x, y, z and radius or diameter, optionally ux, uy, uz, wx,
/// wy, wz, species, id (box from suspension.box). Throws InputError with the place in the file.
StartConfiguration read_start(const Case& settled, double density);

/// CSV with columns diameter and share.
Table::Params read_size_table(const InputPath& file, ShareKind shares);

}  // namespace stresslet
