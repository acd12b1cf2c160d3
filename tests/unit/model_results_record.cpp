// The record is valid TOML and has what was recorded; costs and progress are measured correctly.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <map>
#include <thread>

#include "model/results/record.hpp"
#include "tests/unit/model_results_fake.hpp"

namespace femsph::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

RunRecord sample_record() {
  RunRecord r;
  r.scene_file = "C:\\scenes\\\"odd\".toml";
  r.scene_text = "title = 'a'\r\n# caf\xC3\xA9\t" + std::string(1, '\0') + " no newline at the end";
  r.method = "SPH, corrected";
  r.command = "femsph run 'a b.toml'\n--spacing=\"1 mm\"\x01\x7f";
  r.derived = {{"critical step", "1.25e-6 s"}, {"particles", "16441"}, {"a.b = \"c\"", "'''\"\"\"\xC3\xA9"}};
  r.ledger = {1.0 / 3.0, 2e-300, 3, -4, 5, 6, std::numeric_limits<double>::quiet_NaN()};
  r.price = {
      1234567890123, 1e-7 / 3, 10, 11, 12, 4, 1000, 5000000000, {{"setup", 0.1}, {"critical step", 2}}};
  r.outcome = "step 12: the motion is not finite\nadvice: smaller step";
  r.finished_at = "2024-05-06T07:08:09Z";
  return r;
}

TEST(Record, ParsesAgainAndSaysWhatWentIn) {
  const Folder folder;
  const RunRecord r = sample_record();
  write_record(r, folder / "run");
  EXPECT_EQ(read(folder / "run/scene.toml"), r.scene_text);  // byte for byte
  EXPECT_THAT(folder.files(), ElementsAre("run/record.toml", "run/scene.toml"));

  const toml::table t = toml::parse_file(folder / "run/record.toml");
  const auto text = [&](const char* key) { return t[key].value<std::string>().value(); };
  EXPECT_EQ(text("scene_file"), r.scene_file);
  EXPECT_EQ(text("method"), r.method);
  EXPECT_EQ(text("command"), r.command);
  EXPECT_EQ(text("outcome"), r.outcome);
  EXPECT_EQ(text("finished_at"), r.finished_at);
  for (const auto& [key, value] : r.derived) EXPECT_EQ(t["derived"][key].value<std::string>(), value);
  for (const auto& [key, value] : provenance()) EXPECT_EQ(t["provenance"][key].value<std::string>(), value);

  const auto energy = [&](const char* key) { return t["energy"][key].value<double>().value(); };
  EXPECT_EQ(energy("kinetic"), r.ledger.kinetic);
  EXPECT_EQ(energy("strain"), r.ledger.strain);
  EXPECT_EQ(energy("external"), -4.0);
  EXPECT_TRUE(std::isnan(energy("initial")));
  EXPECT_EQ(t["price"]["steps"].value<std::int64_t>(), r.price.steps);
  EXPECT_EQ(t["price"]["dt"].value<double>(), r.price.dt);
  EXPECT_EQ(t["price"]["bytes"].value<std::int64_t>(), 5000000000);
  EXPECT_EQ(t["price"]["phases"]["critical step"].value<double>(), 2.0);
}

/// A file name may be Latin-1: the record must still be TOML.
TEST(Record, SurvivesTextThatIsNotUtf8) {
  const Folder folder;
  RunRecord r = sample_record();
  r.command = "femsph caf\xE9.toml";
  write_record(r, folder.path());
  EXPECT_THAT(toml::parse_file(folder / "record.toml")["command"].value<std::string>().value(),
              StartsWith("femsph caf"));
}

TEST(Record, SaysWhatIsInTheWay) {
  const Folder folder;
  std::filesystem::create_directory(folder / "record.toml");
  EXPECT_THAT([&] { write_record(sample_record(), folder.path()); },
              testing::ThrowsMessage<std::runtime_error>(
                  testing::AllOf(HasSubstr(folder / "record.toml"), HasSubstr("Is a directory"))));
}

TEST(Provenance, HasTheBuildAndWhatOthersAdd) {
  add_provenance("other library", "1");
  add_provenance("other library", "2");
  std::map<std::string, std::string> all;
  for (const auto& [key, value] : provenance()) EXPECT_TRUE(all.emplace(key, value).second) << key;
  for (const char* key : {"femsph", "git", "compiler", "build_type", "flags", "HDF5", "processor", "cores"})
    EXPECT_NE(all[key], "") << key;
  EXPECT_EQ(all["other library"], "2");
  EXPECT_THAT(version_line(), StartsWith("femsph " + all["femsph"]));
}

TEST(Price, AddsPhasesAndCountsPerUnitStep) {
  Price p;
  p.add("setup", 1);
  p.add("march", 2);
  p.add("setup", 3);
  EXPECT_THAT(p.phases, ElementsAre(testing::Pair("setup", 4), testing::Pair("march", 2)));
  p.steps = 1000, p.units = 1000, p.cpu = 0.01;
  EXPECT_DOUBLE_EQ(p.nanoseconds(), 10);
}

/// Sleeping takes wall time and no CPU time; memory that was touched counts in the peak also after it is
/// given back.
TEST(Price, ClocksAndMemory) {
  const double cpu = cpu_seconds(), wall = wall_seconds();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_GE(wall_seconds() - wall, 0.05);
  EXPECT_LT(cpu_seconds() - cpu, 0.04);
  const std::size_t before = peak_memory(), size = 64 << 20;
  EXPECT_GT(before, 1u << 20);
  {
    std::vector<char> v(size + before, 1);
    EXPECT_EQ(v.back(), 1);
  }
  EXPECT_GE(peak_memory(), size + before);
}

TEST(Progress, SaysStepTimeRateAndTimeLeft) {
  EXPECT_EQ(progress_line("beam", 1000, 4000, 0.0125, 500),
            "beam: step 1000 of 4000, t = 0.0125 s, 500 steps/s, 6 s left");
  EXPECT_EQ(progress_line("beam", 0, 8000000, 0, 1000),
            "beam: step 0 of 8000000, t = 0 s, 1000 steps/s, 2 h 13 min left");
  EXPECT_EQ(progress_line("beam", 7, 0, 0.5, 0), "beam: step 7, t = 0.5 s");
}

void march() {
  Progress progress("beam");
  for (int i = 0; i < 45; ++i) {
    progress.show(i, 45, 0.1 * i);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

TEST(Progress, IsSilentWithoutATerminal) {
  testing::internal::CaptureStderr();
  march();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// 0.45 s at most five times a second: two lines, then the line is wiped; none is wider than the terminal.
TEST(Progress, OverwritesOneLineOnATerminal) {
  int ours = -1, theirs = -1;
  const winsize size{24, 20, 0, 0};
  ASSERT_EQ(openpty(&ours, &theirs, nullptr, nullptr, &size), 0);
  const int stderr_before = dup(STDERR_FILENO);
  setenv("TERM", "xterm", 1);
  dup2(theirs, STDERR_FILENO);
  march();
  dup2(stderr_before, STDERR_FILENO);
  ::close(theirs), ::close(stderr_before);
  std::string shown;
  char text[256];
  for (ssize_t n; (n = ::read(ours, text, sizeof text)) > 0;) shown.append(text, n);
  ::close(ours);
  EXPECT_THAT(shown, StartsWith("\rbeam: step "));
  EXPECT_EQ(shown.find('\n'), std::string::npos);
  EXPECT_LE(std::count(shown.begin(), shown.end(), '\r'), 3);
  EXPECT_EQ(shown.substr(shown.size() - 4), "\r\033[K");
  EXPECT_EQ(shown.find("\033[K"), 20u);  // \r and 19 columns
}

}  // namespace
}  // namespace femsph::test
