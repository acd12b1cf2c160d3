#include "sph/operators/bond_lists.hpp"

#include <algorithm>
#include <string>

#include "model/numerics/archive.hpp"
#include "sph/operators/moving_neighbours.hpp"

namespace femsph::sph {

BondLists::BondLists(const Particles& particles, const Layout& layout, double radius, double skin,
                     bool remembers)
    : particles_(particles),
      layout_(layout),
      size_(particles.size()),
      first_image_(round_up(particles.size(), lanes)),
      planes_(particles.planes),
      radius_(radius),
      skin_(skin),
      remembers_(remembers) {}

std::size_t BondLists::bytes() const {
  std::size_t sum = searched_.size() * sizeof(double) + position_.size() * sizeof(Point) + cells_.bytes() +
                    images_.size() * sizeof(Image) + number_of_.size() * sizeof(std::int32_t);
  for (const std::vector<Chunk>* chunks : {&chunks_, &old_chunks_})
    for (const Chunk& c : *chunks)
      sum += c.index.size() * sizeof(std::int32_t) + c.begin.size() * sizeof(std::uint32_t) +
             (c.eta.size() + c.misfit.size() + c.weight.size() + c.volumes.size()) * sizeof(double);
  return sum;
}

/// Beyond a plane the displacements are mirrored: there a translation of the body counts.
bool BondLists::stale(const double* u) const {
  if (searched_.empty()) return true;
  if (planes_.empty()) return can_have_approached(u, searched_.data(), layout_, skin_);
  double most = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    double r2 = 0;
    for (int c = 0; c < layout_.dim; ++c) {
      const double moved = u[layout_.at(i, c)] - searched_[layout_.at(i, c)];
      r2 += moved * moved;
    }
    most = r2 > most ? r2 : most;
  }
  return most > 0.25 * skin_ * skin_;
}

void BondLists::forget_misfits() {
  for (Chunk& c : chunks_) std::fill(c.misfit.begin(), c.misfit.end(), 0.0);
}

/// Images of the particles within the range of the lists from each plane, corners of planes included. With a
/// memory, an image that once was in the lists remains: a stretched bond may need it.
void BondLists::make_images(const double* u) {
  position_.assign(first_image_, Point{NAN, NAN, NAN});
  for (std::size_t i = 0; i < size_; ++i) {
    position_[i] = particles_.position[i];
    for (int c = 0; c < layout_.dim; ++c) position_[i][std::size_t(c)] += u[layout_.at(i, c)];
  }
  if (planes_.empty()) return;
  if (number_of_.empty()) number_of_.assign(size_ << planes_.size(), -1);
  if (!remembers_) {
    images_.clear();
    std::fill(number_of_.begin(), number_of_.end(), -1);
  }
  const auto mirrored = [&](Point x, unsigned mask) {
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      const auto a = std::size_t(planes_[p].axis);
      if (mask >> p & 1) x[a] = 2 * planes_[p].at - x[a];
    }
    return x;
  };
  for (std::size_t i = 0; i < size_; ++i) {
    number_of_[i << planes_.size()] = std::int32_t(i);
    for (unsigned mask = 1; mask < 1u << planes_.size(); ++mask) {
      std::int32_t& number = number_of_[i << planes_.size() | mask];
      if (number >= 0) continue;
      bool near = true;
      for (std::size_t p = 0; p < planes_.size() && near; ++p)
        if (mask >> p & 1)
          near = !particles_.on_plane(particles_.position[i], planes_[p]) &&
                 std::abs(position_[i][std::size_t(planes_[p].axis)] - planes_[p].at) < radius_ + skin_;
      if (!near) continue;
      number = std::int32_t(first_image_ + images_.size());
      images_.push_back({i, mask});
    }
  }
  for (const Image& image : images_) position_.push_back(mirrored(position_[image.of], image.mask));
}

void BondLists::search(const double* u) {
  if (crowded_) return;
  const std::vector<Image> old_images = images_;
  searched_.assign(u, u + layout_.size);
  make_images(u);
  cells_.build(position_, layout_.dim, radius_ + skin_);
  if (searches_++ == 0) fullest_at_start_ = cells_.fullest();
  if (cells_.fullest() > 6 * fullest_at_start_ + 32) {
    crowded_ = std::size_t(cells_.one_of_fullest());
    if (*crowded_ >= first_image_) crowded_ = images_[*crowded_ - first_image_].of;
    return;
  }
  chunks_.resize((size_ + blocks_in_chunk * lanes - 1) / (blocks_in_chunk * lanes));
  old_chunks_.resize(chunks_.size());
  parallel_for(
      chunks_.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        std::vector<std::int32_t> known(remembers_ ? size_ << planes_.size() : 0, -1);
        for (std::size_t c = begin; c < end; ++c) {
          std::swap(chunks_[c], old_chunks_[c]);
          fill(c, old_chunks_[c], old_images, known);
        }
      },
      blocks_in_chunk * lanes);
}

/// The particles within radius + skin of one, in the order of the cells.
void BondLists::find(std::size_t particle, std::vector<Found>& out) const {
  const Point& at = position_[particle];
  const double far2 = (radius_ + skin_) * (radius_ + skin_);
  const double *x = cells_.sorted(0).data(), *y = cells_.sorted(1).data(),
               *z = layout_.dim == 3 ? cells_.sorted(2).data() : nullptr;
  out.clear();
  cells_.runs(at, [&](int first, int last) {
    for (int m = first; m < last; ++m) {
      const double dx = x[m] - at[0], dy = y[m] - at[1], dz = z ? z[m] - at[2] : 0.0,
                   r2 = dx * dx + dy * dy + dz * dz;
      const int j = cells_.items()[std::size_t(m)];
      if (r2 < far2 && j != int(particle)) out.push_back({j, std::sqrt(r2), 0.0});
    }
  });
}

/// `known`: one entry for each key, -1 before and after.
void BondLists::fill(std::size_t chunk, const Chunk& old, const std::vector<Image>& old_images,
                     std::vector<std::int32_t>& known) {
  const bool first = searches_ == 1;
  const std::size_t first_block = chunk * blocks_in_chunk, blocks = (size_ + lanes - 1) / lanes;
  Chunk& out = chunks_[chunk];
  out.begin.assign(1, 0);
  out.index.clear(), out.eta.clear(), out.misfit.clear();
  std::vector<Found> row[lanes];
  for (std::size_t b = first_block; b < std::min(first_block + blocks_in_chunk, blocks); ++b) {
    std::size_t most = 0;
    for (std::size_t l = 0; l < lanes; ++l) {
      const std::size_t i = b * lanes + l;
      row[l].clear();
      if (i >= size_) continue;
      find(i, row[l]);
      if (remembers_ && first)  // only what the kernel reaches in the undeformed body
        std::erase_if(row[l], [&](const Found& f) { return skin_ == 0 && f.eta >= radius_ * (1 - 1e-9); });
      if (remembers_ && !first) {
        for (std::size_t k = 0; k < row[l].size(); ++k) {
          known[key(std::size_t(row[l][k].index), images_)] = std::int32_t(k);
          row[l][k].eta = std::max(row[l][k].eta, radius_);
        }
        const std::size_t found = row[l].size(), at = b - first_block;
        for (std::size_t k = old.begin[at]; k < old.begin[at + 1]; ++k) {
          const std::size_t e = k * lanes + l;
          if (std::size_t(old.index[e]) == i) continue;
          const std::size_t name = key(std::size_t(old.index[e]), old_images);
          if (const std::int32_t again = known[name]; again >= 0)
            row[l][std::size_t(again)].eta = old.eta[e], row[l][std::size_t(again)].misfit = old.misfit[e];
          else if (old.eta[e] < radius_)
            row[l].push_back({planes_.empty() ? old.index[e] : number_of_[name], old.eta[e], old.misfit[e]});
        }
        for (std::size_t k = 0; k < found; ++k) known[key(std::size_t(row[l][k].index), images_)] = -1;
      }
      most = std::max(most, row[l].size());
    }
    const std::size_t begin = out.index.size(), end = begin + most * lanes;
    out.index.resize(end);
    if (remembers_) out.eta.resize(end), out.misfit.resize(end);
    for (std::size_t l = 0; l < lanes; ++l)
      for (std::size_t k = 0; k < most; ++k) {
        const std::size_t e = begin + k * lanes + l, i = b * lanes + l;
        const bool there = k < row[l].size();
        out.index[e] = there ? row[l][k].index : std::int32_t(i);
        if (!remembers_) continue;
        out.eta[e] = there ? row[l][k].eta : 1e30;
        out.misfit[e] = there ? row[l][k].misfit : 0.0;
      }
    out.begin.push_back(std::uint32_t(end / lanes));
  }
  finish(chunk);
}

/// The arrays of a chunk that follow from its indices.
void BondLists::finish(std::size_t chunk) {
  Chunk& out = chunks_[chunk];
  out.weight.resize(out.index.size());
  if (!remembers_) return;
  out.volumes.resize(out.index.size());
  for (std::size_t b = 0; b + 1 < out.begin.size(); ++b)
    for (std::size_t e = out.begin[b] * lanes; e < out.begin[b + 1] * lanes; ++e) {
      const std::size_t i = (chunk * blocks_in_chunk + b) * lanes + e % lanes;
      const auto j = std::size_t(out.index[e]);
      out.volumes[e] = 0;
      if (i >= size_ || j == i) continue;
      out.volumes[e] = particles_.kernel_volume[i] *
                       particles_.kernel_volume[j < size_ ? j : images_[j - first_image_].of];
    }
}

void BondLists::state(Archive& archive) {
  archive("lists searched at", searched_);
  archive("fullest cell at start", fullest_at_start_);
  archive("searches", searches_);
  std::vector<std::size_t> image_of;
  std::vector<unsigned> image_mask;
  for (const Image& image : images_) image_of.push_back(image.of), image_mask.push_back(image.mask);
  archive("images", image_of);
  archive("images beyond", image_mask);
  if (archive.restoring()) {
    crowded_.reset();
    images_.clear();
    if (!planes_.empty()) number_of_.assign(size_ << planes_.size(), -1);
    for (std::size_t i = 0; !planes_.empty() && i < size_; ++i)
      number_of_[i << planes_.size()] = std::int32_t(i);
    for (std::size_t k = 0; k < image_of.size(); ++k) {
      images_.push_back({image_of[k], image_mask[k]});
      number_of_[image_of[k] << planes_.size() | image_mask[k]] = std::int32_t(first_image_ + k);
    }
    chunks_.assign(
        searched_.empty() ? 0 : (size_ + blocks_in_chunk * lanes - 1) / (blocks_in_chunk * lanes), {});
  }
  for (std::size_t c = 0; c < chunks_.size(); ++c)
    archive.below(std::to_string(c), [&] {
      archive("begin", chunks_[c].begin);
      archive("index", chunks_[c].index);
      archive("length", chunks_[c].eta);
      archive("misfit", chunks_[c].misfit);
      if (archive.restoring()) finish(c);
    });
}

}  // namespace femsph::sph
