#pragma once
/// The summed stress against the flux of momentum through the sheared plane, or what walls feel (theory: stress).
#include <vector>

#include "stresslet/simulation/series.hpp"

namespace stresslet {

/// By how much the summed stress and the growth of stored momentum exceed the flux, in each row from `first_row` on,
/// the very first row excepted; in viscosities. Of a series with "relative_viscosity_through_plane".
std::vector<double> closure_differences(const Series& series, std::size_t first_row);

}  // namespace stresslet
