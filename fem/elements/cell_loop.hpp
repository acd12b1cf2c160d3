#pragma once
// The loop over cells, with its kernel chosen once: element x kinematics x law x dimension x scalar type.

#include <cstddef>
#include <memory>
#include <optional>

#include "fem/mesh/batches.hpp"
#include "fem/options.hpp"
#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/archive.hpp"

namespace femsph::fem {

/// One material point as the loop sees it, in the axes of space.
struct Sample {
  std::size_t point;                     ///< cell * points per cell + number in the cell
  double volume;                         ///< m^dim, without the thickness
  std::array<double, 6> stress, strain;  ///< Cauchy; xx yy zz xy yz zx
  double plastic;                        ///< equivalent plastic strain; 0 when the law has none
  FlowStress flow;                       ///< of the Cauchy stress
};

class CellLoop {
 public:
  virtual ~CellLoop() = default;
  /// The step (s) that the next add_force() takes, for laws that ask for it.
  virtual void set_step(double) {}
  /// f += the internal force of the cells, ghost slots included; advances the state of the material.
  virtual void add_force(const double* u, double* f) = 0;
  /// y += K x of the undeformed elastic body.
  virtual void add_stiffness(const double* x, double* y) const = 0;
  virtual Energies energies(const double* u) const = 0;
  /// The material points of cells begin .. end - 1, cell by cell, into `out`.
  virtual void samples(const double* u, std::size_t begin, std::size_t end, Sample* out) const = 0;
  virtual int points_per_cell() const = 0;
  virtual bool equal_volumes() const = 0;
  virtual std::size_t bytes() const = 0;
  /// What the law remembers of every material point.
  virtual void state(Archive& archive) = 0;
};

/// What a loop works on; the owner outlives it.
struct LoopInput {
  const Mesh* mesh;
  const Batches* batches;
  Law law;
  double thickness;
  std::optional<double> hourglass;
  bool large_motion;
};

std::unique_ptr<CellLoop> make_full_loop(const LoopInput&);
std::unique_ptr<CellLoop> make_sri_loop(const LoopInput&);
std::unique_ptr<CellLoop> make_one_point_loop(const LoopInput&);
std::unique_ptr<CellLoop> make_perturbed_loop(const LoopInput&);  ///< one point, by `hourglass`
std::unique_ptr<CellLoop> make_assumed_strain_loop(const LoopInput&);
std::unique_ptr<CellLoop> make_loop(Element element, const LoopInput&);

}  // namespace femsph::fem
