#pragma once
/// Stress of the suspension by origin, its dissipation and its energies at one instant.
///
/// Tension positive, per volume, in units of viscosity x shear rate: sigma = (1/V) sum_{i<j} sym[(x_j - x_i) F_i],
/// F_i the force on i from j (each pair once); stresslet 5 phi E; Reynolds -(1/V) sum m c c and acceleration
/// -(1/V) sum m a^2/5 (w w - w^2 I), with c the velocity relative to the mean flow. Drag forces act on single bodies
/// and carry no stress. The map to the signs of the literature stands in docs/theory.md.
///
/// Energy: sigma_xy gdot V = D + d/dt (E_elastic + K), D = lubrication + sliding + dashpot + drag, with sigma_xy of
/// contacts, lubrication and Reynolds stress. It holds for every law because D of a pair is defined as
/// F_1.u - T_1.w_1 - T_2.w_2 + Omega.(T_1 + T_2 - r x F_1). Stresslet and acceleration stress stand outside this
/// balance; the latter is 1e-6 of the viscosity at St = 0.1.
#include "stresslet/dem/contact/contact_forces.hpp"
#include "stresslet/dem/contact/wall_contacts.hpp"
#include "stresslet/lubrication/pair_lubrication.hpp"
#include "stresslet/lubrication/wall_films.hpp"
#include "stresslet/particles/active_pairs.hpp"

namespace stresslet {

using Stress = SymTensor3<double>;

struct StressParts {
  Stress contact, lubrication_normal, lubrication_tangential, lubrication_rotational, lubrication_strain, stresslet,
      reynolds, acceleration;

  /// Calls `visit(name, part)` for every part; the one list behind columns, totals and summaries.
  template <class Self, class Visit>
  static void for_each(Self&& self, Visit&& visit) {
    visit("contact", self.contact);
    visit("lubrication_normal", self.lubrication_normal);
    visit("lubrication_tangential", self.lubrication_tangential);
    visit("lubrication_rotational", self.lubrication_rotational);
    visit("lubrication_strain", self.lubrication_strain);
    visit("stresslet", self.stresslet);
    visit("reynolds", self.reynolds);
    visit("acceleration", self.acceleration);
  }

  Stress total() const {
    Stress sum{};
    for_each(*this, [&](const char*, const Stress& part) { sum += part; });
    return sum;
  }
};

/// Everything that is summed over pairs and particles; divided by the volume where it says so.
struct Sample {
  StressParts stress;  ///< per volume
  double dissipation_lubrication = 0, dissipation_sliding = 0, dissipation_dashpot = 0,
         dissipation_drag = 0;                    ///< per volume
  double elastic_energy = 0, kinetic_energy = 0;  ///< per volume; kinetic relative to the mean flow
  double contacts = 0;                            ///< number of overlapping pairs, wall contacts included
  double largest_overlap = 0;                     ///< over the smaller diameter of the pair
  Vec3<double> momentum{};                        ///< relative to the mean flow, all particles

  double dissipation() const {
    return dissipation_lubrication + dissipation_sliding + dissipation_dashpot + dissipation_drag;
  }
};

/// What of the model enters the stress.
struct StressModel {
  bool drag = false;
  bool stresslet = false;
  bool lubrication_sees_background = false;  ///< splits off the strain part
};

/// What a sample reads: the system at one instant, with velocities synchronous to the positions.
struct Instant {
  const Box& box;
  const ParticleState& state;
  const TwistVector& velocity;
  const ActivePairs& pairs;
  const ContactForces& contacts;
  const WallContacts& wall_contacts;
  const PairLubrication& lubrication;
  const WallFilms& walls;
};

Sample measure(ThreadTeam& team, const Instant& now, const StressModel& model);

}  // namespace stresslet
