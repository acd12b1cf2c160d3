// The pages of keys and the tables of words in the repository are those of the program, and every study is
// read by its table of keys. To renew them: femsph help --write .

#include <gmock/gmock.h>

#include <filesystem>

#include "compare/program/catalogues.hpp"
#include "compare/program/commands.hpp"
#include "compare/study/reader/study.hpp"
#include "compare/study/reader/study_page.hpp"
#include "model/input/toml_fields.hpp"
#include "model/scene/reader/scene_page.hpp"

namespace femsph::compare {
namespace {

namespace fs = std::filesystem;
const fs::path source = FEMSPH_SOURCE_DIR;

std::string text_of(const fs::path& file) { return read_text_file(file.string(), "a text", Length::any); }

TEST(Keys, ThePagesInDocsAreThoseOfTheProgram) {
  EXPECT_EQ(text_of(source / "docs/scene-keys.md"), to_markdown(scene_page()));
  EXPECT_EQ(text_of(source / "docs/study-keys.md"), to_markdown(study_page()));
}

TEST(Keys, TheTablesOfWordsInTheReadmesAreThoseOfTheProgram) {
  for (const char* name : {"README.md", "studies/README.md", "model/scene/README.md"}) {
    const std::string text = text_of(source / name);
    EXPECT_EQ(text, with_catalogues(text)) << name;
    EXPECT_THAT(text, testing::HasSubstr("<!-- femsph:")) << name;
  }
}

TEST(Keys, LinesOfTheStudyPageFit) {
  std::istringstream lines(to_markdown(study_page()));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110u) << line;
}

// A key that a reader asks for and its table does not state would throw std::logic_error.
TEST(Keys, EveryStudyIsReadByItsTable) {
  int studies = 0;
  for (const std::string& name : studies_in((source / "studies").string())) {
    EXPECT_NO_THROW(read_study((source / "studies" / name / "study.toml").string())) << name;
    ++studies;
  }
  EXPECT_GT(studies, 10);
}

}  // namespace
}  // namespace femsph::compare
