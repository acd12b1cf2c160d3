#include "sph/operators/stencils.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <unordered_map>

namespace femsph::sph {

/// Merges the rows of eight particles: neighbours at the same offset with the same weights become one slot.
template <int dim>
auto LatticeStencils<dim>::slots_of_block(const RowSource& rows, std::size_t block, std::size_t particles,
                                          Row& scratch) const -> std::vector<Slot> {
  std::vector<Slot> slots;
  for (int l = 0; l < lanes && block * lanes + std::size_t(l) < particles; ++l) {
    const std::size_t i = block * lanes + std::size_t(l);
    rows.row(i, scratch);
    for (const Neighbour& n : scratch) {
      Slot s;
      std::memset(&s, 0, sizeof s);
      for (int a = 0; a < dim; ++a)
        s.w[a] = n.w[a] + 0.0;  // -0 becomes 0, so that equal weights have equal bits
      s.scale = n.scale;
      s.offset = n.index - std::int32_t(i);
      s.mask = 1u << l;
      const auto same = std::find_if(slots.begin(), slots.end(), [&](const Slot& t) {
        return t.offset == s.offset && std::memcmp(t.w, s.w, sizeof s.w) == 0 &&
               std::memcmp(&t.scale, &s.scale, sizeof s.scale) == 0;
      });
      if (same != slots.end())
        same->mask |= s.mask;
      else
        slots.push_back(s);
    }
  }
  std::stable_sort(slots.begin(), slots.end(), [](const Slot& a, const Slot& b) {
    const int ga = group_of(a), gb = group_of(b);
    return ga != gb ? ga < gb : a.offset < b.offset;
  });
  return slots;
}

template <int dim>
LatticeStencils<dim>::LatticeStencils(const RowSource& rows, std::size_t particles) {
  const std::size_t blocks = (particles + lanes - 1) / lanes;
  descriptor_of_.resize(blocks);
  std::unordered_map<std::string, std::uint32_t> known;
  Row scratch;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::vector<Slot> slots = slots_of_block(rows, b, particles, scratch);
    const std::string key(reinterpret_cast<const char*>(slots.data()), slots.size() * sizeof(Slot));
    const auto [entry, is_new] = known.try_emplace(key, std::uint32_t(descriptors_.size()));
    descriptor_of_[b] = entry->second;
    if (!is_new) continue;
    Descriptor d;
    std::size_t k = 0;
    for (int g = 0; g <= groups; ++g) {
      while (k < slots.size() && group_of(slots[k]) < g) ++k;
      d.begin[g] = std::uint32_t(slots_.size() + k);
    }
    d.begin[groups] = std::uint32_t(slots_.size() + slots.size());
    descriptors_.push_back(d);
    slots_.insert(slots_.end(), slots.begin(), slots.end());
    for (const Slot& s : slots) reach_ = std::max(reach_, std::size_t(std::abs(s.offset)));
  }
}

template <int dim>
std::size_t LatticeStencils<dim>::bytes() const {
  return slots_.size() * sizeof(Slot) + descriptors_.size() * sizeof(Descriptor) +
         descriptor_of_.size() * sizeof(std::uint32_t);
}

template <int dim>
ListStencils<dim>::ListStencils(const RowSource& rows, std::size_t particles) {
  const std::size_t blocks = (particles + lanes - 1) / lanes;
  begin_.push_back(0);
  Row row[lanes];
  for (std::size_t b = 0; b < blocks; ++b) {
    std::size_t most = 0;
    for (int l = 0; l < lanes; ++l) {
      row[l].clear();
      const std::size_t i = b * lanes + std::size_t(l);
      if (i < particles) rows.row(i, row[l]);
      most = std::max(most, row[l].size());
    }
    for (std::size_t k = 0; k < most; ++k) {
      for (int l = 0; l < lanes; ++l)  // a lane with fewer neighbours reads itself, with weight 0
        index_.push_back(k < row[l].size()
                             ? row[l][k].index
                             : std::int32_t(std::min(b * lanes + std::size_t(l), particles - 1)));
      for (int a = 0; a <= dim; ++a)
        for (int l = 0; l < lanes; ++l)
          weight_.push_back(k >= row[l].size() ? 0.0 : a < dim ? row[l][k].w[a] : row[l][k].scale);
    }
    begin_.push_back(begin_.back() + most);
  }
}

template <int dim>
std::size_t ListStencils<dim>::bytes() const {
  return begin_.size() * sizeof(std::size_t) + index_.size() * sizeof(std::int32_t) +
         weight_.size() * sizeof(double);
}

template class LatticeStencils<1>;  // for one value per particle: mean_dilatation.hpp
template class ListStencils<1>;
template class LatticeStencils<2>;
template class LatticeStencils<3>;
template class ListStencils<2>;
template class ListStencils<3>;

}  // namespace femsph::sph
