#pragma once
// Internal to results/: the XDMF description of the HDF5 files that FieldWriter writes.

#include <array>
#include <string>
#include <vector>

#include "model/motion/bodies/discretization.hpp"

namespace femsph::xdmf {

struct Field {
  const char* name;
  const char* type;  ///< XDMF's AttributeType
  std::size_t components;
  bool at_points;  ///< at nodes or particles; else one value for each cell, or particle of a body without
                   ///< cells
};

/// Tensors have nine components: of the six of XDMF's Tensor6 (xx xy xz yy yz zz), one of ParaView's readers
/// assumes the order of VTK (xx yy zz xy yz xz), while another reads them correctly.
inline constexpr std::array<Field, 6> fields{
    {{"displacement", "Vector", 3, true},
     {"velocity", "Vector", 3, true},
     {"stress", "Tensor", 9, false},
     {"strain", "Tensor", 9, false},
     {"equivalent_stress", "Scalar", 1, false},
     {"principal_stress", "Vector", 3, false}}};  // the largest first

inline constexpr Field plastic_strain{
    "plastic_strain", "Scalar", 1, false};  ///< equivalent; of bodies whose law has it

/// Stress and strain by the rule of results/recovery.hpp, at the points: the same reading for meshes and
/// particles.
inline constexpr std::array<Field, 4> recovered{
    {{"recovered_stress", "Tensor", 9, true},
     {"recovered_strain", "Tensor", 9, true},
     {"recovered_equivalent_stress", "Scalar", 1, true},
     {"recovered_principal_stress", "Vector", 3, true}}};
inline constexpr Field recovered_plastic_strain{"recovered_plastic_strain", "Scalar", 1, true};

struct Body {
  std::string name;
  Topology::Kind kind;
  std::size_t points, cells;
  bool plastic = false;  ///< has the field plastic_strain as well
  bool both = false;     ///< has the recovered fields as well
  /// Points of a cell; a body without cells is made of one-point cells (Polyvertex).
  std::size_t cell_points() const;
};

struct Frame {
  std::string file;  ///< relative to the XDMF file
  long step;
  double time;
  std::vector<std::size_t> bodies;
};

/// The group of a body in every HDF5 file, by number: a name may contain characters that are special in
/// paths.
std::string group(std::size_t body);

/// The whole document; geometry_file holds the groups' "points" and "cells", a frame's file their fields.
std::string document(const std::vector<Body>& bodies, const std::vector<Frame>& frames,
                     const std::string& geometry_file, const std::string& label = "fields");

}  // namespace femsph::xdmf
