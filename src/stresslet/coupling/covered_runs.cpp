#include "stresslet/coupling/covered_runs.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/spans.hpp"
#include "stresslet/exec/first_lanes.hpp"

namespace stresslet {

namespace {

/// Block number along an axis, and coordinate within the block, of every cell of the domain.
std::vector<std::pair<int, int>> places_along(const Grid& grid, const std::vector<BlockBox>& boxes, int axis) {
  const int step = axis == 0 ? 1 : axis == 1 ? grid.blocks[0] : grid.blocks[0] * grid.blocks[1];
  std::vector<std::pair<int, int>> places;
  for (int k = 0; k < grid.blocks[std::size_t(axis)]; ++k) {
    const BlockBox& box = boxes[std::size_t(k * step)];
    for (int c = 0; c < box.size[std::size_t(axis)]; ++c) places.emplace_back(k * step, c);
  }
  return places;
}

}  // namespace

template <class T>
CoveredRuns<T>::CoveredRuns(const Grid& grid, const SolidLaws& laws)
    : grid_(grid), laws_(laws), boxes_(block_boxes(grid)), first_row_(1, 0) {
  if (*std::max_element(grid.size.begin(), grid.size.end()) > most_cells_along)
    throw std::invalid_argument("too many cells along an axis for spheres in the fluid");
  for (int axis = 0; axis < 3; ++axis) places_[std::size_t(axis)] = places_along(grid, boxes_, axis);
  for (const BlockBox& box : boxes_)
    first_row_.push_back(first_row_.back() + std::size_t(box.size[1]) * std::size_t(box.size[2]));
  SolidFractionLaws::dispatch(laws.fraction, [&](auto fraction) {
    using Fraction = typename decltype(fraction)::type;
    touch_radius_ = Fraction::touch_radius;
    full_radius_ = Fraction::full_radius;
    SolidWeights::dispatch(laws.weight, [&](auto weight) {
      using Weight = typename decltype(weight)::type;
      drawn_radius_ = Weight::drawn_radius;
      fill_ = &CoveredRuns::template fill<Fraction, Weight>;
    });
  });
}

template <class T>
bool CoveredRuns<T>::find_images(const std::vector<ResolvedSphere>& spheres, double offset, double velocity) {
  std::swap(images_, images_before_);
  images_.clear();
  first_image_.assign(1, 0);
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    ResolvedSphere drawn = spheres[k];
    drawn.radius = drawn_radius_(drawn.radius);
    append_images(grid_, drawn, std::int32_t(k), touch_radius_(drawn.radius), offset, velocity, images_);
    first_image_.push_back(images_.size());
  }
  return first_run_.empty() || images_ != images_before_;
}

template <class T>
void CoveredRuns<T>::find_runs(Found& found, const Range& images) {
  found.runs.clear();
  found.runs_in.assign(first_row_.back(), 0);
  found.packs_in.assign(first_row_.back(), 0);
  const int grain = grain_in_x(grid_.size[0]);
  const auto add_row = [&](std::size_t image, const RowSpan& row) {
    if (row.y < 0 || row.y >= grid_.size[1] || row.z < 0 || row.z >= grid_.size[2]) return;
    const auto [block_y, y] = places_[1][std::size_t(row.y)];
    const auto [block_z, z] = places_[2][std::size_t(row.z)];
    const int end = std::min(row.touched.end, grid_.size[0]);
    for (int x = std::max(row.touched.begin, 0); x < end;) {
      const auto [block_x, local_x] = places_[0][std::size_t(x)];
      const std::size_t block = std::size_t(block_x + block_y + block_z);
      const int next = std::min({(x / grain + 1) * grain, x - local_x + boxes_[block].size[0], end});
      const std::size_t in_row = first_row_[block] + std::size_t(y + boxes_[block].size[1] * z);
      const int cells = next - x, packs = (cells + width - 1) / width;
      const auto from_first = [&](int cell) { return std::uint8_t(std::clamp(cell - x, 0, cells)); };
      found.runs.push_back({.image = std::int32_t(image),
                            .slot = std::int32_t(found.runs.size()),
                            .row = std::uint32_t(in_row),
                            .first_pack = 0,
                            .global_x = std::int16_t(x),
                            .global_y = std::int16_t(row.y),
                            .global_z = std::int16_t(row.z),
                            .x = std::int16_t(local_x),
                            .cells = std::uint8_t(cells),
                            .packs = std::uint8_t(packs),
                            .full_begin = from_first(row.full.begin),
                            .full_end = from_first(row.full.end),
                            .filled = false});
      ++found.runs_in[in_row];
      found.packs_in[in_row] += std::uint32_t(packs);
      x = next;
    }
  };
  for (std::size_t k = images.begin; k < images.end; ++k) {
    const SphereImage& image = images_[k];
    for_each_row_of_sphere(image.centre, touch_radius_(image.radius), full_radius_(image.radius),
                           [&](const RowSpan& row) { add_row(k, row); });
    first_slot_[k + 1] = found.runs.size();
  }
}

/// From the numbers of runs and packs to the places where each member's begin; members one after the other in a row.
template <class T>
void CoveredRuns<T>::divide_rows(std::size_t members) {
  first_run_.resize(first_row_.back() + 1);
  std::uint32_t runs = 0, packs = 0;
  for (std::size_t row = 0; row < first_row_.back(); ++row) {
    first_run_[row] = runs;
    for (std::size_t m = 0; m < members; ++m) {
      runs += std::exchange(found_[m].runs_in[row], runs);
      packs += std::exchange(found_[m].packs_in[row], packs);
    }
  }
  first_run_.back() = runs;
  run_count_ = runs;
  make_room(runs_, runs);
  make_room(drag_, std::size_t(packs) * width);
  found_before_.assign(1, 0);
  for (std::size_t m = 0; m < members; ++m) found_before_.push_back(found_before_.back() + found_[m].runs.size());
}

/// Runs of a row stay in the order of their slots.
template <class T>
void CoveredRuns<T>::sort_into_rows(Found& found, const Range& images, std::size_t first_slot) {
  for (std::size_t k = images.begin; k < images.end; ++k) first_slot_[k + 1] += first_slot;
  constexpr std::size_t ahead = 16;  // the rows of a sphere lie far apart: asked for before use
  for (std::size_t k = 0; k < found.runs.size(); ++k) {
    if (k + ahead < found.runs.size()) __builtin_prefetch(runs_.data() + found.runs_in[found.runs[k + ahead].row], 1);
    CoveredRun run = found.runs[k];
    run.slot += std::int32_t(first_slot);
    run.first_pack = found.packs_in[run.row];
    found.packs_in[run.row] += run.packs;
    runs_.data()[found.runs_in[run.row]++] = run;
  }
}

template <class T>
void CoveredRuns<T>::place(Member& member, const std::vector<ResolvedSphere>& spheres, double shear_offset,
                           double shear_velocity) {
  const std::size_t rank = std::size_t(member.rank()), members = std::size_t(member.size());
  if (rank == 0) {
    moved_ = find_images(spheres, shear_offset, shear_velocity);
    if (moved_) {
      first_slot_.assign(images_.size() + 1, 0);
      found_.resize(members);
    }
  }
  member.barrier();
  if (!moved_) return member.barrier();
  const Range images = member.share(images_.size());
  find_runs(found_[rank], images);
  member.barrier();
  if (rank == 0) divide_rows(members);
  member.barrier();
  sort_into_rows(found_[rank], images, found_before_[rank]);
  member.barrier();
}

template <class T>
template <class Fraction, class Weight>
void CoveredRuns<T>::fill(const Range& runs) {
  const Fraction fraction{};
  const Weight weight(laws_.relaxation_time);
  using P = PackOf<T>;
  const P lanes([](auto k) { return T(k); });
  const P full = weight.drag(P(T(1)));
  const bool has_core = laws_.core_weight < weight.weight(1.0);
  const P core = has_core ? P(T(drag_from_weight(laws_.core_weight))) : full;
  for (std::size_t k = runs.begin; k < runs.end; ++k) {
    CoveredRun& run = runs_.data()[k];
    if (run.filled) continue;
    run.filled = true;
    const SphereImage& image = images_[std::size_t(run.image)];
    const Vec3<double> arm = run.arm(image.centre);
    const double core_radius = has_core ? std::max(image.radius - core_depth, 0.0) : 0;
    for (int p = 0; p < run.packs; ++p) {
      const int x = p * width;
      const Vec3<P> offset{P(T(arm.x + x)) + lanes, P(T(arm.y)), P(T(arm.z))};
      P value = full;
      if (x < run.full_begin || x + width > run.full_end)
        value = weight.drag(fraction.fraction(offset, P(T(image.radius))));
      if (core_radius > 0) stdx::where(dot(offset, offset) < P(T(core_radius * core_radius)), value) = core;
      if (x + width > run.cells) stdx::where(!first_lanes<P>(run.cells - x), value) = T(0);
      store(drag(run) + p * width, value);
    }
  }
}

template class CoveredRuns<double>;
template class CoveredRuns<float>;

}  // namespace stresslet
