#pragma once

#include "model/numerics/box_grid.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph {

/// A body that is given by a mesh from Gmsh.
class MeshShape final : public Shape {
 public:
  /// `file` is for describe() only.
  MeshShape(CellMesh mesh, std::string file);
  int dim() const override { return mesh_.dim; }
  Point lower() const override { return lower_; }
  Point upper() const override { return upper_; }
  bool contains(const Point& p, double tolerance) const override;
  std::vector<std::string> sides() const override;  ///< those of the bounding box, and the physical groups
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

/// What the scene allows in a mesh that would be an error otherwise.
struct MeshOptions {
  int pieces = 1;           ///< number of sets of cells that are joined by common sides
  bool open_seams = false;  ///< sides may coincide without sharing vertices, as the faces of a crack
};

/// Reads a .msh file (quadrilaterals in 2D, hexahedra in 3D) and checks the mesh (mesh_check.hpp). `unit`:
/// the unit of the coordinates in m. Throws std::runtime_error with one sentence if the file cannot be read,
/// has other cells, or is ambiguous.
CellMesh read_gmsh(const std::string& file, int dim, double unit, const MeshOptions& options = {});

}  // namespace femsph
