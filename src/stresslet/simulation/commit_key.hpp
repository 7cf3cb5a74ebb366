#pragma once
/// The key of [output] that cases of all fidelities share.
#include "stresslet/io/schema.hpp"

namespace stresslet {

template <class V>
void describe_commit_every(V& v, double& commit_every) {
  v.key(
      "commit_every", commit_every, defaulted, between(0, 86400), "s",
      "Wall time between two safe writes of results and checkpoint, longer where they take more than a fiftieth of the "
      "time: what a killed run loses at most");
}

}  // namespace stresslet
