#pragma once
/// A sheared suspension and everything a time step needs: plain data, passed explicitly. `step.hpp` advances it.
#include <memory>
#include <string>

#include "stresslet/dem/contact/contact_forces.hpp"
#include "stresslet/dem/contact/wall_contacts.hpp"
#include "stresslet/lubrication/pair_lubrication.hpp"
#include "stresslet/lubrication/resistance_solver.hpp"
#include "stresslet/lubrication/wall_films.hpp"
#include "stresslet/particles/active_pairs.hpp"
#include "stresslet/particles/box.hpp"
#include "stresslet/particles/state.hpp"
#include "stresslet/particles/twist.hpp"
#include "stresslet/particles/verlet_list.hpp"

namespace stresslet {

/// The model: which forces act. Units: length d1, time 1/shear rate, viscosity 1.
struct Physics {
  ContactParameters contact;
  std::string lubrication_law = "complete";
  LubricationCutoffs cutoffs;
  bool drag = true;       ///< Stokes drag and torque in the mean flow
  bool stresslet = true;  ///< single-sphere stresslet in the stress
};

class ResolvedFlow;

struct TimeControl {
  std::string scheme = "semi-implicit";
  double step = 0;
  int substeps = 1;                ///< of the particles in a step of the resolved fluid
  double solver_tolerance = 1e-3;  ///< per particle, in units of 6 pi viscosity gdot a^2
  int largest_iteration = 1000;

  double substep() const { return step / substeps; }
};

/// Wall-clock seconds of this process by what they went into.
struct TimeSpent {
  double particles = 0;  ///< neighbours, contacts, films, velocities
  double coupling = 0;   ///< mapping spheres to cells and measuring the fluid there
  double lattice = 0;    ///< collisions and streaming, with the solid
  double analysis = 0;   ///< stress, dissipation, profiles
  double output = 0;     ///< results and checkpoint

  double sum() const { return particles + coupling + lattice + analysis + output; }
};

struct Suspension {
  Physics physics;
  TimeControl time;
  Box box;
  ParticleState state;

  double strain = 0;  ///< time x shear rate of the units, also where the box is not sheared
  std::int64_t steps = 0;

  VerletList list;
  AlignedVector<double> displacement_x, displacement_y, displacement_z;  ///< against the mean flow, since the build
  double strain_since_build = 0;
  std::int64_t builds = 0;

  ActivePairs pairs;
  ContactHistory history;  ///< per pair of the Verlet list
  ContactForces contacts;
  WallContacts wall_contacts;
  PairLubrication lubrication;
  WallFilms walls;
  std::shared_ptr<ResolvedFlow> resolved;  ///< none unless the fluid is resolved
  FluidCoupling fluid_coupling;            ///< of the resolved fluid, empty without
  ResistanceSolver solver;
  SolverReport solver_report;

  TwistVector velocity;      ///< twists that the present forces were evaluated with
  TwistVector velocity_now;  ///< twists synchronous to the positions, as far as known before the forces
  TwistVector change;        ///< of the velocities over the last step: the solver's first guess
  TwistVector residual;

  TimeSpent spent;
};

}  // namespace stresslet
