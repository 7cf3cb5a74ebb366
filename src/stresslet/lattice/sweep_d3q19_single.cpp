#include "stresslet/lattice/sweep_kernel.hpp"

namespace stresslet {

template Sweep<D3Q19, float> sweep_for<D3Q19, float>(std::string_view, std::string_view);

}  // namespace stresslet
