#include "fem/elements/elements.hpp"

#include <algorithm>
#include <utility>

#include "fem/elements/loops.hpp"
#include "model/input/faults.hpp"
#include "model/input/lookup.hpp"

namespace femsph::fem {

namespace {

template <class ElementType>
ElementEntry entry_with_points() {
  ElementEntry entry = ElementType::entry;
  entry.points = {ElementType::template points<2>, ElementType::template points<3>};
  return entry;
}

template <class... ElementType>
std::vector<ElementEntry> entries_of(ElementList<ElementType...>) {
  return {entry_with_points<ElementType>()...};
}

template <std::size_t... source>
std::unique_ptr<CellLoop> loop_from_source(std::index_sequence<source...>, std::size_t number,
                                           const LoopInput& in) {
  using Make = std::unique_ptr<CellLoop> (*)(std::size_t, const LoopInput&);
  constexpr Make make[] = {loop_from<source>...};
  return make[number % loop_sources](number, in);
}

}  // namespace

const std::vector<ElementEntry>& elements() {
  static const std::vector<ElementEntry> all = entries_of(Elements{});
  return all;
}

const ElementEntry& element_named(const std::string& word) {
  return entry_named<Refusal>(elements(), word, &ElementEntry::word, "no element " + in_quotes(word));
}

std::unique_ptr<CellLoop> make_loop(const std::string& element, const LoopInput& in) {
  const ElementEntry& entry = element_named(element);
  const auto number = std::size_t(&entry - elements().data());
  if (in.hourglass && entry.hourglass_control) return controlled_loop(number, in);
  return loop_from_source(std::make_index_sequence<loop_sources>{}, number, in);
}

}  // namespace femsph::fem
