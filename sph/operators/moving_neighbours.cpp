#include "sph/operators/moving_neighbours.hpp"

#include <algorithm>
#include <limits>

namespace femsph::sph {

MovingNeighbours::MovingNeighbours(std::span<const Point> start, const Layout& layout, double radius,
                                   double skin)
    : start_(start), layout_(layout), radius_(radius), skin_(skin) {}

Trouble heap_trouble(const Point& position) {
  return {"particles have fallen on one heap, more than six times as dense as they began",
          "the motion has lost its meaning before: try a smaller --safety", position};
}

std::size_t MovingNeighbours::bytes() const {
  std::size_t sum = searched_.size() * sizeof(double) + position_.size() * sizeof(Point) + cells_.bytes() +
                    (near_.size() + near_at_start_.size()) * sizeof(std::uint16_t);
  for (const Chunk& c : chunks_)
    sum += c.index.size() * sizeof(std::int32_t) + c.begin.size() * sizeof(std::uint32_t);
  return sum;
}

/// Two particles have come nearer by at most |m_i - t| + |m_j - t|, where m are their displacements since the
/// search and t is any vector: here the centre of the box that holds all m. Half of the box's diagonal bounds
/// |m - t|. Only if this bound is too large, |m - t| of each particle is computed.
bool can_have_approached(const double* u, const double* before, const Layout& layout, double skin) {
  const std::size_t n = layout.points, chunk = 4096;
  const auto worst_of = [&](auto&& part) {  // a maximum does not depend on the order, nor on the threads
    std::vector<std::array<double, 6>> most((n + chunk - 1) / chunk);
    parallel_for(n, chunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; b += chunk) most[b / chunk] = part(b, std::min(b + chunk, end));
    });
    std::array<double, 6> all = most[0];
    for (const auto& m : most)
      for (std::size_t k = 0; k < 6; ++k) all[k] = std::max(all[k], m[k]);
    return all;
  };
  const auto moved = [&](std::size_t i, int c) { return u[layout.at(i, c)] - before[layout.at(i, c)]; };
  const std::array<double, 6> box = worst_of([&](std::size_t begin, std::size_t end) {
    std::array<double, 6> most;
    most.fill(-std::numeric_limits<double>::infinity());
    for (int c = 0; c < layout.dim; ++c) {
      double upper = most[0], lower = most[0];  // of m and of -m
      for (std::size_t i = begin; i < end; ++i) {
        const double m = moved(i, c);
        upper = m > upper ? m : upper;
        lower = -m > lower ? -m : lower;
      }
      most[std::size_t(c)] = upper, most[std::size_t(c) + 3] = lower;
    }
    return most;
  });
  double diagonal = 0, middle[3] = {};
  for (int c = 0; c < layout.dim; ++c) {
    diagonal += (box[std::size_t(c)] + box[std::size_t(c) + 3]) *
                (box[std::size_t(c)] + box[std::size_t(c) + 3]);
    middle[c] = 0.5 * (box[std::size_t(c)] - box[std::size_t(c) + 3]);
  }
  if (!(diagonal > skin * skin)) return false;
  const double farthest = worst_of([&](std::size_t begin, std::size_t end) {
    double most = 0;
    for (std::size_t i = begin; i < end; ++i) {
      double r2 = 0;
      for (int c = 0; c < layout.dim; ++c) r2 += (moved(i, c) - middle[c]) * (moved(i, c) - middle[c]);
      most = r2 > most ? r2 : most;
    }
    return std::array<double, 6>{most};
  })[0];
  return farthest > 0.25 * skin * skin;
}

void MovingNeighbours::search(const double* u) {
  if (crowded_) return;
  const std::size_t n = start_.size();
  searched_.assign(u, u + layout_.size);
  position_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    position_[i] = start_[i];
    for (int c = 0; c < layout_.dim; ++c) position_[i][c] += u[layout_.at(i, c)];
  }
  cells_.build(position_, layout_.dim, radius_ + skin_);
  const bool first = searches_++ == 0;
  if (first) fullest_at_start_ = cells_.fullest();
  // If very many particles gather in one cell, the lists would hold nearly all pairs. They are not made then:
  // the run stops with a message.
  if (cells_.fullest() > 6 * fullest_at_start_ + 32) {
    crowded_ = std::size_t(cells_.one_of_fullest());
    return;
  }
  near_.resize(n);
  chunks_.resize((n + blocks_in_chunk * lanes - 1) / (blocks_in_chunk * lanes));
  parallel_for(
      chunks_.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) fill(c);
      },
      blocks_in_chunk * lanes);
  if (first) near_at_start_ = near_;
  look_for_losses();
}

void MovingNeighbours::state(Archive& archive) {
  archive("lists searched at", searched_);
  archive("neighbours at start", near_at_start_);
  archive("fullest cell at start", fullest_at_start_);
  archive("searches", searches_);
  if (!archive.restoring() || searched_.empty()) return;
  crowded_.reset();
  const AlignedVector<double> at = searched_;
  --searches_;
  search(at.data());
}

void MovingNeighbours::fill(std::size_t chunk) {
  const std::size_t n = start_.size(), first_block = chunk * blocks_in_chunk,
                    blocks = (n + lanes - 1) / lanes;
  Chunk& out = chunks_[chunk];
  out.index.clear();
  out.begin.assign(1, 0);
  std::vector<std::int32_t> row[lanes];
  for (std::size_t b = first_block; b < std::min(first_block + blocks_in_chunk, blocks); ++b) {
    std::size_t count[lanes] = {}, most = 0;
    for (std::size_t l = 0; l < lanes && b * lanes + l < n; ++l) {
      count[l] = list(b * lanes + l, row[l], near_[b * lanes + l]);
      most = std::max(most, count[l]);
    }
    const std::size_t begin = out.index.size();
    out.index.resize(begin + most * lanes);
    for (std::size_t l = 0; l < lanes; ++l)
      for (std::size_t k = 0; k < most; ++k)
        out.index[begin + k * lanes + l] = k < count[l] ? row[l][k] : std::int32_t(b * lanes + l);
    out.begin.push_back(std::uint32_t(out.index.size() / lanes));
  }
}

std::size_t MovingNeighbours::list(std::size_t particle, std::vector<std::int32_t>& out,
                                   std::uint16_t& near) const {
  const Point& at = position_[particle];
  const double far2 = (radius_ + skin_) * (radius_ + skin_), near2 = radius_ * radius_ * (1 - 1e-9);
  const double *x = cells_.sorted(0).data(), *y = cells_.sorted(1).data(),
               *z = layout_.dim == 3 ? cells_.sorted(2).data() : nullptr;
  std::size_t count = 0, within = 0;
  cells_.runs(at, [&](int first, int last) {
    if (out.size() < count + std::size_t(last - first))
      out.resize(2 * out.size() + std::size_t(last - first));
    for (int m = first; m < last; ++m) {
      const double dx = x[m] - at[0], dy = y[m] - at[1], dz = z ? z[m] - at[2] : 0.0,
                   r2 = dx * dx + dy * dy + dz * dz;
      const int j = cells_.items()[std::size_t(m)];
      out[count] = j;  // overwritten by the next one unless count grows
      const bool other = j != int(particle);
      count += other & (r2 < far2);
      within += other & (r2 < near2);
    }
  });
  near = std::uint16_t(std::min<std::size_t>(within, 65535));
  return count;
}

/// A particle with fewer than dim + 1 neighbours, and fewer than at the start, has left its body: a gradient
/// in `dim` dimensions needs about that many.
void MovingNeighbours::look_for_losses() {
  loss_.reset();
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (near_[i] > layout_.dim || near_[i] >= near_at_start_[i]) continue;
    if (!loss_) loss_ = Loss{i, near_[i], near_at_start_[i], 0};
    ++loss_->alone;
    if (near_[i] < loss_->neighbours)
      loss_->particle = i, loss_->neighbours = near_[i], loss_->at_start = near_at_start_[i];
  }
}

}  // namespace femsph::sph
