#pragma once
// The loop over the cells of a body. Its kernel is chosen once, when the body is discretized: by element,
// kinematics, law, dimension and scalar type.

#include <cstddef>
#include <memory>
#include <optional>

#include "fem/mesh/batches.hpp"
#include "fem/options.hpp"
#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/archive.hpp"

namespace femsph::fem {

/// The state of one material point, in the axes of space.
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
  /// The time step of the next add_force(), s, for laws that depend on the rate of strain.
  virtual void set_step(double) {}
  /// f += the internal force of the cells, ghost slots included; advances the state of the material.
  virtual void add_force(const double* u, double* f) = 0;
  /// y += K x of the undeformed elastic body.
  virtual void add_stiffness(const double* x, double* y) const = 0;
  virtual Energies energies(const double* u) const = 0;
  /// The material points of cells begin .. end - 1, cell by cell, into `out`.
  virtual void samples(const double* u, std::size_t begin, std::size_t end, Sample* out) const = 0;
  virtual int points_per_cell() const = 0;
  virtual bool equal_volumes() const = 0;  ///< of the material points of a cell
  virtual std::size_t bytes() const = 0;
  /// Saves or restores the history of every material point.
  virtual void state(Archive& archive) = 0;
};

/// What a loop works on. Mesh and batches must outlive the loop.
struct LoopInput {
  const Mesh* mesh;
  const Batches* batches;
  Law law;
  double thickness;                 ///< m; 1 in 3D
  std::optional<double> hourglass;  ///< of Options
  bool large_motion;
};

/// The loop of the element of this word (elements()). Throws Refusal if there is none, or none for the
/// material.
std::unique_ptr<CellLoop> make_loop(const std::string& element, const LoopInput& in);

}  // namespace femsph::fem
