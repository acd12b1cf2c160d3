// Classic SPH: the uncorrected gradient sum_j V_j (u_j - u_i) (x) grad W_ij, as in the paper (studies/paper).
// In small motion on the initial neighbours (total_lagrangian.hpp), in large motion on neighbours that follow
// the particles (updated_lagrangian.hpp).

#include <algorithm>

#include "sph/formulations/discretize.hpp"
#include "sph/operators/gradient_operator.hpp"

namespace femsph::sph {

namespace {

Variant classic_variant(const char* word, const char* about, MassRule mass,
                        Boundary boundary = Boundary::none) {
  Options options;
  options.mass = mass;
  options.boundary = boundary;
  return {word, about, options};
}

void check_classic(const Scene& scene, std::size_t body, const Options& options,
                   const std::vector<MirrorPlane>& planes) {
  const bool is_virtual = options.boundary == Boundary::virtual_particles;
  if (is_virtual && (!scene.bodies[body].shape->is_box() || options.jitter > 0))
    throw Refusal(
        "virtual particles mirror a regular lattice at the sides of a box; this body is not a box, or its "
        "particles have jitter");
  if (scene.large_motion && options.boundary != Boundary::none)
    throw Refusal(
        "virtual particles and boundary weights need the initial neighbours; a scene with large motion "
        "cannot use them");
  if (is_virtual && !planes.empty())
    throw Refusal(
        "virtual particles mirror every side of a box; a body with symmetry planes cannot use them");
  const bool has_bars = std::any_of(
      scene.bars.begin(), scene.bars.end(), [&](const Bar& bar) { return bar.body == body; });
  if (scene.large_motion && (has_bars || !planes.empty()))
    throw Refusal(
        "symmetry planes and bars need the initial neighbours; classic SPH with large motion cannot use "
        "them");
}

std::unique_ptr<Discretization> make_classic(const Scene& scene, std::size_t body, const Options& options,
                                             Particles particles, const Kernel& kernel) {
  if (scene.large_motion) return updated_lagrangian(scene, body, options, std::move(particles), kernel);
  const Correction correction = options.boundary == Boundary::weight ? Correction::matrix : Correction::none;
  return total_lagrangian(scene, body, options, std::move(particles), kernel, correction);
}

}  // namespace

Formulation classic_formulation() {
  return {
      .word = "classic",
      .corrected = false,
      .initial_neighbours = false,
      .viscosity = true,
      .bytes = {1500, 2000},
      .variants =
          {classic_variant(
               "classic-share",
               "uncorrected gradient, as in the paper; each particle's mass is its share of the body",
               MassRule::share),
           classic_variant(
               "classic-full", "the same, with the mass of a full cell for every particle", MassRule::full),
           classic_variant("classic-trapezoid", "the same, with half cells on sides and quarters on edges",
                           MassRule::trapezoid),
           // The mass rules of the next two are those that come nearest to figs 5 to 10 of the paper
           // (studies/uniaxial, studies/boundary).
           classic_variant("virtual", "uncorrected gradient with virtual particles outside the surface",
                           MassRule::trapezoid, Boundary::virtual_particles),
           classic_variant("weight", "uncorrected gradient with a weight for the missing neighbours",
                           MassRule::share, Boundary::weight)},
      .check = check_classic,
      .make = make_classic};
}

}  // namespace femsph::sph
