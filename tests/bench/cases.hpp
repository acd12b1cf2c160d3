#pragma once
// What is measured: a body, a method, and what happens to it.

#include <functional>
#include <string>
#include <vector>

#include "compare/run/run.hpp"

namespace femsph::bench {

/// How many of the points yield in a step.
enum class Yield { elastic, idle, tenth, all };  ///< idle: a plastic law, and nothing yields

struct Case {
  std::string name;
  int dim;
  compare::Method method;
  double target = 0;  ///< ns a unit and step; 0: none
  Yield yield = Yield::elastic;
  bool large_motion = false;
  Plane plane = Plane::stress;  ///< of a 2D case
  double units = 1e5;           ///< about
  std::string without{};        ///< of an effect: the case that lacks it
  std::function<void(Scene&)> change{};
  bool moving = false;  ///< particles move through each other's supports: neighbours are searched again
};

/// A steel body of 10 x 1 (x 1), held at x-, and the spacing that gives `units` cells. It is loaded across at
/// x+, or, with `pull` (strain a second), stretched along x, uniformly from the first step on.
Scene scene_of(const Case& c, double& spacing, double pull = 0);

std::vector<Case> targets();  ///< with a target each
std::vector<Case> methods();  ///< every method, elastic
std::vector<Case> effects();  ///< each with its `without` before it

}  // namespace femsph::bench
