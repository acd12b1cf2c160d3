#pragma once
// The method of each body of a scene: one for all, or one for each of some and another for the rest.

#include <string>
#include <vector>

#include "compare/run/plan/method.hpp"
#include "model/scene/scene.hpp"

namespace femsph::compare {

/// The method of one body, or of every body that is not named.
struct BodyMethod {
  std::string body;  ///< empty: every body that has no entry with its name
  Method method;
  std::string changes = {};  ///< options that differ from the method's: " smoothing=1.2"; for the record
};

struct BodyMethods {
  /// One method for every body. Implicit, so that a function for BodyMethods takes a Method too.
  BodyMethods(Method method) : name(method.name), entries{{"", std::move(method)}} {}
  /// Its name is made of those of the entries.
  explicit BodyMethods(std::vector<BodyMethod> entries);

  /// In tables: "sph-corrected", or "bar=sph-corrected,plate=fem-assumed-strain".
  std::string name;
  std::vector<BodyMethod> entries;  ///< at least one; at most one has an empty `body`

  /// Throws std::logic_error if there is none; read_body_methods makes sure that each body has one.
  const Method& of(const Body& body) const;
  /// Whether the methods were given body by body, even if they are the same.
  bool by_body() const { return entries.size() > 1 || !entries.front().body.empty(); }
  bool all_fem() const;
  bool all_sph() const;
  /// What time and memory are counted by: "element", "particle", or "particle or element".
  std::string unit_name() const;
};

/// Reads "sph-corrected", "bar=sph-corrected,plate=fem-full" or "fem-full,bar=sph-corrected" (an entry
/// without a body: every other body). `named` gives the method of a name. Throws std::runtime_error, with
/// "did you mean", for unknown methods and bodies, a body named twice, a rigid body, and a deformable body
/// without a method. Without a scene (null) bodies are not checked.
BodyMethods read_body_methods(const std::string& text, const Scene* scene,
                              Method (*named)(const std::string&) = method_named);

/// "method of bar" and "sph-corrected smoothing=1.2" for each deformable body; nothing unless by_body().
std::vector<std::pair<std::string, std::string>> describe(const BodyMethods& methods, const Scene& scene);

}  // namespace femsph::compare
