#pragma once
// Included by the sources loop_*.cpp alone.

#include <utility>

#include "fem/elements/cell_loop_impl.hpp"
#include "fem/elements/elements.hpp"
#include "fem/elements/loops.hpp"

namespace femsph::fem {

/// The loop of one of the elements source, source + loop_sources, .. of the list.
template <std::size_t source, class... ElementType>
std::unique_ptr<CellLoop> loop_in_list(ElementList<ElementType...>, std::size_t number, const LoopInput& in) {
  std::unique_ptr<CellLoop> loop;
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    const auto choose = [&]<class Type, std::size_t of>() {
      if constexpr (of % loop_sources == source)
        if (of == number) loop = choose_loop<Type>(in);
    };
    (choose.template operator()<ElementType, k>(), ...);
  }
  (std::index_sequence_for<ElementType...>{});
  return loop;
}

template <std::size_t source>
std::unique_ptr<CellLoop> loop_from(std::size_t number, const LoopInput& in) {
  return loop_in_list<source>(Elements{}, number, in);
}

}  // namespace femsph::fem
