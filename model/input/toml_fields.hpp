#pragma once
// Reading a TOML table key by key, so that every fault is found, placed and explained; for scenes and for
// studies.
//
//   Fields root(table, "", faults, scene_page());
//   auto fields = root.table("time", Need::required, "a table with a duration");
//   const auto duration = fields->quantity("duration", Need::required, dimension::time, Sign::positive);
//   fields->done();                // reports the keys that nobody asked for
//   faults.raise(file);            // at the very end
//
// A getter returns nothing when the key is absent or faulty; in the second case, and when a required key is
// absent, it has added a Fault. So the caller goes on with the rest of the file and never reports the same
// thing twice. A getter that asks for what the table's keys (keys.hpp) do not state throws std::logic_error.

#include <toml++/toml.h>

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
  /// The top level of a file whose tables and keys `page` states. Table and page must outlive the Fields.
  Fields(const toml::table& table, Faults& faults, const KeyPage& page);
  /// A table without a page; `name` is how messages call it: "[[runs]]"; empty for the file's top level.
  Fields(const toml::table& table, std::string name, Faults& faults);

  const std::string& name() const { return name_; }
  Source source() const;                      ///< of the table
  Source source(std::string_view key) const;  ///< of the key's value; of the table if it is absent
  bool has(std::string_view key) const { return table_->contains(key); }
  bool holds_table(std::string_view key) const { return has(key) && table_->get(key)->is_table(); }
  void fault(std::string_view key, std::string text) const {
    if (!blind_) faults_->add(source(key), std::move(text));
  }

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
  /// A vector of `dim` components in SI; dim 0: two or three will do (the dimension of the scene is itself at
  /// fault).
  std::optional<Point> vector(const char* key, Need need, const Dimension& dimension, int dim,
                              Sign sign = Sign::any);
  /// `dim` rows of `dim` values each, quantities in SI; plain numbers without a dimension.
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
  /// The tables [key.NAME] with their names, in the order of the file. What stands there and is no table is
  /// a fault, and comes as Fields without keys that report nothing more: others may refer to its name.
  std::vector<std::pair<std::string, Fields>> named_tables(const char* key, Need need,
                                                           const std::string& expected);

  /// Takes a key as known, whatever it holds: a fault elsewhere hides what it should.
  void accept(const char* key) { asked_.emplace_back(key); }
  /// Takes every key as known: a fault elsewhere hides what the table should hold.
  void accept_rest();
  /// Reports every key of the table that no getter has asked for.
  void done();

 private:
  Fields(const toml::table& table, std::string name, const Fields& parent, const std::string& path);
  std::string path_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  /// Throws std::logic_error unless the table's keys state `key` with this need, holding all of `held`.
  void require_stated(const std::string& key, Need need, const std::vector<std::string>& held) const;
  /// The same for a table of its own.
  void require_table(const std::string& key, Need need) const;
  /// `held` is empty for tables, which require_table has looked up.
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
  bool blind_ = false;  ///< it stands for what is no table: all is absent, and nothing is a fault
  const KeyPage* page_ = nullptr;
  std::string path_;                ///< in the page
  const KeyTable* keys_ = nullptr;  ///< null: the table may hold what its reader asks for
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

/// Files that people write are refused beyond 16 MiB; data may have any length.
enum class Length { by_hand, any };
/// All bytes of a file; `what` says what it should be ("a scene file"). Throws InputError.
std::string read_text_file(const std::string& file, const std::string& what, Length length = Length::by_hand);

/// Any bytes to a table, or InputError with the place of the syntax error.
toml::table parse_toml(const std::string& text, const std::string& file);

}  // namespace femsph
