#include "fem/elements/compile_loops.hpp"

namespace femsph::fem {

namespace {

template <class... ElementType>
std::unique_ptr<CellLoop> controlled_in_list(ElementList<ElementType...>, std::size_t number,
                                             const LoopInput& in) {
  std::unique_ptr<CellLoop> loop;
  std::size_t k = 0;
  const auto choose = [&]<class Type>() {
    if constexpr (requires { typename Type::Controlled; })
      if (k == number) loop = choose_loop<typename Type::Controlled>(in);
    ++k;
  };
  (choose.template operator()<ElementType>(), ...);
  return loop;
}

}  // namespace

std::unique_ptr<CellLoop> controlled_loop(std::size_t number, const LoopInput& in) {
  return controlled_in_list(Elements{}, number, in);
}

}  // namespace femsph::fem
