#pragma once
/// Run-time checks. Each throws NumericalFailure naming the quantity, the reason and the fix.
#include "stresslet/simulation/series.hpp"
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

/// Stress power against dissipation over the last 0.2 of strain: the detector of steps that are too long, which do not
/// blow up but lose contacts and dissipate far too much (docs/theory.md). `tolerance` is relative to the viscosity and
/// to the scatter of samples: at 0.1 three standard errors are allowed besides a tenth of the viscosity.
void check_energy_balance(const Series& series, double tolerance);

/// The same of the summed stress against the flux through the sheared plane, or against what walls feel, in a series
/// that has it (stress_closure.hpp): a part of the stress that is missing, counted twice or not in balance.
void check_stress_closure(const Series& series, double tolerance);

/// Position, velocity and angular velocity of every particle are finite.
void check_finite(const Suspension& s);

/// Resolved fluid, after `sample`: the density of every cell is finite and near 1.
void check_fluid(const Suspension& s);

/// Resolved fluid: no sphere is faster than the lattice bears.
void check_sphere_speeds(const Suspension& s);

/// The last velocity solve reached its tolerance.
void check_solver(const Suspension& s);

/// Explicit scheme: the step is stable for the present films (stability.hpp).
void check_explicit_step(double step_number, double step);

}  // namespace stresslet
