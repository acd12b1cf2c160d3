#pragma once
// Pieces of scene files, so that a test writes only what matters to it. Each function gives one TOML table,
// with its keys in the order of the arguments; `more` is further lines of the same table. Numbers with one
// unit are written once: "1000 100 mm" stands for ["1000 mm", "100 mm"].

#include <fmt/format.h>

#include <cctype>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace femsph::scene_text {

/// "1 2 mm" -> ["1 mm", "2 mm"]; "x y" -> ["x", "y"]; "1 N" -> ["1 N"].
inline std::string list(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;) words.push_back(word);
  const auto is_number = [](const std::string& w) {
    return std::isdigit(static_cast<unsigned char>(w[0])) || w[0] == '-';
  };
  std::string unit;
  if (words.size() > 1 && is_number(words[0]) && !is_number(words.back())) {
    unit = " " + words.back();
    words.pop_back();
  }
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "[\"" : ", \"") + word + unit + "\"";
  return out + "]";
}

/// `text` with the first `old` replaced. Throws std::logic_error if `old` does not occur.
inline std::string replaced(std::string text, const std::string& old, const std::string& instead) {
  const auto at = text.find(old);
  if (at == std::string::npos) throw std::logic_error("no such text: " + old);
  return text.replace(at, old.size(), instead);
}

/// `text` once for each line that starts with a key, with the first letter of this key doubled. The first of
/// a pair is the key.
inline std::vector<std::pair<std::string, std::string>> with_a_key_misspelt(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> all;
  for (std::size_t line = 0; line < text.size(); line = text.find('\n', line) + 1) {
    std::size_t end = line;
    while (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_') ++end;
    if (end > line && text.substr(end, 3) == " = ")
      all.emplace_back(text.substr(line, end - line), text.substr(0, line) + text[line] + text.substr(line));
    if (text.find('\n', line) == std::string::npos) break;
  }
  return all;
}

inline std::string model(const std::string& plane, const std::string& more = "") {
  return fmt::format("[model]\nplane = \"{}\"\n{}", plane, more);
}
inline const std::string large_motion = "motion = \"large\"\n";

inline std::string material(const std::string& name, const std::string& law, const std::string& young,
                            const std::string& poisson, const std::string& density,
                            const std::string& more = "") {
  return fmt::format("[materials.{}]\nlaw = \"{}\"\nyoung = \"{}\"\npoisson = {}\ndensity = \"{}\"\n{}", name,
                     law, young, poisson, density, more);
}
inline std::string steel(const std::string& poisson = "0.3") {
  return material("steel", "elastic", "210 GPa", poisson, "7850 kg/m^3");
}
/// Steel that yields at 300 MPa and hardens linearly, with a tangent modulus of a hundredth of Young's.
inline std::string plastic_steel(const std::string& more = "") {
  return material("steel", "plastic", "210 GPa", "0.3", "7850 kg/m^3",
                  "yield = \"300 MPa\"\ntangent_ratio = 0.01\n" + more);
}

/// A body that deforms. Its thickness, in plane scenes, is a line of `more`: thick("100 mm").
inline std::string box(const std::string& name, const std::string& size, const std::string& more = "",
                       const std::string& material = "steel") {
  return fmt::format(
      "[bodies.{}]\nshape = \"box\"\nsize = {}\n{}material = \"{}\"\n", name, list(size), more, material);
}
inline std::string thick(const std::string& thickness) {
  return fmt::format("thickness = \"{}\"\n", thickness);
}
inline std::string origin(const std::string& corner) { return fmt::format("origin = {}\n", list(corner)); }
inline std::string rigid(const std::string& mass) {
  return fmt::format("rigid = true\nmass = \"{}\"\n", mass);
}

/// A key of supports, loads, probes, ..: which body they belong to.
inline std::string of_body(const std::string& name) { return fmt::format("body = \"{}\"\n", name); }
inline std::string named(const std::string& name) { return fmt::format("name = \"{}\"\n", name); }

inline std::string support(const std::string& at, const std::string& fix, const std::string& more = "") {
  return fmt::format("[[supports]]\nat = \"{}\"\nfix = {}\n{}", at, list(fix), more);
}
inline std::string load(const std::string& at, const std::string& force, const std::string& more = "") {
  return fmt::format("[[loads]]\nat = \"{}\"\nforce = {}\n{}", at, list(force), more);
}
inline std::string initial(const std::string& velocity, const std::string& more = "") {
  return fmt::format("[[initial]]\nvelocity = {}\n{}", list(velocity), more);
}
inline std::string contact(const std::string& a, const std::string& b, const std::string& more = "") {
  return fmt::format("[[contacts]]\nbetween = [\"{}\", \"{}\"]\n{}", a, b, more);
}
inline std::string probe(const std::string& name, const std::string& quantity, const std::string& point,
                         const std::string& more = "") {
  return fmt::format(
      "[[probes]]\nname = \"{}\"\nquantity = \"{}\"\npoint = {}\n{}", name, quantity, list(point), more);
}
inline std::string section(const std::string& name, const std::string& quantity, const std::string& from,
                           const std::string& to, const std::string& more = "") {
  return fmt::format("[[sections]]\nname = \"{}\"\nquantity = \"{}\"\nfrom = {}\nto = {}\n{}", name, quantity,
                     list(from), list(to), more);
}
inline std::string settling(const std::string& method, const std::string& more = "") {
  return fmt::format("[settling]\nmethod = \"{}\"\n{}", method, more);
}
inline std::string time(const std::string& duration, const std::string& more = "") {
  return fmt::format("[time]\nduration = \"{}\"\n{}", duration, more);
}

/// Plane stress; a box "beam" of steel, clamped on x-.
inline std::string clamped_beam(const std::string& size, const std::string& thickness,
                                const std::string& poisson = "0.3", const std::string& of_support = "") {
  return model("stress") + steel(poisson) + box("beam", size, thick(thickness)) +
         support("x-", "x y", of_support);
}

}  // namespace femsph::scene_text
