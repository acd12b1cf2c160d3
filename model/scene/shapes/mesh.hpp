#pragma once

#include "model/numerics/box_grid.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph {

/// A body whose cells were made by Gmsh.
class MeshShape final : public Shape {
 public:
  /// `file` is for describe() only.
  MeshShape(CellMesh mesh, std::string file);
  int dim() const override { return mesh_.dim; }
  Point lower() const override { return lower_; }
  Point upper() const override { return upper_; }
  bool contains(const Point& p, double tolerance) const override;
  std::vector<std::string> sides() const override;  ///< the bounding box's, and the physical groups
  bool on_side(const std::string& side, const Point& p, double tolerance) const override;
  double measure() const override;
  Point centroid() const override;
  std::vector<SidePiece> side_pieces(const std::string& side, double size) const override;
  const CellMesh* cells() const override { return &mesh_; }
  std::string describe() const override;

 private:
  CellMesh mesh_;
  std::string file_;
  Point lower_, upper_;
  BoxGrid cell_grid_, facet_grid_;
};

/// What the scene says of a mesh that would be a mistake elsewhere.
struct MeshWish {
  int pieces = 1;           ///< how many the cells form, joined by their sides
  bool open_seams = false;  ///< sides that lie on each other without sharing vertices are meant: a crack
};

/// Reads a .msh file (quadrilaterals in 2D, hexahedra in 3D; lengths multiplied by `unit`) and looks at all
/// of it once, see mesh_check.hpp. Throws std::runtime_error with one sentence when the file cannot be read,
/// holds no such cells, or could be read in two ways.
CellMesh read_gmsh(const std::string& file, int dim, double unit, const MeshWish& wish = {});

}  // namespace femsph
