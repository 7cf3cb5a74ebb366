#pragma once
/// Mean of a correlated, evenly sampled, stationary series, with an honest error.
///
/// The error is the larger of two independent estimates, each one standard error (a 68 % interval):
/// - autocorrelation: var(mean) = (1/n^2) sum_ij C(i - j), summed up to the window W that first exceeds five integrated
///   correlation times (Sokal 1997, in: Functional Integration, section 3). C measured about the sample mean is too
///   small by var(mean) (Wolff, Comput. Phys. Commun. 156 (2004) 143, eq. 49); the sum is solved for var(mean) with
///   that included, which matters when the series is only some tens of correlation times long.
/// - blocking: variance of the means of blocks (Flyvbjerg & Petersen, J. Chem. Phys. 91 (1989) 461), block length
///   doubled until length^3 > 2 n g^2 with g the variance growth reached (Lee et al., Phys. Rev. E 83 (2011) 066706).
/// Both are multiplied by Student's factor for the few independent numbers they rest on.
///
/// Measured on autoregressive processes, (mean - truth) / error has a root mean square of 1.05-1.1 for series of 20 of
/// Sokal's correlation times (ten independent samples), 0.93-1.05 from 100 on; 1.2 at 10 and 1.7 at 5. `reliable` marks
/// the first kinds, not sharply, because so short a series hides its own correlation: it is given to 99 % of the series
/// of 100 correlation times, 57 % of 20, 24 % of 10 and 11 % of 5.
#include <cstddef>
#include <span>

namespace stresslet {

struct Estimate {
  double mean = 0;
  double error = 0;                ///< one standard error of the mean
  std::size_t samples = 0;         ///< length of the series
  double correlation_samples = 1;  ///< samples that carry one independent one, 1 + 2 sum rho: twice Sokal's time
  bool reliable = false;           ///< at least ten independent samples
};

/// Never NaN for finite input: an empty series is 0 +- 0, one sample has an error of its own size, and up to seven
/// samples have their standard deviation, as if fully correlated; all of these are unreliable.
Estimate estimate_mean(std::span<const double> series);

/// Standard error of the mean before and after Student's factor.
struct MeanError {
  double raw = 0;
  double degrees_of_freedom = 1;
  double error() const;
};

/// The two estimates behind `estimate_mean`; at least four samples.
MeanError autocorrelation_error(std::span<const double> series);
MeanError blocking_error(std::span<const double> series);

/// Half-width of the central 68.27 % of Student's distribution, in standard deviations of a normal one:
/// Abramowitz & Stegun 26.7.5, within 1.4 % for one degree of freedom and 0.1 % from two.
double student_factor(double degrees_of_freedom);

}  // namespace stresslet
