#include "model/scene/quantities.hpp"

namespace femsph {

bool on_material(Quantity q) { return q != Quantity::displacement && q != Quantity::velocity; }
bool is_scalar(Quantity q) { return q == Quantity::plastic_strain || q == Quantity::equivalent_stress; }

std::vector<std::string> component_names(Quantity quantity, int dim) {
  if (is_scalar(quantity)) return {"equivalent"};
  if (quantity == Quantity::principal_stress) return {"1", "2", "3"};
  if (on_material(quantity)) {
    if (dim == 2) return {"xx", "yy", "zz", "xy"};
    return {"xx", "yy", "zz", "xy", "yz", "zx"};
  }
  if (dim == 2) return {"x", "y"};
  return {"x", "y", "z"};
}

std::string unit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::displacement:
      return "m";
    case Quantity::velocity:
      return "m/s";
    case Quantity::stress:
    case Quantity::equivalent_stress:
    case Quantity::principal_stress:
      return "Pa";
    case Quantity::strain:
    case Quantity::plastic_strain:
      break;
  }
  return "1";
}

}  // namespace femsph
