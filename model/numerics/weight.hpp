#pragma once

#include <cstddef>

namespace femsph {

/// A point and its weight in a sum.
struct Weight {
  std::size_t point;
  double weight;
};

}  // namespace femsph
