// `femsph list` and `femsph help`: print the catalogues and the tables of keys.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compare/program/catalogues.hpp"
#include "compare/program/commands.hpp"
#include "compare/study/reader/study_page.hpp"
#include "model/input/lookup.hpp"
#include "model/input/toml_fields.hpp"
#include "model/results/history.hpp"
#include "model/scene/reader/scene_page.hpp"

namespace femsph::compare {
namespace {

namespace fs = std::filesystem;

void list_studies(const std::string& program) {
  std::string folder;
  try {
    folder = studies_folder(program);
  } catch (const BadCommand& none) {
    fmt::print("studies: {}\n", none.what());
    return;
  }
  fmt::print("studies in {}:\n", folder);
  for (const std::string& name : studies_in(folder)) {
    std::string title;
    try {
      title = read_study((fs::path(folder) / name / "study.toml").string()).title;
    } catch (const InputError&) {
      title = fmt::format("(its study.toml has faults: `femsph study {}` shows them)", name);
    }
    fmt::print("  {:<12} {}\n", name, title);
  }
}

/// Prints "  word   meaning", with a long meaning in several lines.
void print_entry(const Entry& entry, std::size_t width) {
  constexpr std::size_t columns = 110;
  std::string line = fmt::format("  {:<{}} ", entry.word, width);
  std::size_t begin = 0;
  bool first = true;
  while (begin < entry.about.size()) {
    const std::size_t end = std::min(entry.about.find(' ', begin), entry.about.size());
    if (!first && line.size() + 1 + end - begin > columns) {
      fmt::print("{}\n", line);
      line = std::string(width + 3, ' ');
      first = true;
    }
    line += (first ? "" : " ") + entry.about.substr(begin, end - begin);
    first = false;
    begin = end + 1;
  }
  fmt::print("{}\n", line);
}

const KeyPage& page_of(const std::string& topic) {
  static const std::vector<std::pair<std::string, const KeyPage*>> pages = {
      {"scene", &scene_page()}, {"study", &study_page()}};
  return *value_named<BadCommand>(pages, topic, "no page of keys for " + in_quotes(topic));
}

void write_documents(const fs::path& folder) {
  if (!fs::is_directory(folder / "docs"))
    throw BadCommand(
        fmt::format("--write {}: expected the folder of the sources, which holds docs/", folder.string()));
  for (const char* topic : {"scene", "study"})
    write_text(to_markdown(page_of(topic)), (folder / "docs" / fmt::format("{}-keys.md", topic)).string());
  for (const char* name : {"README.md", "model/scene/README.md", "model/material/README.md",
                           "model/motion/README.md", "studies/README.md"}) {
    const std::string file = (folder / name).string();
    const std::string text = read_text_file(file, "a README.md", Length::any), now = with_catalogues(text);
    if (now != text) write_text(now, file);
  }
}

}  // namespace

int list_command(const std::string& program) {
  list_studies(program);
  for (const Catalogue& catalogue : catalogues()) {
    fmt::print("\n{}:\n", catalogue.title);
    std::size_t width = 0;
    for (const Entry& entry : catalogue.entries) width = std::max(width, entry.word.size());
    for (const Entry& entry : catalogue.entries) print_entry(entry, width);
  }
  return 0;
}

int help_command(const HelpCommand& command) {
  if (!command.write.empty()) {
    if (!command.topic.empty()) throw BadCommand("help with a topic and --write; expected one of them");
    write_documents(command.write);
    return 0;
  }
  fmt::print("{}", to_markdown(page_of(command.topic)));
  return 0;
}

}  // namespace femsph::compare
