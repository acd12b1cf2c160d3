#pragma once
// SPH on updated neighbours whose bonds have a memory ("sph-updated"): the part that does not depend on the
// law. Equations and sources: sph/README.md. With r = x_j - x_i, R = |r|, K the kernel volumes, s =
// -(dW/dr)/r, and for each bond its material length eta and its misfit q (bond_lists.hpp), one step is three
// passes:
//   1  at the middle of the step:  L_i = dt sum_j K_j w_ij (v_j - v_i) (x) r  M_i^-1,  M_i = sum_j K_j w_ij r
//   (x) r,
//      w_ij = s(eta) max(1, eta/R)^3, of a fluid s(R). The law makes V_i sigma_i of L_i.
//   2  q += dt (v_ij . r - r . (D_i + D_j)/2 r) / R at the middle; then at the end of the step the spring
//      t = xi mu K_i K_j s(eta) (eta/h)^4 q along r, its share S_i -= t/(2R) r (x) r in the stress (the
//      adjoint of the terms with D), M_i again, and Q_i = (V_i sigma_i + S_i) M_i^-1
//   3  f_i = sum_j w_ij (K_j Q_i + K_i Q_j) r + the springs
// Pass 3 is the exact adjoint of pass 1 for any weights, so linear and angular momentum are conserved.

#include "sph/formulations/particle_body.hpp"
#include "sph/operators/bond_lists.hpp"
#include "sph/operators/particle_records.hpp"

namespace femsph::sph {

template <int dim>
class BondBody : public ParticleBody {
 public:
  std::string describe() const override;
  std::size_t bytes() const override;
  void stiffness(const double* x, double* y) const override;
  bool has_viscosity() const override { return options_.viscosity.on(); }
  void damping_matrix(const double* x, double* y) const override;
  void internal_force(const double* u, const double* v, double dt, double* f, double* viscous) override;
  void state(Archive& archive) override;
  std::optional<Trouble> trouble(const double* u) const override;
  std::optional<Stiffening> stiffening(const double* u) const override;

 protected:
  static constexpr int n = symmetric_size<dim>;
  /// `fluid`: the law has no shear stiffness; bonds then have no memory. `flows`: the law may forget.
  BondBody(const Scene& scene, std::size_t body, const Options& options, Particles particles,
           const Kernel& kernel, const LinearElastic& elastic, bool fluid, bool flows);

  /// Advances the material by L of every particle (times dt): writes V sigma and, if the law flows, `kept`.
  /// Whether any particle has flowed.
  virtual bool advance_material(double dt) = 0;
  virtual void material_archive(Archive& archive) = 0;
  /// Turns the ratio of the bonds' grip on each particle to that at the start into the ratio of stiffness.
  virtual void stiffen(AlignedVector<double>& ratio) const = 0;

  /// Energy of the springs, and the part of it that flow has taken, J.
  double spring_energy() const;
  double forgotten_energy() const;
  template <class Body>
  void for_blocks(Body&& body) const {
    parallel_for(blocks_ * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) body(block);
    });
  }
  FEMSPH_INLINE Tensor<Pack, dim> motion(std::size_t block) const {
    Tensor<Pack, dim> L;
    for (int k = 0; k < dim * dim; ++k)
      L.a[k / dim][k % dim] = load<Pack>(&l_[(block * dim * dim + std::size_t(k)) * lanes]);
    return L;
  }
  FEMSPH_INLINE Pack undeformed(std::size_t block) const { return load<Pack>(&volume_[block * lanes]); }
  FEMSPH_INLINE Pack part(std::size_t block) const {
    return part_.empty() ? broadcast<Pack>(1.0) : load<Pack>(&part_[block * lanes]);
  }
  FEMSPH_INLINE void set_resultant(std::size_t block, const Symmetric<Pack, dim>& s) const {
    for (int k = 0; k < n; ++k) store(&resultant_[(block * n + std::size_t(k)) * lanes], s[k]);
  }

  std::size_t blocks_;
  /// The share of the memory that remains in this step, of particles and images; empty unless the law flows.
  mutable AlignedVector<double> kept_;

 private:
  // The fields in the records: x, v, K and D for passes 1 and 2, and x, K, Q for pass 3.
  enum Motion { middle = 0, velocity = dim, measure = 2 * dim, rate = 2 * dim + 1 };
  enum Force { place = 0, extent = dim, pull = dim + 1 };
  static constexpr int motion_lines = (2 * dim + 1 + n + lanes - 1) / lanes,
                       force_lines = (dim + 1 + dim * dim + lanes - 1) / lanes;
  using MotionRecords = ParticleRecords<motion_lines>;
  using ForceRecords = ParticleRecords<force_lines>;

  /// How a pass runs: positions at the middle of the step are x - half v; misfits grow by `time` m.
  struct Step {
    double half, time;
  };
  FEMSPH_INLINE std::size_t slot(std::size_t block, int c) const {
    return layout_.offset + block * lanes + std::size_t(c) * layout_.component_stride;
  }
  template <class Run>
  void with_kernel(Run&& run) const;
  void lay_down_motion(BondLists& lists, const double* u, const double* v, double half) const;
  void lay_down_rates(BondLists& lists) const;
  template <class Spline, bool fluid>
  void gradients(BondLists& lists, double time) const;
  template <class Spline, bool fluid, bool flowing, bool with_viscosity>
  void bond_forces(BondLists& lists, const Step& step, double* f, double* viscous) const;
  void divergence(BondLists& lists, double* f) const;
  void passes(BondLists& lists, const Step& step, bool flowing, double* f, double* viscous) const;
  template <class Records, class SignOf>
  void lay_down_images(const BondLists& lists, Records& records, int place_at, SignOf&& sign_of) const;
  template <class Spline>
  void damping(BondLists& lists, double* y) const;
  void forces_at_rest(const double* u, const double* v, double* f, double* viscous);
  void advance(const double* u, const double* v, const Step& step, double dt);
  BondLists& undeformed_lists() const;
  void size_records(const BondLists& lists) const;

  LinearElastic elastic_;
  Kernel kernel_;
  bool fluid_, flows_, large_;
  bool flowed_ = false, flowing_ = false;  ///< since the last search; in this step
  double spring_;                          ///< xi mu times the thickness, Pa m
  BondLists lists_;
  mutable std::unique_ptr<BondLists> undeformed_;  ///< for stiffness(); made when asked for
  AlignedVector<double> start_;                    ///< undeformed positions, flat
  AlignedVector<double> volume_, kernel_volume_;   ///< V0 and K, m^dim
  AlignedVector<double> part_;  ///< of a particle's volume in the body; empty without symmetry planes
  mutable AlignedVector<double> l_, resultant_, grip_, tension_, forgotten_;  ///< [block][component][lane]
  AlignedVector<double> grip_at_start_;
  mutable MotionRecords motion_;
  mutable ForceRecords forces_;
};

extern template class BondBody<2>;
extern template class BondBody<3>;

}  // namespace femsph::sph
