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

template <class Visit>
void with_laws(const SolidLaws& laws, Visit&& visit) {
  SolidFractionLaws::dispatch(laws.fraction, [&](auto fraction) {
    SolidWeights::dispatch(laws.weight, [&](auto weight) {
      visit(typename decltype(fraction)::type{}, typename decltype(weight)::type(laws.relaxation_time));
    });
  });
}

}  // namespace

CoveredRuns::CoveredRuns(const Grid& grid) : grid_(grid), boxes_(block_boxes(grid)), buckets_(boxes_.size()) {
  for (int axis = 0; axis < 3; ++axis) places_[std::size_t(axis)] = places_along(grid, boxes_, axis);
}

void CoveredRuns::find_images(const SolidLaws& laws, const std::vector<ResolvedSphere>& spheres, double offset,
                              double velocity) {
  SolidFractionLaws::dispatch(laws.fraction, [&](auto law) {
    touch_radius_ = decltype(law)::type::touch_radius;
    full_radius_ = decltype(law)::type::full_radius;
  });
  images_.clear();
  first_image_.assign(1, 0);
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    append_images(grid_, spheres[k], std::int32_t(k), touch_radius_(spheres[k].radius), offset, velocity, images_);
    first_image_.push_back(images_.size());
  }
}

void CoveredRuns::find_runs() {
  runs_.clear();
  first_run_.assign(1, 0);
  std::size_t packs = 0;
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
                               CoveredRun run{std::int32_t(k), block,    y + boxes_[std::size_t(block)].size[1] * z,
                                              aligned,         0,        {x - (local_x - aligned), row.y, row.z},
                                              {x, next},       row.full, packs};
                               run.packs = (next - run.global[0] + width - 1) / width;
                               packs += std::size_t(run.packs);
                               runs_.push_back(run);
                               x = next;
                             }
                           });
    first_run_.push_back(runs_.size());
  }
  if (drag_.size() < packs * pack_width) drag_.resize(packs * pack_width * 5 / 4);
}

void CoveredRuns::sort_into_rows() {
  for (std::size_t b = 0; b < boxes_.size(); ++b)
    buckets_[b].first.assign(std::size_t(boxes_[b].size[1]) * std::size_t(boxes_[b].size[2]) + 1, 0);
  for (const CoveredRun& run : runs_) ++buckets_[std::size_t(run.block)].first[std::size_t(run.row) + 1];
  for (Buckets& bucket : buckets_) {
    for (std::size_t row = 1; row < bucket.first.size(); ++row) bucket.first[row] += bucket.first[row - 1];
    bucket.runs.resize(std::size_t(bucket.first.back()));
    bucket.next.assign(bucket.first.begin(), bucket.first.end());
  }
  for (std::size_t k = 0; k < runs_.size(); ++k) {
    Buckets& bucket = buckets_[std::size_t(runs_[k].block)];
    bucket.runs[std::size_t(bucket.next[std::size_t(runs_[k].row)]++)] = std::int32_t(k);
  }
}

void CoveredRuns::map(Member& member, const SolidLaws& laws, const std::vector<ResolvedSphere>& spheres,
                      double shear_offset, double shear_velocity) {
  if (member.rank() == 0) {
    find_images(laws, spheres, shear_offset, shear_velocity);
    find_runs();
    sort_into_rows();
  }
  member.barrier();
  with_laws(laws, [&](const auto& fraction, const auto& weight) {
    const Pack lanes([](auto k) { return double(k); });
    const Pack full = weight.drag(Pack(1.0));
    const Range mine = member.share(runs_.size());
    for (std::size_t k = mine.begin; k < mine.end; ++k) {
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
  });
  member.barrier();
}

}  // namespace stresslet
