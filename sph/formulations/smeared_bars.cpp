#include "sph/formulations/smeared_bars.hpp"

namespace femsph::sph {

SmearedBars::SmearedBars(const std::vector<BarRow>& all, const Particles& particles, double thickness)
    : rows(all) {
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t k = 0; k < rows[r].points.size(); ++k) {
      const std::size_t i = rows[r].points[k];
      const double length = rows[r].length[k];
      if (length > 0)
        pieces.push_back({i, r, length, rows[r].area * length / (particles.own_volume(i) * thickness), {}});
    }
}

void SmearedBars::add_mass(std::vector<double>& mass) const {
  for (const SmearedPiece& piece : pieces)
    mass[piece.particle] += rows[piece.row].law.density * volume(piece);
}

double SmearedBars::dissipated_energy() const {
  double sum = 0;
  for (const SmearedPiece& piece : pieces) sum += piece.state.dissipated * volume(piece);
  return sum;
}

}  // namespace femsph::sph
