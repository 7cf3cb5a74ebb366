#include "stresslet/coupling/covered_runs.hpp"

#include <algorithm>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/spans.hpp"

namespace stresslet {

namespace {

constexpr int width = int(pack_width);
static_assert(run_length % pack_width == 0);

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

CoveredRuns::CoveredRuns(const Grid& grid, const SolidLaws& laws)
    : grid_(grid), laws_(laws), boxes_(block_boxes(grid)), first_row_(1, 0) {
  for (int axis = 0; axis < 3; ++axis) places_[std::size_t(axis)] = places_along(grid, boxes_, axis);
  for (const BlockBox& box : boxes_)
    first_row_.push_back(first_row_.back() + std::size_t(box.size[1]) * std::size_t(box.size[2]));
  SolidFractionLaws::dispatch(laws.fraction, [&](auto fraction) {
    using Fraction = typename decltype(fraction)::type;
    touch_radius_ = Fraction::touch_radius;
    full_radius_ = Fraction::full_radius;
    SolidWeights::dispatch(laws.weight,
                           [&](auto weight) { fill_ = &CoveredRuns::fill<Fraction, typename decltype(weight)::type>; });
  });
}

void CoveredRuns::find_images(const std::vector<ResolvedSphere>& spheres, double offset, double velocity) {
  images_.clear();
  first_image_.assign(1, 0);
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    append_images(grid_, spheres[k], std::int32_t(k), touch_radius_(spheres[k].radius), offset, velocity, images_);
    first_image_.push_back(images_.size());
  }
}

void CoveredRuns::find_runs() {
  found_.clear();
  first_slot_.assign(1, 0);
  for (std::size_t k = 0; k < images_.size(); ++k) {
    const SphereImage& image = images_[k];
    for_each_row_of_sphere(image.centre, touch_radius_(image.radius), full_radius_(image.radius),
                           [&](const RowSpan& row) {
                             if (row.y < 0 || row.y >= grid_.size[1] || row.z < 0 || row.z >= grid_.size[2]) return;
                             const auto [block_y, y] = places_[1][std::size_t(row.y)];
                             const auto [block_z, z] = places_[2][std::size_t(row.z)];
                             const int end = std::min(row.touched.end, grid_.size[0]);
                             for (int x = std::max(row.touched.begin, 0); x < end;) {
                               const int next = std::min((x / run_length + 1) * run_length, end);
                               const auto [block_x, local_x] = places_[0][std::size_t(x)];
                               const int block = block_x + block_y + block_z, aligned = local_x / width * width;
                               const Cells global{x - (local_x - aligned), row.y, row.z};
                               found_.push_back({.image = std::int32_t(k),
                                                 .slot = std::int32_t(found_.size()),
                                                 .block = block,
                                                 .x = aligned,
                                                 .y = y,
                                                 .z = z,
                                                 .packs = (next - global[0] + width - 1) / width,
                                                 .global = global,
                                                 .cells = {x, next},
                                                 .full = row.full,
                                                 .first_pack = 0});
                               x = next;
                             }
                           });
    first_slot_.push_back(found_.size());
  }
}

/// Counting sort; runs of a row stay in the order of their slots.
void CoveredRuns::sort_into_rows() {
  first_run_.assign(first_row_.back() + 1, 0);
  const auto row_of = [&](const CoveredRun& run) {
    const std::size_t block = std::size_t(run.block);
    return first_row_[block] + std::size_t(run.y + boxes_[block].size[1] * run.z);
  };
  for (const CoveredRun& run : found_) ++first_run_[row_of(run) + 1];
  for (std::size_t row = 1; row < first_run_.size(); ++row) first_run_[row] += first_run_[row - 1];
  next_ = first_run_;
  runs_.resize(found_.size());
  for (const CoveredRun& run : found_) runs_[next_[row_of(run)]++] = run;
  std::uint32_t packs = 0;
  for (CoveredRun& run : runs_) {
    run.first_pack = packs;
    packs += std::uint32_t(run.packs);
  }
  if (drag_.size() < packs * pack_width) drag_.resize(packs * pack_width * 5 / 4);
}

void CoveredRuns::place(Member& member, const std::vector<ResolvedSphere>& spheres, double shear_offset,
                        double shear_velocity) {
  if (member.rank() == 0) {
    find_images(spheres, shear_offset, shear_velocity);
    find_runs();
    sort_into_rows();
  }
  member.barrier();
}

template <class Fraction, class Weight>
void CoveredRuns::fill(const Range& runs) {
  const Fraction fraction{};
  const Weight weight(laws_.relaxation_time);
  const Pack lanes([](auto k) { return double(k); });
  const Pack full = weight.drag(Pack(1.0));
  for (std::size_t k = runs.begin; k < runs.end; ++k) {
    const CoveredRun& run = runs_[k];
    const SphereImage& image = images_[std::size_t(run.image)];
    for (int p = 0; p < run.packs; ++p) {
      const int x = run.global[0] + p * width;
      Pack value = full;
      if (x < run.full.begin || x + width > run.full.end) {
        const Vec3<Pack> offset{Pack(x - image.centre.x) + lanes, Pack(run.global[1] - image.centre.y),
                                Pack(run.global[2] - image.centre.z)};
        value = weight.drag(fraction.fraction(offset, Pack(image.radius)));
      }
      // A pack may reach into the next run, or beyond the domain.
      if (x < run.cells.begin || x + width > run.cells.end) {
        const Pack place = Pack(double(x)) + lanes;
        stdx::where(place < double(run.cells.begin) || place >= double(run.cells.end), value) = 0.0;
      }
      store(drag(run) + p * width, value);
    }
  }
}

}  // namespace stresslet
