#pragma once
// Saves and restores state. A class that carries state lists its variables once, in `void state(Archive& a)`;
// the archive then saves or restores their values. All values are doubles or integers of eight bytes, so that
// a file of them is plain HDF5.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace femsph {

/// The number of doubles in a T; 0 if it is no array of doubles.
template <class T>
inline constexpr std::size_t doubles_in = std::is_same_v<T, double> ? 1 : 0;
template <std::size_t n>
inline constexpr std::size_t doubles_in<std::array<double, n>> = n;

class Archive {
 public:
  virtual ~Archive() = default;
  /// Whether values are restored; else they are saved.
  bool restoring() const { return restoring_; }

  void operator()(std::string_view name, double& value) { block(name, Kind::real, &value, 1); }
  /// bool, int, long, std::size_t, ..
  template <std::integral T>
  void operator()(std::string_view name, T& value) {
    std::int64_t whole = std::int64_t(value);
    block(name, Kind::whole, &whole, 1);
    value = T(whole);
  }
  template <std::size_t n>
  void operator()(std::string_view name, std::array<double, n>& values) {
    block(name, Kind::real, values.data(), n);
  }
  template <std::size_t n>
  void operator()(std::string_view name, std::array<bool, n>& values) {
    std::array<std::int64_t, n> whole;
    for (std::size_t i = 0; i < n; ++i) whole[i] = values[i];
    block(name, Kind::whole, whole.data(), n);
    for (std::size_t i = 0; i < n; ++i) values[i] = whole[i] != 0;
  }
  /// std::vector or AlignedVector of doubles, Points or integers. A restored vector has the length that was
  /// saved.
  template <class T, class A>
  void operator()(std::string_view name, std::vector<T, A>& values) {
    if constexpr (std::integral<T>) {
      std::vector<std::int64_t> whole(values.begin(), values.end());
      whole.resize(length(name, whole.size()));
      block(name, Kind::whole, whole.data(), whole.size());
      if (restoring_) {
        values.resize(whole.size());
        for (std::size_t i = 0; i < whole.size(); ++i) values[i] = T(whole[i]);
      }
    } else {
      static_assert(doubles_in<T> > 0,
                    "an archive holds doubles, arrays of them, and whole numbers; see each() for structures");
      const std::size_t n = length(name, values.size() * doubles_in<T>);
      if (restoring_) values.resize(n / doubles_in<T>);
      block(name, Kind::real, values.data(), values.size() * doubles_in<T>);
    }
  }
  /// One member of every element of a vector, whose length does not change: a.each("plastic", trusses,
  /// [](auto& t) -> double& { return t.state.plastic; })
  template <class S, class A, class Member>
  void each(std::string_view name, std::vector<S, A>& structures, Member&& member) {
    using Value = std::decay_t<std::invoke_result_t<Member, S&>>;
    std::vector<std::conditional_t<std::is_same_v<Value, bool>, int, Value>> values;
    values.reserve(structures.size());
    for (S& s : structures) values.push_back(std::invoke(member, s));
    (*this)(name, values);
    if (values.size() != structures.size()) misfit(name);
    if (restoring_)
      for (std::size_t i = 0; i < values.size(); ++i) std::invoke(member, structures[i]) = Value(values[i]);
  }
  /// The names in `visit` are within the name `name`: "beam/stress".
  template <class Visit>
  void below(std::string_view name, Visit&& visit) {
    const std::size_t before = path_.size();
    path_.append(name).push_back('/');
    visit();
    path_.resize(before);
  }

 protected:
  enum class Kind { real, whole };
  explicit Archive(bool restoring) : restoring_(restoring) {}
  /// Saves `count` values of eight bytes from `data`, or restores them there.
  virtual void block(std::string_view name, Kind kind, void* data, std::size_t count) = 0;
  /// The number of values of the next block; `now` when saving.
  virtual std::size_t length(std::string_view name, std::size_t now) = 0;
  /// Throws std::runtime_error: the saved state does not fit the object.
  [[noreturn]] void misfit(std::string_view name) const;
  const std::string& path() const { return path_; }

 private:
  bool restoring_;
  std::string path_;
};

/// An archive in memory. Saving again reuses its memory.
class MemoryArchive {
 public:
  template <class Visited>
  void save(Visited& visited) {
    bytes_.clear();
    Pass pass(bytes_, false);
    visited.state(pass);
  }
  template <class Visited>
  void restore(Visited& visited) {
    Pass pass(bytes_, true);
    visited.state(pass);
  }
  bool empty() const { return bytes_.empty(); }
  std::size_t bytes() const { return bytes_.capacity(); }

 private:
  class Pass final : public Archive {
   public:
    Pass(std::vector<char>& bytes, bool restoring) : Archive(restoring), bytes_(bytes) {}

   private:
    void block(std::string_view name, Kind kind, void* data, std::size_t count) override;
    std::size_t length(std::string_view name, std::size_t now) override;
    std::vector<char>& bytes_;
    std::size_t at_ = 0;
  };
  std::vector<char> bytes_;
};

}  // namespace femsph
