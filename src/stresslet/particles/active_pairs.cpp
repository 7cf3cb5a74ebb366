#include "stresslet/particles/active_pairs.hpp"

#include <algorithm>

namespace stresslet {

void ActivePairs::prepare(const VerletList& list, std::size_t particles) {
  particles_ = particles;
  const std::size_t chunks = (list.size() + chunk - 1) / chunk;
  const std::size_t capacity = padded(list.size());
  for (auto* a : {&i, &j}) a->assign(capacity, 0);
  for (auto* a : {&ex, &ey, &ez, &distance, &gap, &images_up, &radius_i, &radius_j}) a->assign(capacity, 0.0);
  candidate.assign(list.size(), 0);
  slot_.assign(list.size(), -1);
  staged_.candidate.assign(chunks * chunk, 0);
  for (auto* a : {&staged_.x, &staged_.y, &staged_.z, &staged_.images_up}) a->assign(chunks * chunk, 0.0);
  staged_.count.assign(chunks, 0);
  staged_.begin.assign(chunks + 1, 0);

  first_.assign(particles + 1, 0);
  second_begin_.assign(particles + 1, 0);
  second_count_.assign(particles, 0);
  second_.assign(list.size(), 0);
  second_candidates_.assign(list.size(), 0);
  for (std::int32_t b : list.j) ++second_begin_[std::size_t(b) + 1];
  for (std::size_t b = 0; b < particles; ++b) second_begin_[b + 1] += second_begin_[b];
  std::vector<std::uint32_t> next(second_begin_.begin(), second_begin_.end() - 1);
  for (std::size_t c = 0; c < list.size(); ++c) second_candidates_[next[std::size_t(list.j[c])]++] = std::uint32_t(c);
}

void ActivePairs::update(Member& member, const VerletList& list, const ParticleState& state, const Box& box) {
  const std::size_t chunks = staged_.count.size();
  const Range mine = member.share(chunks);
  for (std::size_t c = mine.begin; c < mine.end; ++c) measure_chunk(c, list, state, box);
  member.barrier();
  if (member.rank() == 0) {
    for (std::size_t c = 0; c < chunks; ++c) staged_.begin[c + 1] = staged_.begin[c] + staged_.count[c];
    size_ = staged_.begin[chunks];
    pad();
  }
  member.barrier();
  for (std::size_t c = mine.begin; c < mine.end; ++c) collect_chunk(c, list, state);
  member.barrier();
  index_first(member.share(size_));
  if (size_ == 0 && member.rank() == 0) std::fill(first_.begin(), first_.end(), 0u);
  index_second(member.share(particles_));
  member.barrier();
}

void ActivePairs::measure_chunk(std::size_t c, const VerletList& list, const ParticleState& state, const Box& box) {
  const std::size_t begin = c * chunk, end = std::min(begin + chunk, list.size());
  std::uint32_t count = 0;
  const auto keep = [&](std::size_t k, double x, double y, double z, double images) {
    const std::size_t s = begin + count++;
    staged_.candidate[s] = std::int32_t(k);
    staged_.x[s] = x, staged_.y[s] = y, staged_.z[s] = z, staged_.images_up[s] = images;
  };
  const InteractionRange range = list.range();
  std::size_t k = begin;
  for (; k + pack_width <= end; k += pack_width) {
    const std::int32_t *a = &list.i[k], *b = &list.j[k];
    const auto difference = [&](const AlignedVector<double>& v) { return gather(v.data(), b) - gather(v.data(), a); };
    const auto s = box.nearest_image(Vec3<Pack>{difference(state.x), difference(state.y), difference(state.z)});
    const Pack a1 = gather(state.radius.data(), a), a2 = gather(state.radius.data(), b);
    const Pack sum = a1 + a2;
    const Pack reach = sum + range.outer_cutoff * 2.0 * a1 * a2 / sum;
    const auto active = dot(s.r, s.r) < reach * reach;
    for (std::size_t lane = 0; lane < pack_width; ++lane) {
      slot_[k + lane] = -1;
      if (active[lane]) keep(k + lane, s.r.x[lane], s.r.y[lane], s.r.z[lane], s.images_up[lane]);
    }
  }
  for (; k < end; ++k) {
    const std::size_t a = std::size_t(list.i[k]), b = std::size_t(list.j[k]);
    const auto s = box.nearest_image(state.position(b) - state.position(a));
    const double reach = state.radius[a] + state.radius[b] + range(state.radius[a], state.radius[b]);
    slot_[k] = -1;
    if (dot(s.r, s.r) < reach * reach) keep(k, s.r.x, s.r.y, s.r.z, s.images_up);
  }
  staged_.count[c] = count;
}

void ActivePairs::pad() {
  for (std::size_t p = size_; p < padded(size_); ++p) {
    i[p] = j[p] = 0;
    ex[p] = 1, ey[p] = ez[p] = images_up[p] = 0;
    radius_i[p] = radius_j[p] = 1;
    distance[p] = 1e3, gap[p] = 1e3;
  }
}

void ActivePairs::collect_chunk(std::size_t c, const VerletList& list, const ParticleState& state) {
  std::size_t p = staged_.begin[c];
  for (std::size_t s = c * chunk; s < c * chunk + staged_.count[c]; ++s, ++p) {
    const std::size_t k = std::size_t(staged_.candidate[s]);
    const Vec3<double> r{staged_.x[s], staged_.y[s], staged_.z[s]};
    const double length = norm(r);
    candidate[p] = staged_.candidate[s];
    slot_[k] = std::int32_t(p);
    i[p] = list.i[k], j[p] = list.j[k];
    radius_i[p] = state.radius[std::size_t(i[p])], radius_j[p] = state.radius[std::size_t(j[p])];
    ex[p] = r.x / length, ey[p] = r.y / length, ez[p] = r.z / length;
    distance[p] = length;
    gap[p] = length - radius_i[p] - radius_j[p];
    images_up[p] = staged_.images_up[s];
  }
}

void ActivePairs::index_first(Range pairs) {
  for (std::size_t p = pairs.begin; p < pairs.end; ++p) {
    const std::int32_t previous = p == 0 ? -1 : i[p - 1];
    for (std::int32_t a = previous + 1; a <= i[p]; ++a) first_[std::size_t(a)] = std::uint32_t(p);
    if (p + 1 == size_) std::fill(first_.begin() + i[p] + 1, first_.end(), std::uint32_t(size_));
  }
}

void ActivePairs::index_second(Range particles) {
  for (std::size_t b = particles.begin; b < particles.end; ++b) {
    std::uint32_t count = 0;
    for (std::uint32_t k = second_begin_[b]; k < second_begin_[b + 1]; ++k) {
      const std::int32_t p = slot_[second_candidates_[k]];
      if (p >= 0) second_[second_begin_[b] + count++] = std::uint32_t(p);
    }
    second_count_[b] = count;
  }
}

}  // namespace stresslet
