#pragma once
// The cell loop as a template of element, kinematics, law, dimension and scalar type.

#include <algorithm>
#include <vector>

#include "fem/elements/cell_loop.hpp"
#include "fem/elements/element.hpp"
#include "fem/elements/gather.hpp"
#include "fem/elements/mean_cell.hpp"
#include "fem/elements/observers.hpp"
#include "model/numerics/parallel.hpp"

namespace femsph::fem {

/// The axes of a cell, as columns: the orthonormal frame nearest to the directions of its sides, the polar
/// rotation of the unit tangents at the centre.
template <int dim>
Tensor<double, dim> cell_axes(const double* X) {
  const Modes<double, dim> m(X);
  Tensor<double, dim> F;
  for (int d = 0; d < dim; ++d) {
    double s = 0;
    for (int c = 0; c < dim; ++c) s += m.linear[d][c] * m.linear[d][c];
    for (int c = 0; c < dim; ++c) F[c][d] = m.linear[d][c] / std::sqrt(s);
  }
  return polar_rotation<double, dim>(F);
}

/// The part of a loop that does not depend on the law: gathering, axes, and the elastic stiffness.
template <class ElementType, int dim, class T>
class StiffnessLoop : public CellLoop {
 public:
  StiffnessLoop(const LoopInput& in, const LinearElastic& elastic)
      : mesh_(*in.mesh),
        batches_(*in.batches),
        elastic_(elastic, in.hourglass.value_or(0)),
        thickness_(in.thickness) {
    if constexpr (ElementType::own_axes) make_axes();
  }

  void add_stiffness(const double* x, double* y) const override {
    parallel_for(
        batches_.count, batches_per_domain,
        [&](std::size_t begin, std::size_t end) {
          Unobserved nobody;
          for (std::size_t b = begin; b < end; ++b)
            for (int lane = 0; lane < lane_loops(b); ++lane) {
              T f[size];
              cell<SmallStrain>(elastic_, b, lane, x, static_cast<T*>(nullptr), f, nobody);
              scatter_add<dim>(f, thickness_, &batches_.scatter[b * block], lane, y);
            }
        },
        lanes);
  }
  int points_per_cell() const override { return ElementType::template points<dim>; }
  bool equal_volumes() const override { return ElementType::equal_volumes; }
  std::size_t bytes() const override { return axes_.capacity() * sizeof(double); }

 protected:
  static constexpr int size = dim * corners<dim>;
  static constexpr std::size_t block = corners<dim> * lanes;  ///< offsets per batch

  /// How many times the kernel runs for batch b: once when T is a Pack, else once a cell.
  int lane_loops(std::size_t b) const {
    if constexpr (lanes_of<T> == lanes) return 1;
    return static_cast<int>(std::min<std::size_t>(lanes, batches_.cells - b * lanes));
  }

  template <class Kinematics, class S, class LawType, class Observer>
  FEMSPH_INLINE void cell(const CellMaterial<LawType>& material, std::size_t b, int lane,
                          const double* displacement, S* state, S* f, Observer& observer) const {
    S X[size], u[size];
    const int* at = &batches_.gather[b * block];
    gather<dim>(mesh_.nodes.data(), at, lane, X);
    gather<dim>(displacement, at, lane, u);
    if constexpr (ElementType::own_axes) {
      const Tensor<S, dim> R = axes<S>(b, lane);
      turn<true>(R, X);
      turn<true>(R, u);
      ElementType::template force<Kinematics, S, dim>(material, X, u, state, f, observer);
      turn<false>(R, f);
    } else {
      ElementType::template force<Kinematics, S, dim>(material, X, u, state, f, observer);
    }
  }

  /// The axes of the cell as columns; those of space if the element does not use the axes of the cell.
  template <class S>
  FEMSPH_INLINE Tensor<S, dim> axes(std::size_t b, int lane) const {
    Tensor<S, dim> R;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        if constexpr (ElementType::own_axes)
          R[i][j] = load<S>(&axes_[(b * dim * dim + static_cast<std::size_t>(i * dim + j)) * lanes +
                                   static_cast<std::size_t>(lane)]);
        else
          R[i][j] = broadcast<S>(i == j);
      }
    return R;
  }

  const Mesh& mesh_;
  const Batches& batches_;
  const CellMaterial<LinearElastic> elastic_;
  const double thickness_;

 private:
  void make_axes() {
    axes_.resize(batches_.count * dim * dim * lanes);
    for (std::size_t b = 0; b < batches_.count; ++b)
      for (int l = 0; l < lanes; ++l) {
        double X[size];
        gather<dim>(mesh_.nodes.data(), &batches_.gather[b * block], l, X);
        const Tensor<double, dim> R = cell_axes<dim>(X);
        for (int k = 0; k < dim * dim; ++k)
          axes_[(b * dim * dim + static_cast<std::size_t>(k)) * lanes + static_cast<std::size_t>(l)] =
              R[k / dim][k % dim];
      }
  }

  /// x <- R^T x (into the axes of the cell), or x <- R x, corner by corner.
  template <bool into, class S>
  FEMSPH_INLINE static void turn(const Tensor<S, dim>& R, S* x) {
#pragma GCC unroll 8
    for (int a = 0; a < corners<dim>; ++a) {
      S y[dim];
      for (int i = 0; i < dim; ++i) {
        y[i] = (into ? R[0][i] : R[i][0]) * x[a * dim];
        for (int k = 1; k < dim; ++k) y[i] += (into ? R[k][i] : R[i][k]) * x[a * dim + k];
      }
      for (int i = 0; i < dim; ++i) x[a * dim + i] = y[i];
    }
  }

  AlignedVector<double> axes_;
};

template <class ElementType, class Kinematics, class LawType, int dim, class T>
class Loop final : public StiffnessLoop<ElementType, dim, T> {
  using Base = StiffnessLoop<ElementType, dim, T>;
  using Base::batches_, Base::block, Base::size, Base::thickness_;
  static constexpr int points = ElementType::template points<dim>;
  static constexpr int state_size = points * point_state_size<LawType, dim>;

 public:
  Loop(const LoopInput& in, const LawType& law)
      : Base(in, law.elastic()),
        material_(law, in.hourglass.value_or(0)),
        state_(batches_.count * state_size * lanes, 0.0) {}

  void set_step([[maybe_unused]] double dt) override {
    if constexpr (requires { material_.law.set_step(dt); }) material_.law.set_step(dt);
  }
  void add_force(const double* u, double* f) override {
    parallel_for(
        batches_.count, batches_per_domain,
        [&](std::size_t begin, std::size_t end) {
          Unobserved nobody;
          for (std::size_t b = begin; b < end; ++b)
            for (int lane = 0; lane < this->lane_loops(b); ++lane) {
              T nodal[size];
              if constexpr (state_size == 0 || lanes_of<T> == lanes) {
                this->template cell<Kinematics>(
                    material_, b, lane, u, reinterpret_cast<T*>(state_.data() + b * state_size * lanes),
                    nodal, nobody);
              } else {
                double state[state_size + 1];
                read_state(b, lane, state);
                this->template cell<Kinematics>(material_, b, lane, u, state, nodal, nobody);
                for (int k = 0; k < state_size; ++k) state_[(b * state_size + k) * lanes + lane] = state[k];
              }
              scatter_add<dim>(nodal, -thickness_, &batches_.scatter[b * block], lane, f);
            }
        },
        lanes);
  }

  Energies energies(const double* u) const override {
    const auto [strain, hourglass, plastic] = parallel_sums<3>(
        batches_.count, [&](std::size_t begin, std::size_t end) {
          const std::size_t whole = std::min(
              end, batches_.cells / lanes);  // the last batch may repeat its last cell
          EnergyObserver<LawType, dim, T> many{material_};
          for (std::size_t b = begin; b < whole; ++b)
            for (int lane = 0; lane < lanes; lane += lanes_of<T>) observe_cell<T>(u, b, lane, many);
          EnergyObserver<LawType, dim, double> few{material_};
          observe(u, std::max(begin, whole) * lanes, std::min(end * lanes, batches_.cells), few);
          return std::array{
              horizontal_sum(many.strain) + few.strain, horizontal_sum(many.hourglass_) + few.hourglass_,
              horizontal_sum(many.plastic) + few.plastic};
        });
    return {thickness_ * strain, thickness_ * hourglass, thickness_ * plastic};
  }

  void samples(const double* u, std::size_t begin, std::size_t end, Sample* out) const override {
    SampleObserver<Kinematics, LawType, dim> observer{material_.law, out};
    observe(u, begin, end, observer);
  }
  std::size_t bytes() const override { return Base::bytes() + state_.capacity() * sizeof(double); }
  void state(Archive& archive) override {
    if constexpr (state_size > 0) archive("material", state_);
  }

 private:
  template <class S>
  FEMSPH_INLINE void read_state(std::size_t b, int lane, S* state) const {
    for (int k = 0; k < state_size; ++k) state[k] = load<S>(&state_[(b * state_size + k) * lanes + lane]);
  }

  /// Passes the material points of a cell (or of eight) to the observer; does not change the state.
  template <class S, class Observer>
  void observe_cell(const double* u, std::size_t b, int lane, Observer& observer) const {
    S f[size], state[state_size + 1];
    read_state(b, lane, state);
    this->template cell<Kinematics>(material_, b, lane, u, state, f, observer);
  }
  template <class Observer>
  void observe(const double* u, std::size_t begin, std::size_t end, Observer& observer) const {
    for (std::size_t c = begin; c < end; ++c) {
      const std::size_t b = c / lanes;
      const int lane = static_cast<int>(c % lanes);
      observer.enter(c * points, this->template axes<double>(b, lane));
      observe_cell<double>(u, b, lane, observer);
    }
  }

  CellMaterial<LawType> material_;
  AlignedVector<double> state_;  ///< (batch * state_size + value) * lanes + lane
};

/// The loop of an element for this law, kinematics and dimension. T = double makes the scalar form, one cell
/// at a time, for tests. Laws for large motion alone have no scalar form, to save compile time. Throws
/// Refusal if there is no such loop.
template <class ElementType, class T = Pack>
std::unique_ptr<CellLoop> choose_loop(const LoopInput& in) {
  return std::visit(
      [&](const auto& law) -> std::unique_ptr<CellLoop> {
        using LawType = std::decay_t<decltype(law)>;
        const auto with = [&]<class Kinematics, int dim>() -> std::unique_ptr<CellLoop> {
          if constexpr (lanes_of<T> == 1 && LargeMotionOnly<LawType>)
            throw Refusal("this material has no scalar loop");
          else
            return std::make_unique<Loop<ElementType, Kinematics, LawType, dim, T>>(in, law);
        };
        const bool plane = in.mesh->dim == 2;
        if (in.large_motion)
          return plane ? with.template operator()<LargeMotion<LawType>, 2>()
                       : with.template operator()<LargeMotion<LawType>, 3>();
        if constexpr (LargeMotionOnly<LawType>)
          throw Refusal("this material needs motion = \"large\"");
        else
          return plane ? with.template operator()<SmallStrain, 2>()
                       : with.template operator()<SmallStrain, 3>();
      },
      in.law);
}

}  // namespace femsph::fem
