// Histories come back as they went in: CSV to the last bit (17 significant digits identify a double), HDF5
// exactly. Files appear whole or not at all: what fails leaves the old file, no temporary, and one sentence
// that names the file.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <limits>

#include "model/results/history.hpp"
#include "tests/unit/model_results_fake.hpp"
#include "tests/unit/model_results_hdf5.hpp"

namespace femsph::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

History sample_history() {
  History h;
  h.add("time", "s");
  h.add("tip_x", "m");
  h.columns[0].values = {0, 0.1, 1.0 / 3.0, 2.5e-7};
  h.columns[1].values = {-0.0, 5e-324, -1.7976931348623157e308, std::nextafter(1.0, 2.0)};
  return h;
}

std::vector<std::vector<double>> csv_rows(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::vector<double>> rows;
  std::string line;
  for (std::getline(in, line); std::getline(in, line);) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');)
      rows.back().push_back(std::strtod(field.c_str(), nullptr));
  }
  return rows;
}

TEST(History, NamesItsColumnsWhenOneIsMissing) {
  const History h = sample_history();
  EXPECT_EQ(h["tip_x"].unit, "m");
  EXPECT_TRUE(h.has("time"));
  EXPECT_FALSE(h.has("tip_y"));
  EXPECT_EQ(h.rows(), 4u);
  EXPECT_THAT([&] { h["tip_y"]; },
              ThrowsMessage<std::out_of_range>(AllOf(HasSubstr("\"tip_y\""), HasSubstr("time, tip_x"))));
  EXPECT_THROW(sample_history().add("time", "s"), std::logic_error);
}

TEST(Csv, ComesBackToTheLastBit) {
  const Folder folder;
  const History h = sample_history();
  write_csv(h, folder / "history.csv");
  const std::string text = read(folder / "history.csv");
  EXPECT_EQ(text.substr(0, text.find('\n')), "time [s],tip_x [m]");
  const auto rows = csv_rows(text);
  ASSERT_EQ(rows.size(), 4u);
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_EQ(rows[r][c], h.columns[c].values[r]);
      EXPECT_EQ(std::signbit(rows[r][c]), std::signbit(h.columns[c].values[r]));
    }
  EXPECT_THAT(folder.files(), ElementsAre("history.csv"));
}

TEST(Csv, QuotesSeparatorsAndHasOneSpellingOfNaN) {
  const Folder folder;
  History h;
  h.add("a, \"b\"", "1");
  h.columns[0].values = {-std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()};
  write_csv(h, folder / "h.csv");
  EXPECT_EQ(read(folder / "h.csv"), "\"a, \"\"b\"\" [1]\"\nnan\n-inf\n");
}

TEST(Csv, ProfileCarriesItsTime) {
  const Folder folder;
  write_csv(Profile{"mid", 0.5, {0, 1}, {{"xx", "Pa", {3, 4}}}}, folder / "p.csv");
  EXPECT_EQ(read(folder / "p.csv"), "distance [m],xx [Pa],time [s]\n0,3,0.5\n1,4,0.5\n");
}

TEST(Csv, RefusesColumnsOfDifferentLength) {
  const Folder folder;
  History h = sample_history();
  h.columns[1].values.pop_back();
  EXPECT_THROW(write_csv(h, folder / "h.csv"), std::logic_error);
  EXPECT_THROW(write_hdf5(h, folder / "h.h5"), std::logic_error);
  EXPECT_TRUE(folder.files().empty());
}

TEST(Hdf5, HistoryComesBackWithUnitsInOrder) {
  const Folder folder;
  const History h = sample_history();
  write_hdf5(h, folder / "history.h5");
  EXPECT_THAT(root_names(folder / "history.h5"), ElementsAre("time", "tip_x"));
  for (const Column& c : h.columns) {
    const Dataset d = read_hdf5(folder / "history.h5", c.name);
    EXPECT_THAT(d.shape, ElementsAre(4));
    EXPECT_EQ(d.values, c.values);
    EXPECT_EQ(read_text_attribute(folder / "history.h5", c.name, "unit"), c.unit);
  }
  EXPECT_THAT(folder.files(), ElementsAre("history.h5"));
}

TEST(Hdf5, HistoryWithoutRowsIsAFileToo) {
  const Folder folder;
  History h;
  h.add("time", "s");
  write_hdf5(h, folder / "h.h5");
  EXPECT_THAT(read_hdf5(folder / "h.h5", "time").shape, ElementsAre(0));
}

TEST(WholeFile, ReplacesAndFollowsLinks) {
  const Folder folder;
  write_text("old", folder / "a");
  std::filesystem::create_symlink(folder / "a", folder / "link");
  write_text("new", folder / "link");
  EXPECT_EQ(read(folder / "a"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_THAT(folder.files(), ElementsAre("a", "link"));
}

TEST(WholeFile, SaysWhatIsInTheWay) {
  const Folder folder;
  write_text("a file", folder / "file");
  std::filesystem::create_directory(folder / "taken");
  const auto refuses = [&](const std::string& file, const std::string& why) {
    EXPECT_THAT([&] { write_text("x", file); },
                ThrowsMessage<std::runtime_error>(AllOf(HasSubstr(file), HasSubstr(why))));
    EXPECT_THAT([&] { write_csv(sample_history(), file); },
                ThrowsMessage<std::runtime_error>(AllOf(HasSubstr(file), HasSubstr(why))));
    EXPECT_THAT([&] { write_hdf5(sample_history(), file); },
                ThrowsMessage<std::runtime_error>(AllOf(HasSubstr(file), HasSubstr(why))));
  };
  refuses(folder / "taken", "Is a directory");
  refuses(folder / "none/x", "No such file or directory");
  refuses(folder / "file/x", "Not a directory");
  refuses("/dev/null", "not a regular file");
  EXPECT_THAT(folder.files(), ElementsAre("file"));
}

TEST(WholeFile, SaysThatTheFolderIsNotWritable) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const Folder folder;
  std::filesystem::permissions(
      folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THAT(
      [&] { write_text("x", folder / "a"); },
      ThrowsMessage<std::runtime_error>(AllOf(HasSubstr(folder / "a"), HasSubstr("Permission denied"))));
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

/// A file-size limit fails a write halfway, as a full disk does.
class SizeLimit {
 public:
  explicit SizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(WholeFile, KeepsTheOldFileWhenTheDiskIsFull) {
  const Folder folder;
  History large;
  large.add("time", "s");
  large.columns[0].values.assign(10000, 1.0 / 3.0);
  for (const auto& [name, write] :
       {std::pair<std::string, void (*)(const History&, const std::string&)>{"h.csv", write_csv},
        {"h.h5", write_hdf5}}) {
    write_text("old", folder / name);
    std::string message;
    try {
      const SizeLimit limit(4096);
      write(large, folder / name);
    } catch (const std::runtime_error& e) {
      message = e.what();
    }
    EXPECT_THAT(message, AllOf(HasSubstr(folder / name), HasSubstr("File too large")));
    EXPECT_EQ(read(folder / name), "old");
  }
  EXPECT_THAT(folder.files(), ElementsAre("h.csv", "h.h5"));
}

}  // namespace
}  // namespace femsph::test
