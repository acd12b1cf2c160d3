#pragma once
// The rest of bond_body.hpp: how a step runs its passes. Included by bond_body_2d.cpp and _3d.cpp alone.

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "model/material/kinematics.hpp"
#include "sph/formulations/bond_passes.hpp"
#include "sph/operators/moving_neighbours.hpp"

namespace femsph::sph {

/// Of a fluid, unless another is given: nothing else keeps its particles in order behind a shock.
inline constexpr Viscosity fluid_viscosity{1, 1, 0.01};

template <int dim>
BondBody<dim>::BondBody(const Scene& scene, std::size_t body, const Options& options, Particles particles,
                        const Kernel& kernel, const LinearElastic& elastic, bool fluid, bool flows)
    : ParticleBody(scene, body, options, std::move(particles), kernel),
      blocks_(round_up(particles_.size(), lanes) / lanes),
      elastic_(elastic),
      kernel_(kernel),
      fluid_(fluid),
      flows_(flows),
      large_(scene.large_motion),
      spring_(options.hourglass * elastic.mu * thickness_),
      lists_(particles_, layout_, kernel.radius(),
             scene.large_motion && (flows || fluid) ? 0.3 * particles_.spacing : 0.0, !fluid) {
  if (fluid && !options_.viscosity.on()) options_.viscosity = fluid_viscosity;
  const std::size_t padded = blocks_ * lanes;
  start_.assign(layout_.size, 0.0);
  volume_.assign(padded, 0.0);
  kernel_volume_.assign(padded, 0.0);
  if (!particles_.planes.empty()) part_.assign(padded, 1.0);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    volume_[i] = particles_.volume[i];
    kernel_volume_[i] = fluid ? particles_.volume[i] : particles_.kernel_volume[i];
    if (!part_.empty()) part_[i] = particles_.part[i];
    for (int c = 0; c < dim; ++c) start_[layout_.at(i, c)] = particles_.position[i][std::size_t(c)];
  }
  l_.assign(padded * dim * dim, 0.0);
  resultant_.assign(padded * n, 0.0);
  grip_.assign(padded, 0.0);
  tension_.assign(padded, 0.0);
  if (flows) forgotten_.assign(padded, 0.0);
}

template <int dim>
std::string BondBody<dim>::describe() const {
  return ParticleBody::describe() + (!large_  ? ", bonds"
                                     : fluid_ ? ", updated neighbours"
                                              : ", updated neighbours, bonds with memory");
}

template <int dim>
std::size_t BondBody<dim>::bytes() const {
  return ParticleBody::bytes() + lists_.bytes() + motion_.bytes() + forces_.bytes() +
         (start_.size() + volume_.size() + kernel_volume_.size() + part_.size() + l_.size() + kept_.size() +
          resultant_.size() + grip_.size() + tension_.size() + grip_at_start_.size() + forgotten_.size()) *
             sizeof(double);
}

template <int dim>
void BondBody<dim>::size_records(const BondLists& lists) const {
  const std::size_t all = blocks_ * lanes + lists.images().size();
  motion_.resize(all);
  forces_.resize(all);
  if (flows_) kept_.resize(all, 1.0);
}

/// Images beyond symmetry planes. `sign_of(field, sign)`: the sign that a field takes where axes a change
/// sign by sign[a]; the fields place_at .. place_at + dim - 1 are a position.
template <int dim>
template <class Records, class SignOf>
void BondBody<dim>::lay_down_images(const BondLists& lists, Records& records, int place_at,
                                    SignOf&& sign_of) const {
  if (lists.images().empty()) return;
  constexpr int lines = Records::fields / lanes;
  const std::vector<MirrorPlane>& planes = particles_.planes;
  struct Reflection {
    Pack sign[lines], shift[lines];
  };
  std::vector<Reflection> reflections(std::size_t{1} << planes.size());
  for (std::size_t mask = 0; mask < reflections.size(); ++mask) {
    double sign[3] = {1, 1, 1}, shift[3] = {};
    for (std::size_t p = 0; p < planes.size(); ++p)
      if (mask >> p & 1) sign[planes[p].axis] = -1, shift[planes[p].axis] = 2 * planes[p].at;
    for (int field = 0; field < Records::fields; ++field) {
      const int axis = field - place_at;
      reflections[mask].sign[field / lanes][field % lanes] = sign_of(field, sign);
      reflections[mask].shift[field / lanes][field % lanes] = axis >= 0 && axis < dim ? shift[axis] : 0.0;
    }
  }
  const auto& images = lists.images();
  parallel_for(images.size(), lanes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Reflection& by = reflections[images[k].mask];
      records.image(blocks_ * lanes + k, images[k].of, by.sign, by.shift);
    }
  });
}

template <int dim>
void BondBody<dim>::lay_down_motion(BondLists& lists, const double* u, const double* v, double half) const {
  for_blocks([&](std::size_t block) {
    Pack own[MotionRecords::fields] = {};
    for (int c = 0; c < dim; ++c) {
      own[velocity + c] = load<Pack>(v + slot(block, c));
      own[middle + c] = load<Pack>(&start_[slot(block, c)]) - half * own[velocity + c];
      if (u) own[middle + c] += load<Pack>(u + slot(block, c));
    }
    own[measure] = load<Pack>(&kernel_volume_[block * lanes]);
    motion_.store_block(block, own);
  });
  lay_down_images(lists, motion_, middle, [](int field, const double* sign) {
    if (field < measure) return sign[field % dim];
    return 1.0;
  });
}

/// D = sym L of every particle.
template <int dim>
void BondBody<dim>::lay_down_rates(BondLists& lists) const {
  for_blocks([&](std::size_t block) {
    Pack own[MotionRecords::fields];
    motion_.load_block(block, own);
    Symmetric<Pack, dim> D;
    SmallStrain::strain<Pack, dim>(motion(block), D);
    for (int k = 0; k < n; ++k) own[rate + k] = D[k];
    motion_.store_block(block, own);
  });
  lay_down_images(lists, motion_, middle, [](int field, const double* sign) {
    if (field < measure) return sign[field % dim];
    for (int r = 0; r < dim; ++r)
      for (int c = r; c < dim; ++c)
        if (field == rate + symmetric_index<dim>(r, c)) return sign[r] * sign[c];
    return 1.0;
  });
}

/// Passes 2 and 3. `flowing`: some particle flows in this step.
template <int dim>
void BondBody<dim>::passes(BondLists& lists, const Step& step, bool flowing, double* f,
                           double* viscous) const {
  lay_down_rates(lists);
  with_kernel([&]<class Spline>(Spline) {
    const auto forces = [&]<bool fluid, bool flow>() {
      viscous ? bond_forces<Spline, fluid, flow, true>(lists, step, f, viscous)
              : bond_forces<Spline, fluid, flow, false>(lists, step, f, viscous);
    };
    if (fluid_)
      forces.template operator()<true, false>();
    else if (flowing)
      forces.template operator()<false, true>();
    else
      forces.template operator()<false, false>();
  });
  lay_down_images(lists, forces_, place, [](int field, const double* sign) {
    if (field < extent) return sign[field];
    if (field >= pull && field < pull + dim * dim)
      return sign[(field - pull) / dim] * sign[(field - pull) % dim];
    return 1.0;
  });
  divergence(lists, f);
}

/// The forces of the present positions, with v for the viscosity; nothing advances.
template <int dim>
void BondBody<dim>::forces_at_rest(const double* u, const double* v, double* f, double* viscous) {
  lay_down_motion(lists_, large_ ? u : nullptr, v, 0);
  std::fill(l_.begin(), l_.end(), 0.0);
  passes(lists_, {0, 0}, false, f, viscous);
}

template <int dim>
void BondBody<dim>::advance(const double* u, const double* v, const Step& step, double dt) {
  lay_down_motion(lists_, large_ ? u : nullptr, v, step.half);
  with_kernel([&]<class Spline>(Spline) {
    fluid_ ? gradients<Spline, true>(lists_, step.time) : gradients<Spline, false>(lists_, step.time);
  });
  flowing_ = advance_material(dt) && large_;
  flowed_ = flowed_ || flowing_;
  if (flowing_)
    for (std::size_t k = 0; k < lists_.images().size(); ++k)
      kept_[blocks_ * lanes + k] = kept_[lists_.images()[k].of];
}

/// In small motion the sums are those of the undeformed positions, and bonds do not forget their lengths. At
/// t = 0 (dt = 0) the lists are those of the undeformed body, so that bonds remember its lengths, and an
/// initial displacement is one step of the material.
template <int dim>
void BondBody<dim>::internal_force(const double* u, const double* v, double dt, double* f, double* viscous) {
  undeformed_.reset();
  if (!lists_.searched()) {
    lists_.search(AlignedVector<double>(layout_.size, 0.0).data());
    size_records(lists_);
  }
  if (!(dt > 0)) {
    const AlignedVector<double> none(layout_.size, 0.0);
    std::fill(resultant_.begin(), resultant_.end(), 0.0);  // stiffness() has used it
    forces_at_rest(none.data(), v, f, viscous);
    grip_at_start_ = grip_;
    if (std::any_of(u, u + layout_.size, [](double x) { return x != 0; }))
      advance(u, u, {large_ ? 0.5 : 0.0, 1.0}, 0);
    forces_at_rest(u, v, f, viscous);
    return;
  }
  if (large_ && (fluid_ || (flows_ && flowed_)) && lists_.stale(u)) {
    lists_.search(u);
    flowed_ = false;
  }
  if (lists_.crowded()) return;  // trouble() says so
  size_records(lists_);
  const Step step{large_ ? 0.5 * dt : 0.0, dt};  // small motion: the undeformed positions
  advance(u, v, step, dt);
  passes(lists_, step, flowing_, f, viscous);
}

template <int dim>
BondLists& BondBody<dim>::undeformed_lists() const {
  if (!undeformed_) {
    undeformed_ = std::make_unique<BondLists>(particles_, layout_, kernel_.radius(), 0.0, !fluid_);
    undeformed_->search(AlignedVector<double>(layout_.size, 0.0).data());
  }
  size_records(*undeformed_);
  return *undeformed_;
}

/// One step of length 1 s at velocity x from the undeformed body, which is linear in x.
template <int dim>
void BondBody<dim>::stiffness(const double* x, double* y) const {
  BondLists& lists = undeformed_lists();
  lists.forget_misfits();
  lay_down_motion(lists, nullptr, x, 0);
  with_kernel([&]<class Spline>(Spline) {
    fluid_ ? gradients<Spline, true>(lists, 1) : gradients<Spline, false>(lists, 1);
  });
  for_blocks([&](std::size_t block) {
    Symmetric<Pack, dim> D;
    SmallStrain::strain<Pack, dim>(motion(block), D);
    Symmetric<Pack, dim> s = elastic_.stress(D);
    for (int k = 0; k < n; ++k) s[k] *= undeformed(block);
    set_resultant(block, s);
  });
  passes(lists, {0, 1}, false, y, nullptr);
  for (std::size_t i = 0; i < layout_.size; ++i) y[i] = -y[i];
}

template <int dim>
void BondBody<dim>::damping_matrix(const double* x, double* y) const {
  BondLists& lists = undeformed_lists();
  lay_down_motion(lists, nullptr, x, 0);
  with_kernel([&]<class Spline>(Spline) { damping<Spline>(lists, y); });
}

template <int dim>
double BondBody<dim>::spring_energy() const {
  if (fluid_ || !lists_.searched()) return 0;
  double sum = 0;
  auto& lists = const_cast<BondLists&>(lists_);
  for (std::size_t block = 0; block < blocks_; ++block) {
    const BondLists::Bonds bonds = lists.bonds(block);
    Pack energy{};
    for (std::ptrdiff_t k = 0; k < bonds.end - bonds.index; k += lanes) {
      const Pack q = load<Pack>(bonds.misfit + k), eta = load<Pack>(bonds.eta + k);
      const Pack s = kernel_.kind() == KernelKind::wendland_c2 ? WendlandC2::steepness(eta / kernel_.h())
                                                               : CubicSpline::steepness(eta / kernel_.h());
      energy += load<Pack>(bonds.volumes + k) * spring_weight(s, eta / kernel_.h()) * q * q;
    }
    sum += horizontal_sum(part(block) * energy);
  }
  return 0.25 * spring_ * kernel_.steepness_factor() * sum;  // both halves of each bond are in the sum
}

template <int dim>
double BondBody<dim>::forgotten_energy() const {
  double sum = 0;
  for (const double x : forgotten_) sum += x;
  return 0.25 * sum;  // both halves, of twice the energy
}

template <int dim>
void BondBody<dim>::state(Archive& archive) {
  material_archive(archive);
  archive("flowed since search", flowed_);
  archive("forgotten", forgotten_);
  archive("grip at start", grip_at_start_);
  archive.below("bonds", [&] { lists_.state(archive); });
  if (archive.restoring() && lists_.searched()) size_records(lists_);
}

template <int dim>
std::optional<Trouble> BondBody<dim>::trouble(const double* u) const {
  if (!lists_.crowded()) return std::nullopt;
  return heap_trouble(place_now(*lists_.crowded(), u));
}

/// The square of the highest frequency is bounded by that of the gradient, which grows with the law's moduli
/// and with W_i |B_i|, W_i = sum_j K_j w_ij (the inequality of Cauchy and Schwarz for L), and by that of the
/// stress: with a displacement that alternates from particle to particle, to which L is blind, the forces
/// w_ij (K_j Q_i + K_i Q_j) r turn back by 4 W_i |sigma_i B_i| / rho. Of the undeformed lattice the first is
/// about 3.3 (lambda + 2 mu) W |B| / rho, springs included.
template <int dim>
std::optional<Stiffening> BondBody<dim>::stiffening(const double* u) const {
  if (!large_) return std::nullopt;
  AlignedVector<double> ratio(blocks_ * lanes, 1.0);
  const bool known = !grip_at_start_.empty();
  for (std::size_t i = 0; known && i < particles_.size(); ++i)
    if (grip_at_start_[i] > 0) ratio[i] = grip_[i] / grip_at_start_[i];
  stiffen(ratio);
  const double modulus = (elastic_.lambda + 2 * elastic_.mu) * thickness_;
  for (std::size_t i = 0; known && !fluid_ && i < particles_.size(); ++i)
    if (grip_at_start_[i] > 0) ratio[i] += 4 / 3.3 * tension_[i] / (volume_[i] * modulus * grip_at_start_[i]);
  std::size_t most = 0;
  for (std::size_t i = 1; i < particles_.size(); ++i)
    if (!(ratio[i] <= ratio[most])) most = i;
  return Stiffening{ratio[most] == ratio[most] ? ratio[most] : std::numeric_limits<double>::infinity(),
                    "particle " + std::to_string(most), place_now(most, u)};
}

}  // namespace femsph::sph
