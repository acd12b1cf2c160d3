#pragma once
// Shapes of undeformed bodies: which points lie inside, which lie on a side. They know nothing of particles
// and elements. A new shape is one file in this folder (its class, its keys and their reading) and its name
// in the list of shapes.cpp. SPH can fill a shape that has contains() and the bounding box; the other
// functions have defaults.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/numerics/tensor.hpp"

namespace femsph {

/// A mesh of quadrilaterals or hexahedra with named parts of its boundary.
struct CellMesh {
  int dim = 2;
  std::vector<Point> vertices;            ///< m
  std::vector<std::array<int, 8>> cells;  ///< 4 or 8 vertices, lexicographic: x fastest, then y, then z
  struct Facet {
    std::array<int, 4> vertices;  ///< 2, or 4 in lexicographic order
    int group;                    ///< index into groups, -1: unnamed
  };
  std::vector<Facet> facets;  ///< boundary facets that belong to a physical group
  /// Names of the physical groups of facets, or their numbers where a name is ambiguous.
  std::vector<std::string> groups;
  /// Numbers in the mesh file, for messages; empty if there is no file.
  std::vector<std::size_t> cell_numbers, vertex_numbers;
  /// The words by which a place can refer to a group: a name or a number, and its index into groups.
  std::vector<std::pair<std::string, int>> group_words;
  /// Names and numbers in the file that no place can use, and the reason.
  std::vector<std::pair<std::string, std::string>> unusable_words;
};

/// A small piece of a shape's boundary.
struct SidePiece {
  Point at{};       ///< m, its middle
  double size = 0;  ///< m, or m^2 in 3D
  Point area{};     ///< outward area vector, of length `size`; 0 for a piece inside of the body
};

class Box;
class StructuredShape;
class RigidForm;

class Shape {
 public:
  virtual ~Shape() = default;
  virtual int dim() const = 0;
  virtual Point lower() const = 0;  ///< corners of the bounding box, m
  virtual Point upper() const = 0;
  /// Whether p lies inside or on the boundary, up to `tolerance` (m).
  virtual bool contains(const Point& p, double tolerance) const = 0;
  /// Names of the boundary's parts. Every shape has the sides of its bounding box: x- x+ y- y+ (z- z+).
  virtual std::vector<std::string> sides() const;
  /// Whether p lies on that side, up to `tolerance` (m). Throws std::invalid_argument if it is not one of
  /// sides().
  virtual bool on_side(const std::string& side, const Point& p, double tolerance) const;
  /// Area (volume in 3D) of the shape, m^2 (m^3).
  virtual double measure() const = 0;
  virtual Point centroid() const = 0;  ///< m
  /// A side cut into pieces no longer than `size` (m), for a filling whose particles do not lie on the side.
  /// Empty for a plane side of the bounding box, for which on_side() is enough, and for a side that is a
  /// point.
  virtual std::vector<SidePiece> side_pieces(const std::string& side, double size) const;
  /// Whether the sides besides those of the bounding box are the whole boundary.
  virtual bool names_whole_boundary() const { return cells() != nullptr; }
  /// The shape itself if it is a box, else null.
  virtual const Box* box() const { return nullptr; }
  bool is_box() const { return box() != nullptr; }
  /// Whether it has curved sides.
  virtual bool is_round() const { return false; }
  /// Whether it touches each side of its bounding box in one point.
  virtual bool touches_sides_in_points() const { return false; }
  /// The mesh of a shape that is given by one, else null.
  virtual const CellMesh* cells() const { return nullptr; }
  /// The shape itself if it can cut itself into cells for both solvers, else null.
  virtual const StructuredShape* structured() const { return nullptr; }
  /// Cells for FEM, of the size (upper - lower) / divisions along each axis; none if the shape cannot be cut.
  /// (FEM cuts a box itself.)
  virtual std::optional<CellMesh> cut(const std::array<int, 3>& divisions) const;
  /// The shape as that of a rigid body; null if it cannot be one.
  virtual const RigidForm* rigid() const { return nullptr; }
  /// One line for the user: "box 1000 x 100 mm".
  virtual std::string describe() const = 0;
};

}  // namespace femsph
