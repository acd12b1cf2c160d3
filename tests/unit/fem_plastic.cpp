// A plastic body under a uniform stretch has the stress of its law at every quadrature point of every
// element, however it is turned.

#include <gtest/gtest.h>

#include "fem_scalar_loop.hpp"
#include "fem_support.hpp"
#include "plastic_cases.hpp"

namespace femsph::test {
namespace {

std::unique_ptr<Discretization> plastic_body(Plane plane, bool large, Element element, bool scalar = false) {
  Scene s = box_scene(plane, {0.08, 0.06, 0.05});
  s.large_motion = large;
  s.materials.at("m").parameters = Plasticity{300e6, 210e9 / 99};
  fem::Options o;
  o.element = element;
  o.divisions = {3, 3, 3};
  o.distortion = 0.2;
  if (scalar) o.loop = make_scalar_loop;
  return fem::discretize(s, 0, o);
}

Law law_of(Plane plane) { return Plastic{LinearElastic::make(210e9, 0.3, 7850, plane), {300e6, 210e9 / 99}}; }

TEST(FemPlastic, UniformStretchGivesTheStressOfTheLaw) {
  for (Element element : all_elements)
    for (Plane plane : {Plane::stress, Plane::strain, Plane::none})
      for (bool large : {false, true})
        for (bool scalar : {false, true})
          expect_stress_of_law(*plastic_body(plane, large, element, scalar), law_of(plane), plane, large,
                               0.08 * 0.06 * (plane == Plane::none ? 0.05 : 1));
}

TEST(FemPlastic, TurningTheBodyChangesNothing) {
  for (Element element : all_elements)
    for (Plane plane : {Plane::stress, Plane::none})
      expect_turning_changes_nothing(*plastic_body(plane, true, element));
}

}  // namespace
}  // namespace femsph::test
