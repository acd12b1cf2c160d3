// The command line: exit codes, messages, and the files in a folder after a second run.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program_output.hpp"
#include "tests/verification/interrupted.hpp"

namespace {

namespace fs = std::filesystem;
using femsph::test::Outcome;
using femsph::test::run_femsph;
using testing::HasSubstr;
using testing::Not;

class CommandLine : public testing::Test {
 protected:
  CommandLine() { fs::create_directories(folder); }
  ~CommandLine() override { fs::remove_all(folder); }
  std::string write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
    return (folder / name).string();
  }
  std::string read(const std::string& name) const {
    std::ifstream in(folder / name, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  /// A bar 40 x 10 mm; `rest` after it.
  std::string bar(const std::string& rest = "") const {
    return write(
        "bar.toml",
        "title = \"bar\"\n[model]\nplane = \"stress\"\n[materials.steel]\nlaw = \"elastic\"\nyoung "
        "= \"210 GPa\"\npoisson = 0.3\ndensity = \"7850 kg/m^3\"\n"
        "[bodies.bar]\nshape = \"box\"\nsize = [\"40 mm\", \"10 mm\"]\nthickness = \"10 "
        "mm\"\nmaterial = \"steel\"\n"
        "[[supports]]\nat = \"x-\"\nfix = [\"x\", \"y\"]\n[[loads]]\nat = \"x+\"\nforce = [\"1 "
        "kN\", \"0 N\"]\n[time]\nduration = \"20 us\"\nsnapshots = 4\n" +
            rest);
  }
  const fs::path folder = fs::temp_directory_path() / ("femsph-command-" + std::to_string(getpid()));
};

const char* const symmetric = "[[symmetry]]\nbody = \"bar\"\nat = \"y-\"\n";

TEST_F(CommandLine, BadCommandsExitWithTwo) {
  const std::string scene = bar(),
                    run = "run " + scene + " --spacing '5 mm' --out " + path("out") + " --solver ";
  const std::pair<std::string, const char*> bad[] = {
      // one of each command: tests/unit/compare_command.cpp has the others
      {run + "fem --safety nan", "femsph: --safety is nan; expected a number above 0, up to 1"},
      {run + "fem --checkpoint -5", "--checkpoint \"-5\": expected a number of steps"},
      {"run " + scene + " --solver sph --divisions 4,4 --out " + path("out"), "SPH has one spacing"},
      {run + "bra=fem", "femsph: --solver: no body \"bra\"; expected \"bar\"; did you mean \"bar\"?"},
      // a run goes on with the methods of its checkpoint, and takes no others
      {"resume " + path("out") + " --solver fem", "The following arguments were not expected: fem --solver"},
      {"check " + scene + " --spacing '5 mm'", "femsph: --spacing does nothing without --solver"},
      {"check " + scene + " --solver fem --spacing '5 mm' --threads -3", "--threads is -3"},
      {"point " + scene + " --material stele --path x.csv", "did you mean \"steel\"?"},
      {"study no-such-study", "no study is called \"no-such-study\""},
      {"study uniaxial --quick --update-readme --out " + path("out"), "--update-readme with --quick"},
  };
  for (const auto& [arguments, message] : bad) {
    const Outcome o = run_femsph(arguments);
    EXPECT_EQ(o.code, 2) << arguments << "\n" << o.text;
    EXPECT_THAT(o.text, HasSubstr(message)) << arguments;
  }
  EXPECT_FALSE(fs::exists(path("out")));  // nothing was started
}

TEST_F(CommandLine, ScenesThatAMethodRefusesExitWithThree) {
  const std::string large = write("large.toml", [&] {
    bar(symmetric);
    std::string text = read("bar.toml");
    return text.replace(text.find("plane = \"stress\""), 16, "plane = \"stress\"\nmotion = \"large\"");
  }());
  const Outcome o = run_femsph(
      "run " + large + " --solver sph-classic-share --spacing '2.5 mm' --out " + path("out"));
  EXPECT_EQ(o.code, 3) << o.text;
  EXPECT_EQ(o.text,
            "femsph: symmetry planes and bars need the initial neighbours; classic SPH with large motion "
            "cannot use them\n");
  const Outcome coarse = run_femsph("check " + bar() + " --solver fem --spacing '1 m'");
  EXPECT_EQ(coarse.code, 3) << coarse.text;
  EXPECT_THAT(coarse.text, HasSubstr("a spacing of 1000 mm does not fit a body 40 mm long along x"));
}

// Two press-fit bars that overlap undeformed run when the displacements at the start part them, and are
// refused when they do not.
TEST_F(CommandLine, AnOverlapThatTheStartRemovesIsNone) {
  const auto scene = [&](const char* name, const char* gradient) {
    const auto body = [](const char* body, const char* origin) {
      return std::string("[bodies.") + body + "]\nshape = \"box\"\norigin = [\"" + origin +
             "\", \"0 mm\"]\nsize = [\"100 mm\", \"50 mm\"]\nthickness = \"10 mm\"\nmaterial = \"rubber\"\n";
    };
    return write(
        name,
        "title = \"fit\"\n[model]\nplane = \"stress\"\nmotion = \"large\"\n[materials.rubber]\nlaw "
        "= \"elastic\"\nyoung = \"10 MPa\"\npoisson = 0.0\ndensity = \"1000 kg/m^3\"\n" +
            body("left", "0 mm") + body("right", "99 mm") +
            "[[supports]]\nbody = \"left\"\nat = \"x-\"\nfix = [\"x\", \"y\"]\n[[supports]]\nbody = "
            "\"right\"\nat = \"x+\"\nfix = [\"x\", \"y\"]\n" +
            "[[initial_displacements]]\nbody = \"left\"\ngradient = [[" + gradient +
            ", 0], [0, 0]]\n[[contacts]]\nname = \"c\"\nbetween = [\"left\", "
            "\"right\"]\n[time]\nduration = \"0.1 ms\"\n");
  };
  for (const char* solver : {"fem", "sph"}) {
    const std::string options = std::string(" --solver ") + solver +
                                " --spacing '12.5 mm' --no-fields --out " + path("out");
    EXPECT_EQ(run_femsph("run " + scene("apart.toml", "-0.03") + options).code, 0) << solver;
    const Outcome o = run_femsph("run " + scene("in.toml", "-0.005") + options);  // its end at 99.5 mm
    EXPECT_EQ(o.code, 3) << o.text;
    EXPECT_THAT(o.text, HasSubstr("in.toml:33:1: contact \"c\": the bodies overlap by 0.5 mm at the start; "
                                  "expected them apart or touching, at (0.0995, 0.0125, 0) m"))
        << solver;
  }
}

TEST_F(CommandLine, ASecondRunLeavesNothingOfTheFirst) {
  const std::string out = path("out"), sections =
                                           "[[sections]]\nname = \"middle\"\nquantity = \"stress\"\nfrom = "
                                           "[\"20 mm\", \"0 mm\"]\nto = [\"20 mm\", \"10 mm\"]\n";
  ASSERT_EQ(run_femsph("run " + bar(sections) + " --solver fem --spacing '5 mm' --out " + out).code, 0);
  ASSERT_TRUE(fs::exists(path("out/fields.xdmf")));
  ASSERT_TRUE(fs::exists(path("out/section_middle.csv")));
  write("out/notes.txt", "mine");
  write("out/section_of_mine.txt", "mine");
  write("out/fields/mine.h5", "mine");
  write("out/last_good.xdmf", "of a run that was stopped");
  ASSERT_EQ(run_femsph("run " + bar() + " --solver sph --spacing '5 mm' --no-fields --out " + out).code, 0);
  for (const char* gone : {"out/fields.xdmf", "out/last_good.xdmf", "out/section_middle.csv",
                           "out/fields/bodies.h5", "out/fields/000000.h5"})
    EXPECT_FALSE(fs::exists(path(gone))) << gone;
  for (const char* kept : {"out/notes.txt", "out/section_of_mine.txt", "out/fields/mine.h5"})
    EXPECT_EQ(read(kept), "mine") << kept;
  EXPECT_THAT(read("out/record.toml"), HasSubstr("sph-corrected"));
}

// A run into the folder of its own scene keeps it; one that would write over another scene is refused and
// changes no file.
TEST_F(CommandLine, ARunDoesNotWriteOverAnotherScene) {
  bar();
  const std::string text = read("bar.toml");
  write("own/scene.toml", text);
  ASSERT_EQ(run_femsph("run " + path("own/scene.toml") + " --solver fem --spacing '5 mm' --no-fields --out " +
                       path("own"))
                .code,
            0);
  EXPECT_EQ(read("own/scene.toml"), text);
  write("other/scene.toml", "# another\n" + text);
  write("other/history.csv", "mine");
  const Outcome o = run_femsph(
      "run " + path("bar.toml") + " --solver fem --spacing '5 mm' --no-fields --out " + path("other"));
  EXPECT_EQ(o.code, 2) << o.text;
  EXPECT_THAT(o.text, HasSubstr("it holds a scene.toml that is not from a run"));
  EXPECT_EQ(read("other/scene.toml"), "# another\n" + text);
  EXPECT_EQ(read("other/history.csv"), "mine");
}

// 40,000 rows are 1.1 MB. Elastic, so the last row is that of its strain alone: s_xx = E e in uniaxial
// stress, plane stress with eyy = -nu exx.
TEST_F(CommandLine, APathOfStrainsMayBeLong) {
  std::string text =
      "\xef\xbb\xbf"
      "exx,eyy,gxy\r\n";
  const int rows = 40000;
  for (int k = 1; k <= rows; ++k)
    text += "+" + std::to_string(1e-3 * k / rows) + "," + std::to_string(-0.3e-3 * k / rows) +
            ",0.0000000\r\n";
  text += "1e-3,-3e-4,0";  // no newline at the end
  ASSERT_GT(text.size(), std::size_t(1) << 20);
  const Outcome o = run_femsph("point " + bar() + " --material steel --path " + write("path.csv", text));
  ASSERT_EQ(o.code, 0) << o.text.substr(0, 300);
  EXPECT_EQ(std::count(o.text.begin(), o.text.end(), '\n'), rows + 2);
  std::istringstream last(o.text.substr(o.text.rfind('\n', o.text.size() - 2) + 1));
  std::vector<double> values;
  for (std::string cell; std::getline(last, cell, ',');) values.push_back(std::stod(cell));
  EXPECT_NEAR(values.at(4), 210e6, 1);
  EXPECT_NEAR(values.at(5), 0, 1);
}

TEST_F(CommandLine, FilesOfTheWrongKindAreOneMessage) {
  fs::create_directories(path("dir/checkpoint.h5"));
  const Outcome checkpoint = run_femsph("resume " + path("dir"));
  EXPECT_EQ(checkpoint.code, 1) << checkpoint.text;
  EXPECT_THAT(checkpoint.text, HasSubstr("no checkpoint can be read there"));
  const Outcome path_of_strains = run_femsph(
      "point " + bar() + " --material steel --path " +
      write("wide.csv", std::string("\xff\xfe"
                                    "e\0x\0x\0",
                                    8)));
  EXPECT_EQ(path_of_strains.code, 1);
  EXPECT_THAT(path_of_strains.text, HasSubstr("is UTF-16; expected plain text or UTF-8"));
  const std::string huge = write("huge.toml", read("bar.toml") + std::string((1 << 24) + 1, '\n'));
  const Outcome o = run_femsph("check " + huge);
  EXPECT_EQ(o.code, 1);
  EXPECT_THAT(o.text, HasSubstr("larger than 16777216 bytes; expected a file written by hand"));
}

// What a run has cost before an interruption counts: with set-up never less than without.
TEST_F(CommandLine, AfterAResumeThePriceIsThatOfAllParts) {
  bar();
  std::string text = read("bar.toml");
  text.replace(text.find("20 us"), 5, "3 ms");
  const std::string run = "run " + write("long.toml", text) +
                          " --solver fem --spacing 1mm --threads 1 --no-fields --checkpoint 3000 --out " +
                          path("out");
  const pid_t child = femsph::interrupted::start(run, path("log"));
  int status = 0;
  while (!fs::exists(path("out/checkpoint.h5")) && waitpid(child, &status, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGTERM);
  ASSERT_EQ(femsph::interrupted::wait_for(child), 6) << read("log");
  const Outcome o = run_femsph("resume " + path("out") + " --threads 1");
  ASSERT_EQ(o.code, 0) << o.text;
  double cpu = 0, total = 0;
  ASSERT_EQ(
      std::sscanf(o.text.c_str() + o.text.find("price") + 5, "%lf s CPU (%lf s with set-up)", &cpu, &total),
      2)
      << o.text;
  EXPECT_GT(cpu, 0);
  EXPECT_GE(total, cpu);
}

}  // namespace
