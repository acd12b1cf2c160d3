#pragma once
// Reinforcing bars in FEM: truss elements between the consecutive nodes of a row. A truss between nodes a and
// b at the distance L, of which the bar covers the length l <= L, has the strain bar_strain with g = (u_b -
// u_a) / L, the energy A l w(strain), and so the force A (l / L) sigma on its ends.

#include <vector>

#include "model/motion/bodies/bars.hpp"
#include "model/motion/bodies/discretization.hpp"

namespace femsph::fem {

class TrussBars {
 public:
  TrussBars() = default;
  TrussBars(const std::vector<BarRow>& rows, const std::vector<Point>& nodes, int dim, bool large_motion);
  std::size_t bytes() const { return trusses_.size() * sizeof(Truss); }
  void add_mass(std::vector<double>& mass) const;
  /// f += internal force at displacement u, both interleaved; advances the bars' state.
  void add_force(const double* u, double* f);
  /// y += K x of the undeformed elastic bars.
  void add_stiffness(const double* x, double* y) const;
  double strain_energy(const double* u) const;
  double dissipated_energy() const;
  void state(Archive& archive) { bar_states(archive, trusses_); }
  std::vector<BarPiece> pieces(const double* u) const;

 private:
  struct Truss {
    std::size_t node[2];
    std::size_t bar;
    int axis;
    double area, length, gap;  ///< A, m^2; l and L, m
    Point middle;
    BarLaw law;
    BarState state;
  };
  /// Strain of a truss, and in `pull` the unit vector along it, from its first end to its second.
  double strain(const Truss& truss, const double* u, bool large, double (&pull)[3]) const;
  double strain(const Truss& truss, const double* u) const {
    double pull[3];
    return strain(truss, u, large_, pull);
  }

  std::vector<Truss> trusses_;
  int dim_ = 2;
  bool large_ = false;
};

}  // namespace femsph::fem
