#pragma once
// Neighbour lists whose pairs ("bonds") have a memory. A bond carries
//   eta     its material length, m: the distance at which the kernel is taken,
//   misfit  q, m: its elongation that the mean linear motion of its two particles does not explain.
// A bond that was in the last lists keeps both; a new one starts with q = 0 and eta = its length, but at
// least the radius of the kernel, so that its weight starts at zero. A bond with eta below the radius stays
// in the lists however far it is stretched. Both halves of a bond (i in the list of j, j in that of i) store
// the same numbers: they are computed by formulas that are symmetric to the last bit.
//
// Beyond symmetry planes the lists contain mirror images of particles. An image has a number behind the last
// block of particles, and a mask of the planes (bit p: plane p) that it lies beyond.

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/array.hpp"
#include "model/numerics/parallel.hpp"
#include "model/numerics/simd.hpp"
#include "sph/particles/cell_list.hpp"
#include "sph/particles/particles.hpp"

namespace femsph::sph {

class BondLists {
 public:
  /// Pairs up to `radius` + `skin` (m). `remembers`: bonds have a memory; false for fluids, whose lists are
  /// plain Verlet lists.
  BondLists(const Particles& particles, const Layout& layout, double radius, double skin, bool remembers);

  /// Whether two particles can have approached each other by the skin since the last search.
  bool stale(const double* u) const;
  /// New lists at displacement u.
  void search(const double* u);
  bool searched() const { return !searched_.empty(); }
  /// Sets the misfit of every bond to 0.
  void forget_misfits();

  /// The bonds of one block of eight particles: arrays of [k][lane], k the number of the bond. A lane with
  /// fewer bonds than others is filled up with itself, at an infinite length eta.
  struct Bonds {
    const std::int32_t *index, *end;
    double *eta, *misfit;
    double* weight;         ///< of the last second pass, for the third
    const double* volumes;  ///< K_i K_j
  };
  /// Calls body(block, bonds) for every block.
  template <class Body>
  void each_block(Body&& body) {
    parallel_for(
        chunks_.size(), 1,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t c = begin; c < end; ++c)
            for (std::size_t b = 0; b + 1 < chunks_[c].begin.size(); ++b)
              body(c * blocks_in_chunk + b, of(c, b));
        },
        blocks_in_chunk * lanes);
  }
  Bonds bonds(std::size_t block) { return of(block / blocks_in_chunk, block % blocks_in_chunk); }

  /// An image beyond symmetry planes.
  struct Image {
    std::size_t of;
    unsigned mask;
  };
  const std::vector<Image>& images() const { return images_; }
  long searches() const { return searches_; }
  std::size_t bytes() const;
  /// The bonds are part of the state.
  void state(Archive& archive);

  /// A particle where particles are more than six times as crowded as at the start, if there is one. No lists
  /// are made then.
  std::optional<std::size_t> crowded() const { return crowded_; }

 private:
  static constexpr std::size_t blocks_in_chunk = 64;
  struct Chunk {
    AlignedVector<std::int32_t> index;
    AlignedVector<double> eta, misfit, weight, volumes;
    std::vector<std::uint32_t> begin;  ///< of each block, in bonds of a lane
  };
  struct Found {
    std::int32_t index;
    double eta, misfit;
  };
  Bonds of(std::size_t c, std::size_t b) {
    Chunk& k = chunks_[c];
    const std::size_t first = lanes * k.begin[b], last = lanes * k.begin[b + 1];
    const auto at = [&](AlignedVector<double>& a) { return a.empty() ? nullptr : a.data() + first; };
    return {
        k.index.data() + first, k.index.data() + last, at(k.eta), at(k.misfit), at(k.weight), at(k.volumes)};
  }
  void make_images(const double* u);
  void fill(std::size_t chunk, const Chunk& old, const std::vector<Image>& old_images,
            std::vector<std::int32_t>& known);
  void find(std::size_t particle, std::vector<Found>& out) const;
  void finish(std::size_t chunk);
  std::size_t key(std::size_t index, const std::vector<Image>& images) const {
    return index < size_
               ? index << planes_.size()
               : images[index - first_image_].of << planes_.size() | images[index - first_image_].mask;
  }

  const Particles& particles_;
  const Layout& layout_;
  std::size_t size_, first_image_;
  std::vector<MirrorPlane> planes_;
  double radius_, skin_;
  bool remembers_;
  AlignedVector<double> searched_;  ///< displacement at the last search
  std::vector<Point> position_;     ///< at that time, images included
  std::vector<Image> images_;
  std::vector<std::int32_t> number_of_;  ///< by key: the number of a particle or image, -1 if there is none
  CellList cells_;
  std::vector<Chunk> chunks_, old_chunks_;  ///< of the search before: their memory is used again
  int fullest_at_start_ = 0;
  std::optional<std::size_t> crowded_;
  long searches_ = 0;
};

}  // namespace femsph::sph
