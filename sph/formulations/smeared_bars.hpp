#pragma once
// Bars in SPH: their stress is smeared over the particles of their rows. Particle i stands for a piece of
// length l_i; with the particle's own gradient H_i the piece's strain e_i and direction of pull p follow
// (bar_strain), and
//   P_i += (A l_i / V_i) sigma(e_i) p (x) e_a
// is what makes sum_i V_i P_i : dH_i the virtual work sum_i A l_i sigma_i de_i. So bars share the particles'
// divergence, and no motion that the particles do not see can slip past them, as it would past springs
// between particles.

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
