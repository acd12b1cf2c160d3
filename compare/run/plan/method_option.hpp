#pragma once
// The options of methods: one list, from which follow a study's `options = {..}`, the options of the command
// line, the names of changed methods in tables, and `femsph list`.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compare/run/plan/body_methods.hpp"
#include "model/input/toml_fields.hpp"

namespace femsph::compare {

/// A range of an option's numbers; `open`: without its lower end.
struct OptionRange {
  double least, most;
  bool open = false;
  bool holds(double value) const { return (open ? value > least : value >= least) && value <= most; }
  std::string describe() const;  ///< "a number above 0, up to 10"
};

/// A number, true or false, or one of an option's words.
using OptionValue = std::variant<double, bool, std::string>;

struct MethodOption {
  std::string word;                  ///< "kernel_volume" in studies; the command line takes "--kernel-volume"
  std::string about;                 ///< one line
  std::optional<OptionRange> range;  ///< of a number
  std::vector<std::string> words;    ///< to choose from; without range and words it is true or false
  bool of_fem, of_sph;               ///< the methods that a study may give it to
  bool on_command_line;              ///< as --word; viscosity and projection have forms of their own there
  /// Why it has no effect on a method of that kind; empty if it has one.
  std::string (*idle)(const Method&);
  void (*set)(Method&, const OptionValue&);

  std::string holds() const;  ///< as Key::holds says it
};

/// All, in the order in which tables show them.
const std::vector<MethodOption>& method_options();
/// Throws std::logic_error if there is none of this word.
const MethodOption& method_option(const std::string& word);

/// Why an option has no effect on this method: "it is an option of SPH"; empty if it has one.
std::string why_idle(const Method& method, const MethodOption& option);
/// Why it has no effect on the method of any body; empty if it has one on some.
std::string why_idle(const BodyMethods& methods, const MethodOption& option);
/// "bar" or "every body but plate": the bodies on whose methods the option has an effect. Empty: all.
std::string bodies_with(const BodyMethods& methods, const MethodOption& option);

/// Changes to a method's options.
struct Overrides {
  std::vector<std::pair<const MethodOption*, OptionValue>> values;  ///< in the order of method_options()

  bool has(const std::string& word) const;
  void set(const std::string& word, OptionValue value);
  /// To the methods of those bodies on which they have an effect; notes these in BodyMethod::changes.
  void apply(BodyMethods& methods) const;
  /// " smoothing=1.2 alpha=5": those that have an effect on the method, to tell a changed method from the
  /// plain one in tables; empty if nothing is changed.
  std::string describe(const Method& method) const;
};

/// The keys of options = {..} in [[runs]].
KeyTable override_keys();
/// Reads the options that every one of `methods` has, for at least one body; faults for the others, with "did
/// you mean".
Overrides read_overrides(Fields& options, const std::vector<BodyMethods>& methods);

}  // namespace femsph::compare
