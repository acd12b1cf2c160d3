// Looking up words in lists: the entry, or the message with the words that were expected.

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "model/input/faults.hpp"
#include "model/input/lookup.hpp"

namespace femsph {
namespace {

struct Metal {
  const char* word;
  double density;
};
const std::vector<Metal> metals = {{"iron", 7870}, {"nickel", 8908}, {"zinc", 7140}};

/// The message of an Error that `look` throws; empty if it throws none.
template <class Error, class Look>
std::string message_of(Look look) {
  try {
    look();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(Lookup, FindsTheEntryItself) {
  EXPECT_EQ(&entry_named<Refusal>(metals, "nickel", &Metal::word, "no metal"), &metals[1]);
  const std::vector<std::string> words = {"x", "y"};
  EXPECT_EQ(&entry_named<Refusal>(words, "y", std::identity{}, "no axis"), &words[1]);
}

TEST(Lookup, AnUnknownWordThrowsTheErrorThatIsAskedFor) {
  EXPECT_EQ(message_of<Refusal>([] { entry_named<Refusal>(metals, "nikel", &Metal::word, "no metal"); }),
            "no metal; expected \"iron\", \"nickel\" or \"zinc\"; did you mean \"nickel\"?");
  EXPECT_EQ(message_of<std::out_of_range>([] {
              entry_named<std::out_of_range>(metals, "gold", &Metal::word, "no metal \"gold\"");
            }),
            "no metal \"gold\"; expected \"iron\", \"nickel\" or \"zinc\"");
}

TEST(Lookup, FindsAValueByItsWord) {
  const std::vector<std::pair<std::string, int>> list = {{"one", 1}, {"two", 2}};
  const std::map<std::string, int> map(list.begin(), list.end());
  EXPECT_EQ(&value_named<Refusal>(list, "two", "no number"), &list[1].second);
  EXPECT_EQ(&value_named<Refusal>(map, "two", "no number"), &map.at("two"));
  EXPECT_EQ(message_of<Refusal>([&] { value_named<Refusal>(list, "tow", "no number"); }),
            "no number; expected \"one\" or \"two\"; did you mean \"two\"?");
}

// Up to a third of the letters, or one, may differ.
TEST(Lookup, TheNearestName) {
  EXPECT_EQ(nearest_name("yuong", {"poisson", "young"}), "young");
  EXPECT_EQ(nearest_name("spacings", {"spacing", "spaces"}), "spacing");
  EXPECT_EQ(nearest_name("at", {"aat"}), "aat");
  EXPECT_EQ(nearest_name("abc", {"abx", "axx"}), "abx");
  EXPECT_EQ(nearest_name("abcd", {"abxx"}), std::nullopt);
  EXPECT_EQ(nearest_name("x", {"y"}), std::nullopt);
  EXPECT_EQ(nearest_name("x", {}), std::nullopt);
}

}  // namespace
}  // namespace femsph
