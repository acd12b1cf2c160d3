#pragma once
// The memory that a run needs, estimated before any particles or mesh are made.

#include "compare/run/run.hpp"

namespace femsph::compare {

struct Size {
  double units = 0;  ///< particles or elements, of all bodies
  double bytes = 0;  ///< at the peak: while particles or mesh are made, or fields are written
};

/// An estimate of the order of magnitude, from the volumes of the shapes and the spacing.
Size estimated_size(const Scene& scene, const BodyMethods& methods, const Resolution& resolution);

/// Bytes that this process can still allocate: the smaller of what the machine (/proc/meminfo) and the
/// control group of the process allow. Infinity if neither is known.
double available_memory();

/// Throws std::runtime_error with the estimate and the finest spacing that fits, if the run needs more than
/// `available` bytes or more units than the program supports.
void refuse_excess(const Scene& scene, const BodyMethods& methods, const Resolution& resolution,
                   double available = available_memory());

}  // namespace femsph::compare
