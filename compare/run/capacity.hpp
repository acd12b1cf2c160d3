#pragma once
// Will it fit? Asked before any lattice or mesh is made.

#include "compare/run/run.hpp"

namespace femsph::compare {

struct Size {
  double units = 0;  ///< particles or elements, of all bodies
  double bytes = 0;  ///< at the peak: while particles or mesh are made, or fields are written
};

/// From the volumes of the shapes and the spacing alone: an estimate, made to be of the right size, not
/// exact.
Size estimated_size(const Scene& scene, const Method& method, const Resolution& resolution);

/// Bytes that this process could still get: of the machine (/proc/meminfo) and of the control group that it
/// runs in. Infinity if nothing says.
double available_memory();

/// Throws std::runtime_error with the estimate and the finest spacing that fits, if that is more than
/// `available` bytes or than indices can count.
void refuse_excess(const Scene& scene, const Method& method, const Resolution& resolution,
                   double available = available_memory());

}  // namespace femsph::compare
