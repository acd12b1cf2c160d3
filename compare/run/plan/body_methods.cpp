#include "compare/run/plan/body_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "model/input/faults.hpp"
#include "model/input/lookup.hpp"

namespace femsph::compare {
namespace {

std::string without_blanks_around(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::string name_of(const std::vector<BodyMethod>& entries) {
  std::string name;
  for (const BodyMethod& entry : entries)
    name += (name.empty() ? "" : ",") + entry.body + (entry.body.empty() ? "" : "=") + entry.method.name;
  return name;
}

void refuse_unknown_body(const std::string& name, const Scene& scene) {
  std::vector<std::string> deformable;
  for (const Body& body : scene.bodies) {
    if (!body.rigid) deformable.push_back(body.name);
    if (body.rigid && body.name == name)
      throw std::runtime_error(fmt::format(
          "the body {} is rigid; expected deformable bodies only, as a rigid body "
          "has no particles or cells and needs no method",
          in_quotes(name)));
  }
  if (std::find(deformable.begin(), deformable.end(), name) == deformable.end())
    throw std::runtime_error(fmt::format("no body {}{}", in_quotes(name), expected_names(name, deformable)));
}

/// Refuses bodies without a method, and a method for other bodies if there are none.
void refuse_incomplete(const std::vector<BodyMethod>& entries, const Scene& scene) {
  const auto named = [&](const std::string& name) {
    return std::any_of(
        entries.begin(), entries.end(), [&](const BodyMethod& entry) { return entry.body == name; });
  };
  const auto others = std::find_if(
      entries.begin(), entries.end(), [](const BodyMethod& entry) { return entry.body.empty(); });
  bool left = false;
  for (const Body& body : scene.bodies) {
    if (body.rigid || named(body.name)) continue;
    left = true;
    if (others == entries.end())
      throw std::runtime_error(fmt::format(
          "no method is given for the body {0}; expected also {0}=METHOD, or one METHOD without "
          "a body, for all bodies that are not named",
          body.name));
  }
  if (!left && others != entries.end())
    throw std::runtime_error(fmt::format(
        "{} is for no body, as every deformable body is named; expected it with a body, or not",
        others->method.name));
}

std::vector<BodyMethod> read_entries(const std::string& text, const Scene* scene,
                                     Method (*named)(const std::string&)) {
  std::vector<BodyMethod> entries;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(',', begin);
    const std::string part = text.substr(begin, end == std::string::npos ? end : end - begin);
    const std::size_t equal = part.rfind('=');
    const bool has_body = equal != std::string::npos;
    const std::string body = has_body ? without_blanks_around(part.substr(0, equal)) : "";
    if (has_body && (scene || body.empty())) refuse_unknown_body(body, scene ? *scene : Scene{});
    Method method = named(without_blanks_around(has_body ? part.substr(equal + 1) : part));
    for (const BodyMethod& earlier : entries)
      if (earlier.body == body)
        throw std::runtime_error(
            has_body ? fmt::format("the body {} is named twice; expected one method for it", in_quotes(body))
                     : fmt::format("{} and {} are both without a body; expected one method at most for the "
                                   "bodies that are not named",
                                   earlier.method.name, method.name));
    entries.push_back({body, std::move(method)});
  }
  return entries;
}

}  // namespace

BodyMethods::BodyMethods(std::vector<BodyMethod> all) : name(name_of(all)), entries(std::move(all)) {}

const Method& BodyMethods::of(const Body& body) const {
  const BodyMethod* others = nullptr;
  for (const BodyMethod& entry : entries) {
    if (entry.body == body.name && !entry.body.empty()) return entry.method;
    if (entry.body.empty()) others = &entry;
  }
  if (!others) throw std::logic_error("no method for the body " + body.name);
  return others->method;
}

bool BodyMethods::all_fem() const {
  return std::all_of(
      entries.begin(), entries.end(), [](const BodyMethod& entry) { return entry.method.is_fem(); });
}

bool BodyMethods::all_sph() const {
  return std::none_of(
      entries.begin(), entries.end(), [](const BodyMethod& entry) { return entry.method.is_fem(); });
}

std::string BodyMethods::unit_name() const {
  return all_fem() ? "element" : all_sph() ? "particle" : "particle or element";
}

BodyMethods read_body_methods(const std::string& text, const Scene* scene,
                              Method (*named)(const std::string&)) {
  if (text.find_first_of("=,") == std::string::npos) return named(text);
  std::vector<BodyMethod> entries = read_entries(text, scene, named);
  if (scene) refuse_incomplete(entries, *scene);
  return BodyMethods(std::move(entries));
}

std::vector<std::pair<std::string, std::string>> describe(const BodyMethods& methods, const Scene& scene) {
  std::vector<std::pair<std::string, std::string>> lines;
  if (!methods.by_body()) return lines;
  for (const Body& body : scene.bodies) {
    if (body.rigid) continue;
    const Method* method = &methods.of(body);
    for (const BodyMethod& entry : methods.entries)
      if (&entry.method == method) lines.emplace_back("method of " + body.name, method->name + entry.changes);
  }
  return lines;
}

}  // namespace femsph::compare
