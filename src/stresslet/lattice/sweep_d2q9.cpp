#include "stresslet/lattice/sweep_kernel.hpp"

namespace stresslet {

template Sweep<D2Q9, double> sweep_for<D2Q9, double>(std::string_view, std::string_view);

}  // namespace stresslet
