#pragma once

#include <cstddef>

namespace femsph {

/// A share of something that belongs to one point.
struct Weight {
  std::size_t point;
  double weight;
};

}  // namespace femsph
