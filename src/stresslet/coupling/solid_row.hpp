#pragma once
/// What the spheres do in one row of cells.
#include <array>

#include "stresslet/coupling/covered_runs.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/exec/aligned.hpp"

namespace stresslet {

/// Calls `visit(p, drag, velocity)` for every pack of a run, p cells from its first: solid drags and solid velocity.
template <class T, class Visit>
[[gnu::always_inline]] inline void for_each_pack(const CoveredRun& run, const T* drags, const SphereImage& image,
                                                 const ResolvedSphere& sphere, Visit&& visit) {
  using P = PackOf<T>;
  constexpr int width = CoveredRuns<T>::width;
  const P lanes([](auto k) { return T(k); });
  // Along the row w x r changes with x alone: by (0, w_z, -w_y) a cell.
  const Vec3<double>& w = sphere.angular_velocity;
  const Vec3<double> first = rigid_velocity(sphere.velocity, w, run.arm(image.centre));
  const P velocity_x(T(first.x + image.velocity_jump));
  for (int p = 0; p < run.packs * width; p += width) {
    const P along = lanes + P(T(p));
    visit(p, load(drags + p),
          Vec3<P>{velocity_x, P(T(first.y)) + P(T(w.z)) * along, P(T(first.z)) - P(T(w.y)) * along});
  }
}

/// The solid along one row, zero where there is none: sums over the images of alpha and of alpha us (shared_cells.hpp).
template <class T>
class SolidRow {
 public:
  using P = PackOf<T>;
  static constexpr int width = CoveredRuns<T>::width;

  explicit SolidRow(int nx) {
    for (auto& sum : sums_) sum.assign(std::size_t(nx + width), T(0));
  }

  void add(const CoveredRun& run, const T* drags, const SphereImage& image, const ResolvedSphere& sphere) {
    for_each_pack(
        run, drags, image, sphere, [&](int p, const P& drag, const Vec3<P>& velocity) __attribute__((always_inline)) {
          const std::size_t x = std::size_t(run.x + p);
          add_to(0, x, drag);
          add_to(1, x, drag * velocity.x);
          add_to(2, x, drag * velocity.y);
          add_to(3, x, drag * velocity.z);
        });
  }
  void clear(const CoveredRun& run) {
    for (int p = 0; p < run.packs * width; p += width)
      for (auto& sum : sums_) store_unaligned(&sum[std::size_t(run.x + p)], P(T(0)));
  }
  [[gnu::always_inline]] bool is_covered(int x) const { return stdx::any_of(drag(x) > P(T(0))); }
  [[gnu::always_inline]] P drag(int x) const { return load(&sums_[0][std::size_t(x)]); }
  [[gnu::always_inline]] CoveredCell<P> cell(int x) const {
    const auto at = [&](std::size_t k) { return load(&sums_[k][std::size_t(x)]); };
    return covered_cell(SharedDrag<P>{at(0), {at(1), at(2), at(3)}});
  }

 private:
  [[gnu::always_inline]] void add_to(std::size_t k, std::size_t x, const P& value) {
    store_unaligned(&sums_[k][x], load_unaligned(&sums_[k][x]) + value);
  }
  std::array<AlignedVector<T>, 4> sums_;
};

}  // namespace stresslet
