#pragma once
// Shapes of bodies. A shape answers questions about points; it knows no particles and no elements.
// A new shape is one class here and one entry in shape_reader.cpp; SPH fills it through contains() alone.

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/numerics/box_grid.hpp"
#include "model/numerics/tensor.hpp"

namespace femsph {

/// Quadrilaterals or hexahedra with named boundary parts: a body that comes with its own cells.
struct CellMesh {
  int dim = 2;
  std::vector<Point> vertices;            ///< m
  std::vector<std::array<int, 8>> cells;  ///< 4 or 8 vertices, lexicographic: x fastest, then y, then z
  struct Facet {
    std::array<int, 4> vertices;  ///< 2, or 4 in lexicographic order
    int group;                    ///< index into groups, -1: unnamed
  };
  std::vector<Facet> facets;  ///< boundary facets that the file names
  std::vector<std::string>
      groups;  ///< of facets: their physical names, or their numbers where a name could mean two things
  std::vector<std::size_t> cell_numbers,
      vertex_numbers;  ///< those of the file, for messages; empty: there is no file
  std::vector<std::pair<std::string, int>>
      group_words;  ///< what a place may call a group: a name or a number, an index into groups
  std::vector<std::pair<std::string, std::string>>
      vain_words;  ///< names and numbers of the file that no place can use, and why
};

/// A small piece of a shape's boundary.
struct SidePiece {
  Point at{};       ///< m, its middle
  double size = 0;  ///< m, or m^2 in 3D
  Point area{};     ///< outward, of length `size`; 0 where the body goes on behind it
};

class Shape {
 public:
  virtual ~Shape() = default;
  virtual int dim() const = 0;
  virtual Point lower() const = 0;  ///< corners of the bounding box, m
  virtual Point upper() const = 0;
  /// Inside or on the boundary, up to `tolerance` (m).
  virtual bool contains(const Point& p, double tolerance) const = 0;
  /// Names of the boundary's parts. Every shape has the sides of its bounding box: x- x+ y- y+ (z- z+).
  virtual std::vector<std::string> sides() const;
  /// p lies on that side, up to `tolerance` (m). The side is one of sides().
  virtual bool on_side(const std::string& side, const Point& p, double tolerance) const;
  /// Area (volume in 3D) of the shape, m^2 (m^3).
  virtual double measure() const = 0;
  virtual Point centroid() const = 0;  ///< m
  /// A curved or slanted side cut into pieces no longer than `size` (m): what a filling that misses the side
  /// needs to know of it. Empty for a side that on_side() tells alone, such as a plane side of the bounding
  /// box, or one that is a point.
  virtual std::vector<SidePiece> side_pieces(const std::string& side, double size) const;
  /// The body's own cells, if it comes with some.
  virtual const CellMesh* cells() const { return nullptr; }
  /// One line for the user: "box 1000 x 100 mm".
  virtual std::string describe() const = 0;
};

/// An axis-parallel rectangle or cuboid.
class Box final : public Shape {
 public:
  Box(int dim, Point origin, Point size) : dim_(dim), origin_(origin), size_(size) {}
  int dim() const override { return dim_; }
  Point lower() const override { return origin_; }
  Point upper() const override;
  bool contains(const Point& p, double tolerance) const override;
  double measure() const override;
  Point centroid() const override;
  std::string describe() const override;
  const Point& size() const { return size_; }

 private:
  int dim_;
  Point origin_, size_;
};

/// A disc or a sphere.
class Ball final : public Shape {
 public:
  Ball(int dim, Point centre, double radius) : dim_(dim), centre_(centre), radius_(radius) {}
  int dim() const override { return dim_; }
  Point lower() const override;
  Point upper() const override;
  bool contains(const Point& p, double tolerance) const override;
  double measure() const override;
  Point centroid() const override;
  std::string describe() const override;
  const Point& centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  int dim_;
  Point centre_;
  double radius_;
};

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
