#pragma once
// Shapes of bodies. A shape answers questions about points; it knows no particles and no elements.
// A new shape is one file in this folder (its class, its keys and their reading) and its name in the list of
// shapes.cpp. SPH fills it through contains() alone; whatever else a shape can do has a default here.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
  /// Of facets: their physical names, or their numbers where a name could mean two things.
  std::vector<std::string> groups;
  /// Those of the file, for messages; empty: there is no file.
  std::vector<std::size_t> cell_numbers, vertex_numbers;
  /// What a place may call a group: a name or a number, and an index into groups.
  std::vector<std::pair<std::string, int>> group_words;
  /// Names and numbers of the file that no place can use, and why.
  std::vector<std::pair<std::string, std::string>> vain_words;
};

/// A small piece of a shape's boundary.
struct SidePiece {
  Point at{};       ///< m, its middle
  double size = 0;  ///< m, or m^2 in 3D
  Point area{};     ///< outward, of length `size`; 0 where the body goes on behind it
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
  /// side_pieces() of the named sides, those of the bounding box aside, are the whole boundary.
  virtual bool names_whole_boundary() const { return cells() != nullptr; }
  /// Itself, if it is its bounding box.
  virtual const Box* box() const { return nullptr; }
  bool is_box() const { return box() != nullptr; }
  /// It has curved sides.
  virtual bool is_round() const { return false; }
  /// It touches each side of its bounding box in one point.
  virtual bool touches_sides_in_points() const { return false; }
  /// The body's own cells, if it comes with some.
  virtual const CellMesh* cells() const { return nullptr; }
  /// Itself, if it can cut itself into cells that both solvers take.
  virtual const StructuredShape* structured() const { return nullptr; }
  /// Cells for FEM, about (upper - lower) / divisions along each axis; none if it cannot be cut. (FEM cuts a
  /// box by itself.)
  virtual std::optional<CellMesh> cut(const std::array<int, 3>& divisions) const;
  /// What contact asks of a rigid body; null if the shape cannot be one.
  virtual const RigidForm* rigid() const { return nullptr; }
  /// One line for the user: "box 1000 x 100 mm".
  virtual std::string describe() const = 0;
};

}  // namespace femsph
