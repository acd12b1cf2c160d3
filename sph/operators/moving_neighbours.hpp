#pragma once
// Neighbours of particles that move (Verlet lists): pairs up to the radius of the kernel plus a skin. They
// are valid until two particles can have approached each other by the skin; the mean displacement of the body
// does not count. Eight consecutive particles are a block. The k-th neighbours of the particles of a block
// are stored side by side (SELL-8), so that loops run on packs.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/array.hpp"
#include "model/numerics/parallel.hpp"
#include "model/numerics/simd.hpp"
#include "sph/particles/cell_list.hpp"

namespace femsph::sph {

/// Whether two points can have approached each other by `skin` (m) between two displacements; the mean
/// displacement of the body does not count.
bool can_have_approached(const double* u, const double* before, const Layout& layout, double skin);

/// Particles so crowded that no lists are made: `position` is one of them, m.
Trouble heap_trouble(const Point& position);

class MovingNeighbours {
 public:
  MovingNeighbours(std::span<const Point> start, const Layout& layout, double radius, double skin);

  /// Lists for displacement u: a new search only if the old lists may miss a pair.
  void update(const double* u) {
    if (stale(u)) search(u);
  }
  long searches() const { return searches_; }
  /// Saves or restores the displacement at the last search, from which the lists follow.
  void state(Archive& archive);

  /// Calls body(block, first, last) for every block, with the range of its neighbour indices, [k][lane].
  /// Where a lane has fewer neighbours than others, the rest of its indices are the particle itself.
  template <class Body>
  void each_block(Body&& body) const {
    parallel_for(
        chunks_.size(), 1,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t c = begin; c < end; ++c)
            for (std::size_t b = 0; b + 1 < chunks_[c].begin.size(); ++b)
              body(c * blocks_in_chunk + b, chunks_[c].index.data() + lanes * chunks_[c].begin[b],
                   chunks_[c].index.data() + lanes * chunks_[c].begin[b + 1]);
        },
        blocks_in_chunk * lanes);
  }

  std::size_t bytes() const;

  /// A particle that has lost its neighbours; looked for at searches only.
  struct Loss {
    std::size_t particle;
    int neighbours, at_start;
    std::size_t alone;  ///< how many particles are in this state
  };
  const std::optional<Loss>& loss() const { return loss_; }
  bool crowded() const { return crowded_.has_value(); }
  std::size_t fullest() const { return *crowded_; }  ///< a particle where they are most crowded

 private:
  static constexpr std::size_t blocks_in_chunk = 64;
  struct Chunk {
    AlignedVector<std::int32_t> index;  ///< [neighbour][lane], block after block
    std::vector<std::uint32_t> begin;   ///< of each block
  };
  void search(const double* u);
  bool stale(const double* u) const {
    return searched_.empty() || can_have_approached(u, searched_.data(), layout_, skin_);
  }
  void fill(std::size_t chunk);
  std::size_t list(std::size_t particle, std::vector<std::int32_t>& out, std::uint16_t& near) const;
  void look_for_losses();

  std::span<const Point> start_;
  Layout layout_;
  double radius_, skin_;
  AlignedVector<double> searched_;  ///< displacement, flat
  std::vector<Point> position_;
  CellList cells_;
  std::vector<Chunk> chunks_;
  std::vector<std::uint16_t> near_, near_at_start_;  ///< neighbours within the kernel's radius
  int fullest_at_start_ = 0;
  long searches_ = 0;
  std::optional<std::size_t> crowded_;
  std::optional<Loss> loss_;
};

}  // namespace femsph::sph
