#pragma once
// Reads a TOML table key by key, and reports each fault with its place and what was expected; for scenes and
// studies.
//
//   Fields root(table, "", faults, scene_page());
//   auto fields = root.table("time", Need::required, "a table with a duration");
//   const auto duration = fields->quantity("duration", Need::required, dimension::time, Sign::positive);
//   fields->done();                // reports keys that have not been read
//   faults.raise(file);            // at the very end
//
// A function that reads a key returns nothing if the key is absent or faulty. It adds a Fault if the key is
// faulty, or absent and required. So the caller continues with the rest of the file, and no fault is reported
// twice: of a required key that is misspelt, done() alone says something. Every path must come to done(), or
// to a fault that it adds itself. Reading a key that the description of the table (keys.hpp) does not contain
// throws std::logic_error.

#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/input/faults.hpp"
#include "model/input/keys.hpp"
#include "model/input/need.hpp"
#include "model/input/units.hpp"
#include "model/numerics/tensor.hpp"

namespace femsph {

class Fields {
 public:
  /// The top level of a file whose tables and keys `page` describes. Table and page must outlive the Fields.
  Fields(const toml::table& table, Faults& faults, const KeyPage& page);
  /// A table without a description; `name` is its name in messages: "[[runs]]"; empty for the top level of
  /// the file.
  Fields(const toml::table& table, std::string name, Faults& faults);

  const std::string& name() const { return name_; }
  Source source() const;                      ///< position of the table
  Source source(std::string_view key) const;  ///< position of the value; of the table if the key is absent
  bool has(std::string_view key) const { return table_->contains(key); }
  bool holds_table(std::string_view key) const { return has(key) && table_->get(key)->is_table(); }
  /// Whether the table lacks one of these keys, and has an unknown key that is most similar to it. done()
  /// reports that one with "did you mean", so that a message about the key that is missing would be a second
  /// one about the same error. False for a table without a description.
  bool misspelt(std::initializer_list<std::string_view> keys) const;
  void fault(std::string_view key, std::string text) const {
    if (!blind_) faults_->add(source(key), std::move(text));
  }
  /// The position of `name`, which stands at `key`, in `known`. If it is not there: nothing, and a fault
  /// "unknown WHAT NAME; expected ..; did you mean".
  std::optional<std::size_t> position_of(const std::string& name, const std::vector<std::string>& known,
                                         const char* key, const std::string& what) const;

  std::optional<std::string> text(const char* key, Need need,
                                  const std::string& expected = "a text in quotes");
  std::optional<std::vector<std::string>> texts(const char* key, Need need, const std::string& expected);
  /// A plain, finite, dimensionless number.
  std::optional<double> number(const char* key, Need need, const std::string& expected = "a number");
  std::optional<std::vector<double>> numbers(const char* key, Need need);
  std::optional<bool> flag(const char* key, Need need);
  std::optional<int> count(const char* key, Need need, int least, int most);
  /// A number with its unit, in SI.
  std::optional<double> quantity(const char* key, Need need, const Dimension& dimension,
                                 Sign sign = Sign::any);
  std::optional<std::vector<double>> quantities(const char* key, Need need, const Dimension& dimension,
                                                Sign sign = Sign::any);
  /// A vector of `dim` components in SI; dim = 0 (not known, after a fault): two or three components are
  /// accepted.
  std::optional<Point> vector(const char* key, Need need, const Dimension& dimension, int dim,
                              Sign sign = Sign::any);
  /// `dim` rows of `dim` values each, in SI; plain numbers if `dimension` is null.
  std::optional<std::array<Point, 3>> matrix(const char* key, Need need, const Dimension* dimension, int dim);
  /// Two such vectors: the lower and the upper corner of a box.
  std::optional<std::pair<Point, Point>> corners(const char* key, Need need, const Dimension& dimension,
                                                 int dim);
  /// One of a few words.
  template <class T>
  std::optional<T> choice(const char* key, Need need, const std::vector<std::pair<std::string, T>>& choices);

  std::optional<Fields> table(const char* key, Need need, const std::string& expected);
  /// The tables of [[key]].
  std::vector<Fields> tables(const char* key);
  /// The tables [key.NAME] with their names, in the order of the file. A value there that is no table is a
  /// fault; it is returned as Fields without keys that report no further fault, since other tables may refer
  /// to its name.
  std::vector<std::pair<std::string, Fields>> named_tables(const char* key, Need need,
                                                           const std::string& expected);

  /// Accepts a key with any value, where a fault elsewhere makes it impossible to check it.
  void accept(const char* key) { asked_.emplace_back(key); }
  /// Accepts all keys that the description of the table has (without one: all keys), where another fault
  /// makes it impossible to check them. done() still reports the others.
  void accept_rest();
  /// Adds a fault for every key of the table that has not been read.
  void done();

 private:
  Fields(const toml::table& table, std::string name, const Fields& parent, const std::string& path);
  /// All keys that the description of the table has, those of its tables included.
  std::vector<std::string> stated_keys() const;
  std::string path_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  /// Throws std::logic_error unless the description of the table contains `key` with this need, and with all
  /// texts of `held` in Key::holds.
  void require_stated(const std::string& key, Need need, const std::vector<std::string>& held) const;
  /// The same for a key that is a table.
  void require_table(const std::string& key, Need need) const;
  /// `held` is empty for tables, which require_table() has checked.
  const toml::node* find(const char* key, Need need, const std::string& expected,
                         const std::vector<std::string>& held);
  const toml::array* array(const char* key, Need need, const std::string& expected,
                           const std::vector<std::string>& held);
  std::optional<std::string> text_of(const char* key, Need need, const std::string& expected,
                                     const std::vector<std::string>& held);
  std::optional<std::vector<double>> read_quantities(const toml::array& list, const char* key,
                                                     const Dimension& dimension, Sign sign);
  std::optional<Point> to_point(const std::vector<double>& all, const char* key, int dim) const;
  std::optional<double> read_quantity(const toml::node& node, const char* key, const Dimension& dimension,
                                      Sign sign);
  void wrong_type(const toml::node& node, const std::string& key, const std::string& expected);
  std::optional<std::size_t> choose(const char* key, Need need, const std::vector<std::string>& words);

  const toml::table* table_;
  std::string name_;
  Faults* faults_;
  bool blind_ = false;  ///< a stand-in for a value that is no table: all keys are absent, no fault is added
  const KeyPage* page_ = nullptr;
  std::string path_;                ///< of the table in the page: "materials.NAME"
  const KeyTable* keys_ = nullptr;  ///< null: the keys are not described
  std::vector<std::string> asked_;
};

template <class T>
std::optional<T> Fields::choice(const char* key, Need need,
                                const std::vector<std::pair<std::string, T>>& choices) {
  std::vector<std::string> words;
  for (const auto& [word, value] : choices) words.push_back(word);
  const auto chosen = choose(key, need, words);
  return chosen ? std::optional<T>(choices[*chosen].second) : std::nullopt;
}

/// Where a value stands in its file.
Source source_of(const toml::node& node);

/// Files that are written by hand are refused beyond 16 MiB; data files may have any length.
enum class Length { by_hand, any };
/// The content of a file; `what` is what it should be ("a scene file"), for messages. Throws InputError.
std::string read_text_file(const std::string& file, const std::string& what, Length length = Length::by_hand);

/// Parses a text, which may be any bytes. Throws InputError with the place of a syntax error.
toml::table parse_toml(const std::string& text, const std::string& file);

}  // namespace femsph
