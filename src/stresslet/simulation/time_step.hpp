#pragma once
/// Time steps that a model allows, before the run: from the stiffest contact and the thinnest film of any pair of
/// sizes.
///
///   contact      pi sqrt(m_eff/k)      half period of an undamped collision
///   film         m_eff/X_cap           relaxation of the relative velocity in the thinnest film
///   relaxation   X_cap/k               relaxation of an overlap against the film, if it is overdamped
///   sliding      sqrt(2/7 m_eff/kt)    inverse frequency of the tangential spring (friction only)
/// explicit:       chosen min(contact/50, 0.45 film), refused above min(contact/20, 0.5 film)
/// semi-implicit:  chosen min(0.02 relaxation or contact/50, 0.6 sliding), refused above ten times 0.02 relaxation or
///                 2.5 times contact/50, and above 1.6 sliding
/// inertialess:    as semi-implicit; with friction the tangential spring relaxes against the film alone, Y_cap/kt, of
///                 which 0.3 is chosen and 1 the limit
/// Reasons and measurements: docs/theory.md, "Time step".
#include <span>
#include <string>

#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

struct StepBounds {
  double chosen = 0;                                          ///< the default step
  double largest = 0;                                         ///< steps above are refused
  std::string binding;                                        ///< what limits the step, in words
  double contact = 0, film = 0, relaxation = 0, sliding = 0;  ///< of the governing pair; 0 where it does not apply
};

/// For spheres of the given radii and density. Contact stiffness of Hertzian contacts is taken at an overlap of 0.5 %
/// of the smaller diameter.
StepBounds step_bounds(const Physics& physics, const std::string& scheme, std::span<const double> radii,
                       double density);

}  // namespace stresslet
