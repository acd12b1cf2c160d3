// Reads and parses TOML files; safe for arbitrary bytes.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include "model/input/toml_fields.hpp"

namespace femsph {
namespace {

constexpr std::size_t largest_file =
    1 << 24;  // bytes; enough for a file written by hand, also with a load history of 100,000 points

// toml++ limits the depth of nested brackets, but not that of dotted keys: each dot of a.a.a. ... creates a
// nested table, and destroying a deep tree of tables would overflow the stack. Therefore the dots of dotted
// keys are counted in each line. A dot between two digits counts only if there is no separator (comma, quote,
// bracket) between it and the dot before, so that decimal points in lists of numbers do not count.
Source too_many_dots(const std::string& text) {
  constexpr int most = 32;
  const auto digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  Source at{1, 1};
  bool separated = true;
  int dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i, ++at.column) {
    if (text[i] == '\n') {
      at = {at.line + 1, 0};
      dots = 0;
      separated = true;
    } else if (text[i] == '.') {
      const bool decimal = i > 0 && digit(i - 1) && digit(i + 1) && separated;
      const bool rule = i > 0 && text[i - 1] == '.';  // "....." is not a key
      if (!decimal && !rule && ++dots > most) return at;
      separated = false;
    } else if (std::string_view(",=[]{}\"'").find(text[i]) != std::string_view::npos) {
      separated = true;
    }
  }
  return {};
}

[[noreturn]] void refuse(const std::string& file, Source at, std::string text) {
  throw InputError(file, {Fault{at.line, at.column, std::move(text)}});
}

[[noreturn]] void refuse_length(const std::string& file) {
  refuse(file, {}, fmt::format("larger than {} bytes; expected a file written by hand", largest_file));
}

}  // namespace

std::string read_text_file(const std::string& file, const std::string& what, Length length) {
  std::error_code status;
  const auto type = std::filesystem::status(file, status).type();
  if (type == std::filesystem::file_type::not_found) refuse(file, {}, "no such file; expected " + what);
  if (type == std::filesystem::file_type::directory) refuse(file, {}, "is a directory; expected " + what);
  if (type != std::filesystem::file_type::regular &&
      type != std::filesystem::file_type::none)  // opening a pipe could block
    refuse(file, {}, "is a pipe or a device; expected " + what);
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(file, {}, "cannot be read (permission?); expected " + what);
  std::string text;
  std::vector<char> part(1 << 16);
  while (in.read(part.data(), std::streamsize(part.size())) || in.gcount() > 0) {
    text.append(part.data(), std::size_t(in.gcount()));
    if (length == Length::by_hand && text.size() > largest_file) refuse_length(file);
  }
  if (in.bad()) refuse(file, {}, "cannot be read to its end; expected " + what);
  return text;
}

toml::table parse_toml(const std::string& text, const std::string& file) {
  if (text.size() > largest_file) refuse_length(file);
  if (const Source at = too_many_dots(text); at.line > 0)
    refuse(file, at, "too many dots in one line; expected a key of a few words");
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& e) {
    std::string why(e.description());
    std::replace_if(
        why.begin(), why.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    refuse(file, {int(e.source().begin.line), int(e.source().begin.column)}, why);
  }
}

}  // namespace femsph
