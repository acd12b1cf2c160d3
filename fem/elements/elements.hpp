#pragma once
// The list of elements. A new element is one header in this folder (element.hpp says what it states), which
// is included here, and its name in `Elements`. From the list follow the methods "fem-WORD", `femsph list`
// and the loops.

#include <cstddef>

#include "fem/elements/assumed_strain.hpp"
#include "fem/elements/full.hpp"
#include "fem/elements/one_point.hpp"
#include "fem/elements/sri.hpp"

namespace femsph::fem {

template <class... ElementType>
struct ElementList {
  static constexpr std::size_t size = sizeof...(ElementType);
};

/// In the order of `femsph list`.
using Elements = ElementList<FullElement, SriElement, OnePointElement, AssumedStrainElement>;

}  // namespace femsph::fem
