#pragma once
/// Velocities from forces: conjugate gradients on the symmetric positive system
///   (D + R) V = b,
/// D = each particle's own resistance (mass/step, Stokes drag, moments likewise), R = lubrication of pairs and walls in
/// Rayleigh form and the hold of a resolved fluid, applied without being stored. Preconditioned by the inverse 3x3
/// diagonal blocks of translation and rotation (Saad, Iterative Methods for Sparse Linear Systems, alg. 9.1).
///
/// All threads run the iteration together; scalar products are summed in chunks of fixed length, so the result does not
/// depend on their number. An iteration meets at four barriers, five in a resolved fluid; its memory traffic is the
/// pair kernel's, its wrenches read again (128 B and 4 B of index per pair), the same of the fluid's frictions, and 15
/// x 64 B per particle: thirteen twists, 120 B of blocks and resistances.
#include "stresslet/exec/chunk_sum.hpp"
#include "stresslet/lubrication/fluid_coupling.hpp"
#include "stresslet/lubrication/pair_lubrication.hpp"
#include "stresslet/lubrication/wall_films.hpp"

namespace stresslet {

struct SolverReport {
  int iterations = 0;
  double residual = 0;  ///< sqrt(sum |F|^2 + |T|^2/a^2) of what is left of the right-hand side
  bool converged = true;
};

class ResistanceSolver {
 public:
  void prepare(const ParticleState& state);

  /// Own resistance of a particle: force per velocity and torque per angular velocity.
  void set_own_resistance(std::size_t i, double linear, double angular) {
    own_linear_[i] = linear, own_angular_[i] = angular;
  }

  /// Diagonal blocks for the present coefficients and own resistances. All threads.
  void factorise(Member& member, const ActivePairs& pairs, PairLubrication& lubrication, const WallFilms& walls,
                 const FluidCoupling& fluid);

  /// Improves `velocity` until the residual is at most `tolerance`. On entry `residual` = b - (D + R) velocity, on exit
  /// what is left of it. All threads; the same report on all; ends with a barrier.
  SolverReport solve(Member& member, const ActivePairs& pairs, PairLubrication& lubrication, const WallFilms& walls,
                     FluidCoupling& fluid, double tolerance, int largest_iteration, TwistVector& velocity,
                     TwistVector& residual);

 private:
  struct Products {
    double preconditioned = 0;  ///< r . z
    double plain = 0;           ///< |F|^2 + |T|^2/a^2
    Products& operator+=(const Products& b) {
      preconditioned += b.preconditioned, plain += b.plain;
      return *this;
    }
  };

  /// velocity += length direction, residual -= length image, and the preconditioned residual of particles
  /// [begin, end); returns their part of the scalar products.
  Products advance(std::size_t begin, std::size_t end, double length, TwistVector& velocity, TwistVector& residual);
  double apply_and_project(std::size_t begin, std::size_t end, const ActivePairs& pairs,
                           const PairLubrication& lubrication, const WallFilms& walls, const FluidCoupling& fluid);
  void remove_mean_residual(Member& member, const FluidCoupling& fluid, TwistVector& velocity,
                            const TwistVector& residual);

  std::vector<double> own_linear_, own_angular_, inverse_radius_squared_;
  std::vector<SymTensor3<double>> inverse_linear_, inverse_angular_;
  TwistVector direction_, image_, preconditioned_;
  ChunkSum<double> direction_sum_;
  ChunkSum<Products> residual_sum_;
  ChunkSum<Vec3<double>> force_sum_;
  ChunkSum<double> resistance_sum_;
};

}  // namespace stresslet
