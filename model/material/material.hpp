#pragma once
// A material of a scene, and the catalogue of laws without their kernels.

#include <string>
#include <vector>

#include "model/material/law.hpp"

namespace femsph {

/// A law for the reader of scenes, lists and messages.
struct LawEntry {
  Entry entry;
  std::vector<KeyTable> tables;  ///< tables within [materials.NAME]
  std::string name;              ///< name in messages
  bool large_motion_only, yields, has_bars;
  bool fluid;  ///< has neither "young" nor "poisson"
  LawParameters (*read)(Fields& fields, const LawInput& in);
  Law (*of)(const LawParameters& parameters, const ElasticConstants& constants, Plane plane);
  std::vector<std::string> (*effects)(const LawParameters& parameters);
  BarYield (*bar)(const LawParameters& parameters);
  const Plasticity* (*plasticity)(const LawParameters& parameters);
};

/// In the order of the alternatives of Law and LawParameters.
const std::vector<LawEntry>& laws();

struct Material {
  std::string name;
  double young, poisson, density;  ///< Pa, 1, kg/m^3; a fluid: 0, 1/2
  LawParameters parameters = {};   ///< linear elastic by default

  /// The law of this material in that plane.
  Law law(Plane plane) const { return entry().of(parameters, {young, poisson, density}, plane); }
  const LawEntry& entry() const { return laws()[parameters.index()]; }
  bool is_fluid() const { return entry().fluid; }
  bool is_linear_elastic() const { return std::holds_alternative<LinearElastic::Parameters>(parameters); }
  /// Whether its stress depends on the strain path.
  bool yields() const { return entry().yields; }
  /// Its von Mises plasticity; null if it has none.
  const Plasticity* plasticity() const { return entry().plasticity(parameters); }
  BarYield bar() const { return entry().bar(parameters); }
  std::vector<std::string> effects() const { return entry().effects(parameters); }
};

}  // namespace femsph
