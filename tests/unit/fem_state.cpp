// Laws with history: an elastic law written as one, sigma += C d eps, must follow the elastic law step by
// step, in every element, batch or single cell, and asking for energy, stress or strain must not advance it.

#include <gtest/gtest.h>

#include "fem/elements/cell_loop_impl.hpp"
#include "fem/elements/elements.hpp"
#include "fem_support.hpp"
#include "model/scene/shapes/box.hpp"

namespace femsph::test {
namespace {

/// Linear elasticity in rate form: it stores its stress, and counts its steps in one value of history.
struct Incremental {
  LinearElastic law;
  const LinearElastic& elastic() const { return law; }
  template <int dim>
  static constexpr int history_size = 1;
  static constexpr bool path_independent = false;
  template <class T, int dim>
  FEMSPH_INLINE void update(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const {
    const Symmetric<T, dim> d = law.stress(increment);
    for (int k = 0; k < symmetric_size<dim>; ++k) stress[k] += d[k];
    history[0] += 1.0;
  }
  template <class T, int dim>
  FEMSPH_INLINE T stored_energy(const Symmetric<T, dim>& strain, const Symmetric<T, dim>& stress,
                                const T*) const {
    return law.stored_energy<T, dim>(strain, stress, nullptr);
  }
  double thickness_stress(const Symmetric<double, 2>& e, const Symmetric<double, 2>& s, const double*) const {
    return law.thickness_stress(e, s, nullptr);
  }
  double thickness_strain(const Symmetric<double, 2>& e, const Symmetric<double, 2>& s, const double*) const {
    return law.thickness_strain(e, s, nullptr);
  }
  static double plastic_strain(const double* history) { return history[0]; }
  template <class T>
  FEMSPH_INLINE T plastic_work(const T*) const {
    return T{};
  }
};

/// No bound: the law is elastic.
FlowStress flow_stress(const Incremental&, const double*, double, const std::array<double, 6>&) { return {}; }

template <class ElementType, class T, int dim>
void follow() {
  const LinearElastic elastic = LinearElastic::make(2.0, 0.3, 1.0, dim == 2 ? Plane::strain : Plane::none);
  const fem::Mesh mesh = fem::make_mesh(Box(dim, {}, {1.0, 0.8, 0.9}), {3, 3, 3}, 0.2);
  const fem::Batches batches(mesh);
  const fem::LoopInput in{&mesh, &batches, elastic, 1.0, 0.05, true};
  fem::Loop<ElementType, FiniteRotation, LinearElastic, dim, T> total(in, elastic);
  fem::Loop<ElementType, FiniteRotation, Incremental, dim, T> stepped(in, Incremental{elastic});
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-0.03, 0.03);
  std::vector<double> u(batches.slots * dim, 0.0);
  for (int step = 0; step < 3; ++step) {
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) u[i] += uniform(engine);
    std::vector<double> f(u.size(), 0.0), g(u.size(), 0.0);
    total.add_force(u.data(), f.data());
    stepped.add_force(u.data(), g.data());
    for (std::size_t i = 0; i < f.size(); ++i) ASSERT_NEAR(g[i], f[i], 1e-13 * largest(f));
    for (int again = 0; again < 2; ++again)
      EXPECT_NEAR(stepped.energies(u.data()).strain, total.energies(u.data()).strain, 1e-13);
    std::vector<fem::Sample> expected(batches.cells * static_cast<std::size_t>(total.points_per_cell())),
        found(expected.size());
    total.samples(u.data(), 0, batches.cells, expected.data());
    stepped.samples(u.data(), 0, batches.cells, found.data());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].point, i);
      EXPECT_NEAR(found[i].stress[0], expected[i].stress[0], 1e-13);
    }
  }
  EXPECT_GT(stepped.bytes(), total.bytes());  // memory for the history
}

template <class ElementType>
void follow_all() {
  follow<ElementType, double, 2>();
  follow<ElementType, Pack, 2>();
  follow<ElementType, Pack, 3>();
}

TEST(FemState, FullElementCarriesHistory) { follow_all<fem::FullElement>(); }
TEST(FemState, SriElementCarriesHistory) { follow_all<fem::SriElement>(); }
TEST(FemState, OnePointElementCarriesHistory) { follow_all<fem::OnePointElement>(); }
TEST(FemState, AssumedStrainElementCarriesHistory) { follow_all<fem::AssumedStrainElement>(); }

}  // namespace
}  // namespace femsph::test
