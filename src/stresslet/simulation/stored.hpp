#pragma once
/// Reading what a checkpoint holds by name.
#include <string>
#include <variant>

#include "stresslet/base/error.hpp"

namespace stresslet {

/// The entry `name` of the arrays or scalars of a checkpoint. Throws InputError where there is none of this type.
template <class Value, class Map>
const Value& stored(const Map& map, const std::string& name) {
  const auto found = map.find(name);
  if (found == map.end() || !std::holds_alternative<Value>(found->second))
    throw InputError({"", "the checkpoint holds no " + name, "it was damaged, or written by another version",
                      "start the run anew, or restart with the version that wrote the result"});
  return std::get<Value>(found->second);
}

}  // namespace stresslet
