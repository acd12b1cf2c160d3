#pragma once
// The geometry of a place of a scene: how large it is, and which points lie on it.

#include "model/scene/scene.hpp"

namespace femsph {

/// A point within this distance (m) of a shape's boundary counts as on it: 1e-6 of the diagonal of the
/// bounding box, far above rounding errors and far below any spacing.
double point_tolerance(const Shape& shape);

/// The part of a box that a place covers: the whole box, cut to the place's sides and to its region `within`.
Region part_of(const Shape& box, const Place& place);

/// By how many dimensions a place is smaller than its body. 0: the whole body; 1: a side; 2: an edge (in a
/// plane a corner or a point); 3: a corner or a point in space.
int codimension(const Scene& scene, const Place& place);

/// Whether the point p (m, undeformed) lies within `reach` (m) of the place, or within point_tolerance().
bool at_place(const Scene& scene, const Place& place, const Point& p, double reach);

}  // namespace femsph
