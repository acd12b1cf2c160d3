#pragma once
// Reinforcing bars in SPH: the stress of a bar is smeared over the particles of its rows. Particle i has a
// piece of length l_i, whose strain e_i and direction p follow from the particle's gradient H_i (bar_strain).
// The stress of the particle grows by
//   P_i += (A l_i / V_i) sigma(e_i) p (x) e_a
// so that sum_i V_i P_i : dH_i is the virtual work sum_i A l_i sigma_i de_i. Springs between particles would
// not do: particles can alternate along the bar without a strain in H, and the matrix would slip past them.

#include <vector>

#include "model/motion/bodies/bars.hpp"
#include "model/motion/bodies/discretization.hpp"
#include "sph/particles/particles.hpp"

namespace femsph::sph {

struct SmearedPiece {
  std::size_t particle, row;
  double length;    ///< l_i, m
  double per_cell;  ///< A l_i / V_i, V_i with the thickness
  BarState state;
};

class SmearedBars {
 public:
  SmearedBars() = default;
  SmearedBars(const std::vector<BarRow>& rows, const Particles& particles, double thickness);
  std::size_t bytes() const { return pieces.size() * sizeof(SmearedPiece); }
  void add_mass(std::vector<double>& mass) const;
  double dissipated_energy() const;
  void state(Archive& archive) { bar_states(archive, pieces); }
  double volume(const SmearedPiece& piece) const { return rows[piece.row].area * piece.length; }

  std::vector<BarRow> rows;
  std::vector<SmearedPiece> pieces;  ///< row by row, along the bar
};

}  // namespace femsph::sph
