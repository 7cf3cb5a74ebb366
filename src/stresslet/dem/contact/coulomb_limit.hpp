#pragma once

namespace stresslet {

/// Which normal force enters the Coulomb limit: the spring's alone (Cundall & Strack 1979), or spring plus dashpot
/// (Herrmann & Luding, Continuum Mech. Thermodyn. 10 (1998) 189). They agree without a dashpot.
enum class CoulombLimit { spring, spring_and_dashpot };

}  // namespace stresslet
