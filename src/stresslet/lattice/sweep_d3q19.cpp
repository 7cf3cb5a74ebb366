#include "stresslet/lattice/sweep_kernel.hpp"

namespace stresslet {

template Sweep<D3Q19, double> sweep_for<D3Q19, double>(std::string_view, std::string_view);

}  // namespace stresslet
