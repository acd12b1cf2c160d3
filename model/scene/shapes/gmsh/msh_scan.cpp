// Layout of the sections: Gmsh reference manual, "MSH file format" and its legacy versions.

#include "model/scene/shapes/gmsh/msh_scan.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "model/input/faults.hpp"

namespace femsph {
namespace {

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && (unsigned char)s.front() <= ' ') s.remove_prefix(1);
  while (!s.empty() && (unsigned char)s.back() <= ' ') s.remove_suffix(1);
  return s;
}

/// At most the first `most` integers of a line; ends at anything else.
std::vector<long long> integers(std::string_view line, std::size_t most) {
  std::vector<long long> all;
  while (all.size() < most) {
    line = trimmed(line);
    long long value = 0;
    const auto [end, status] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (status != std::errc()) break;
    line.remove_prefix(std::size_t(end - line.data()));
    if (!line.empty() && (unsigned char)line[0] > ' ') break;
    all.push_back(value);
  }
  return all;
}

class Scan {
 public:
  Scan(std::string_view text, const std::string& file, const std::function<int(int)>& corners_of)
      : text_(text), file_(file), corners_of_(corners_of) {}

  MshFacts facts() {
    for (std::string_view line = next(); !line.empty(); line = next()) {
      if (line[0] != '$' || line.starts_with("$End") || line.starts_with("$END")) continue;
      read_section(line);
      const std::string end = line == "$NOD"   ? "$ENDNOD"
                              : line == "$ELM" ? "$ENDELM"
                                               : "$End" + std::string(line.substr(1));
      const std::size_t at = text_.find(end, at_);
      if (at == std::string_view::npos) break;
      at_ = at;
    }
    return std::move(facts_);
  }

 private:
  /// The next line that is not blank, trimmed; empty at the end of the file.
  std::string_view next() {
    while (at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      const std::string_view line = trimmed(text_.substr(at_, end - at_));
      at_ = std::min(end + 1, text_.size());
      if (!line.empty()) return line;
    }
    return {};
  }

  void read_section(std::string_view name) {
    if (name == "$MeshFormat") {
      const std::string_view line = next();
      std::from_chars(line.data(), line.data() + line.size(), facts_.version);
      binary_ = line.find(" 1 ") != std::string_view::npos;
    } else if (name == "$PhysicalNames") {
      read_names();
    } else if (name == "$NOD" || name == "$Nodes" || name == "$ParametricNodes") {
      if (!binary_) read_nodes();
    } else if (name == "$ELM" || name == "$Elements") {
      binary_ ? read_binary_elements() : read_elements();
    }
  }

  void read_names() {
    const auto count = integers(next(), 1);
    for (long long i = 0; !count.empty() && i < count[0]; ++i) {
      const std::string_view line = next();
      const auto words = integers(line, 2);
      const std::size_t open = line.find('"'), close = line.rfind('"');
      if (line.empty() || line[0] == '$') return;
      if (words.size() == 2 && open < close && close != std::string_view::npos)
        facts_.names.push_back(
            {int(words[0]), int(words[1]), std::string(line.substr(open + 1, close - open - 1))});
    }
  }

  /// Calls act(line) for the lines of a section. In version 4 they come in blocks, each after a line that
  /// ends with its number of entries. Returns the number of entries that the section announces.
  template <class Act>
  long long for_each_line(const std::vector<long long>& head, long long lines_an_entry, Act&& act) {
    if (facts_.version < 4) {
      for (long long i = 0; i < head[0]; ++i)
        if (!at_section_end()) act(next());
      return head[0];
    }
    for (long long block = 0; block < head[0] && !at_section_end(); ++block) {
      const auto announced = integers(next(), 4);
      if (announced.size() < 4) return head[1];
      for (long long i = 0; i < lines_an_entry * announced[3] && !at_section_end(); ++i) act(next());
    }
    return head[1];
  }

  bool at_section_end() {
    const std::size_t before = at_;
    const std::string_view line = next();
    at_ = before;
    return line.empty() || line[0] == '$';
  }

  void read_nodes() {
    const auto head = integers(next(), 2);
    if (head.empty() || (facts_.version >= 4 && head.size() < 2)) return;
    const long long count = for_each_line(head, facts_.version >= 4.1 ? 2 : 1, [](std::string_view) {});
    require_end("nodes", count);
  }

  void read_elements() {
    const auto head = integers(next(), 2);
    if (head.empty() || (facts_.version >= 4 && head.size() < 2)) return;
    const long long count = for_each_line(head, 1, [&](std::string_view line) {
      const auto words = integers(
          line, 4);  // version 1: number, type, group; 2: number, type, how many tags, group
      facts_.numbers.push_back(words.empty() ? 0 : std::size_t(words[0]));
      if (!facts_.lists_groups()) return;
      const std::size_t group = facts_.version < 2 ? 2 : 3;
      const bool listed = words.size() > group && (facts_.version < 2 || words[2] > 0);
      facts_.groups.push_back(listed ? int(words[group]) : 0);
    });
    facts_.elements += std::size_t(std::max(0ll, count));
    require_end("elements", count);
  }

  void require_end(const char* what, long long count) {
    if (!at_section_end())
      throw std::runtime_error(fmt::format(
          "{} holds more {} than the {} that it announces; expected a mesh saved by Gmsh", in_quotes(file_),
          what, count));
  }

  template <class T>
  T take() {
    T value{};
    if (at_ + sizeof value > text_.size()) return at_ = text_.size(), value;
    std::memcpy(&value, text_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

  void read_binary_elements() {
    if (facts_.version >= 3) {
      if (facts_.version < 4) return;
      take<std::uint64_t>();  // blocks
      facts_.elements += std::size_t(take<std::uint64_t>());
      return;
    }
    const auto head = integers(next(), 1);
    const long long count = head.empty() ? 0 : head[0];
    facts_.elements += std::size_t(std::max(0ll, count));
    for (long long read = 0; read < count && at_ < text_.size();) {
      const auto type = take<std::int32_t>(), entries = take<std::int32_t>(), tags = take<std::int32_t>();
      if (entries < 1 || tags < 0) return;
      const int corners = corners_of_(type);
      for (int i = 0; i < entries && at_ < text_.size(); ++i, ++read) {
        facts_.numbers.push_back(std::size_t(take<std::int32_t>()));
        const auto group = tags > 0 ? take<std::int32_t>() : 0;
        facts_.groups.push_back(group);
        at_ += std::min(text_.size() - at_,
                        sizeof(std::int32_t) * (std::size_t(std::max(0, tags - 1)) + std::size_t(corners)));
      }
    }
  }

  std::string_view text_;
  const std::string& file_;
  const std::function<int(int)>& corners_of_;
  MshFacts facts_;
  std::size_t at_ = 0;
  bool binary_ = false;
};

}  // namespace

MshFacts scan_msh(const std::string& file, const std::function<int(int)>& corners_of) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return Scan(text, file, corners_of).facts();
}

}  // namespace femsph
