#include "model/input/faults.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/input/lookup.hpp"

namespace femsph {
namespace {

std::vector<Fault> in_order(std::vector<Fault> faults) {
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  });
  constexpr std::size_t most = 1000;  // more are of no use
  if (faults.size() > most) faults.erase(faults.begin() + most, faults.end());
  return faults;
}

std::string message(const std::string& file, const std::vector<Fault>& faults) {
  std::string all;
  for (const Fault& fault : faults) {
    if (!all.empty()) all += '\n';
    all += fault.line > 0 ? fmt::format("{}:{}:{}: {}", file, fault.line, fault.column, fault.text)
                          : fmt::format("{}: {}", file, fault.text);
  }
  return all;
}

}  // namespace

InputError::InputError(const std::string& file, std::vector<Fault> faults)
    : std::runtime_error(message(file, in_order(faults))), faults_(in_order(std::move(faults))) {}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string out = "\"";
  for (const unsigned char c : text.substr(0, longest))
    out += c < 0x20 || c == 0x7f ? fmt::format("\\x{:02x}", c) : std::string(1, char(c));
  return out + (text.size() > longest ? "...\"" : "\"");
}

std::string one_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 40;
  std::string all;
  if (names.size() > most) {
    for (std::size_t i = 0; i < most; ++i) all += in_quotes(names[i]) + ", ";
    return fmt::format("{}.. (one of {})", all, names.size());
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    all += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + in_quotes(names[i]);
  return all;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const auto best = nearest_name(word, names);
  return best ? fmt::format("; did you mean {}?", in_quotes(*best)) : "";
}

}  // namespace femsph
