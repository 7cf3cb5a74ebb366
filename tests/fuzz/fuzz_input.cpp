/// libFuzzer target for the input reader; see tests/input/read_any.hpp for what counts as a defect.
#include <cstddef>
#include <cstdint>

#include "../input/read_any.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  stresslet::read_any({reinterpret_cast<const char*>(data), size});
  return 0;
}
