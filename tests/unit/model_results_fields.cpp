// What fields.xdmf tells ParaView must exist: every HDF5 path that fields.xdmf names exists with the
// dimensions it states, after every commit. Values are those of the fake bodies, whose numbers are known.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "model/results/fields.hpp"
#include "tests/unit/model_results_fake.hpp"
#include "tests/unit/model_results_hdf5.hpp"

namespace femsph::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;
using testing::ThrowsMessage;

/// Tags open and close in order, and attributes are quoted: well-formed, for a document without comments or
/// CDATA.
void expect_well_formed(const std::string& xml) {
  const std::regex tag(R"re(<(/?)([A-Za-z]+)((?: [A-Za-z]+="[^"<]*")*)(/?)>)re");
  const std::string body = xml.substr(xml.find("?>") + 2);
  std::vector<std::string> open;
  std::size_t tags = 0;
  for (std::sregex_iterator t(body.begin(), body.end(), tag), end; t != end; ++t, ++tags) {
    if ((*t)[1] == "/") {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), (*t)[2]);
      open.pop_back();
    } else if ((*t)[4] != "/") {
      open.push_back((*t)[2]);
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(tags, std::size_t(std::count(body.begin(), body.end(), '<')));
}

/// Returns how many data items were checked.
std::size_t expect_items_exist(const Folder& folder, const std::string& xml) {
  const std::regex item(
      R"re(<DataItem Format="HDF" NumberType="(Int|Float)" Precision="8" Dimensions="(\d+) (\d+)">([^:<]+):([^<]+)</DataItem>)re");
  std::size_t count = 0;
  for (std::sregex_iterator i(xml.begin(), xml.end(), item), end; i != end; ++i, ++count) {
    const Dataset d = read_hdf5(folder / (*i)[4], (*i)[5]);
    EXPECT_THAT(d.shape, ElementsAre(std::stoul((*i)[2]), std::stoul((*i)[3]))) << (*i)[5];
    EXPECT_EQ(d.integer, (*i)[1] == "Int") << (*i)[5];
  }
  return count;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

const FakeMesh mesh;
const FakeParticles particles;
const FakeBlock block;

void snapshot(FieldWriter& writer, std::size_t number, const FakeBody& body, long step, double time) {
  writer.snapshot(number, step, time, body.field(time).data(), body.field(100 + time).data());
}

/// A mesh and particles at time 0.
void write_first_frame(const Folder& folder) {
  FieldWriter writer(folder.path());
  writer.add_body("beam", mesh);
  writer.add_body("grains", particles);
  snapshot(writer, 0, mesh, 0, 0.0);
  snapshot(writer, 1, particles, 0, 0.0);
  writer.commit();
}

TEST(Fields, EveryCommitLeavesACompleteSet) {
  const Folder folder;
  FieldWriter writer(folder / "run");
  ASSERT_EQ(writer.add_body("beam <1> & \"co\"", mesh), 0u);
  ASSERT_EQ(writer.add_body("grains", particles), 1u);
  ASSERT_EQ(writer.add_body("block", block), 2u);
  const Folder& root = folder;
  for (std::size_t frame = 0; frame < 3; ++frame) {
    snapshot(writer, 0, mesh, 100 * frame, 0.25 * frame);
    snapshot(writer, 1, particles, 100 * frame, 0.25 * frame);
    snapshot(writer, 2, block, 100 * frame, 0.25 * frame);
    writer.commit();
    const std::string xml = read(root / "run/fields.xdmf");
    expect_well_formed(xml);
    EXPECT_EQ(count(xml, "CollectionType=\"Temporal\""), 1u);
    EXPECT_EQ(count(xml, "CollectionType=\"Spatial\""), frame + 1);
    EXPECT_EQ(count(xml, "GridType=\"Uniform\""), 3 * (frame + 1));
    EXPECT_EQ(count(xml, "beam &lt;1&gt; &amp; &quot;co&quot;"), frame + 1);
    EXPECT_EQ(root.files().size(), 2 + frame + 1);  // fields.xdmf, bodies.h5, snapshots: nothing temporary
  }
}

TEST(Fields, EveryPathInTheXdmfExists) {
  const Folder folder;
  FieldWriter writer(folder.path());
  writer.add_body("beam", mesh);
  writer.add_body("grains", particles);
  for (long step : {0, 7}) {
    snapshot(writer, 0, mesh, step, 0.1 * double(step));
    snapshot(writer, 1, particles, step, 0.1 * double(step));
    writer.commit();
  }
  const std::string xml = read(folder / "fields.xdmf");
  EXPECT_EQ(expect_items_exist(folder, xml), 2u * 2u * 8u);  // frames x bodies x (cells, points, six fields)
  EXPECT_EQ(count(xml, "<DataItem"), 32u);
  EXPECT_EQ(count(xml, "Center=\"Cell\""), 2u * 4u);
  EXPECT_EQ(count(xml, "<Time Value=\"0.7000000000000001\"/>"), 3u);  // 0.1 * 7 to the last bit
  EXPECT_THAT(
      folder.files(), ElementsAre("fields.xdmf", "fields/000000.h5", "fields/000001.h5", "fields/bodies.h5"));
}

/// Points come out of either layout without padding; a cell's stress is the mean over volumes 1 and 3: that
/// of its first point (1 2 3 4 5 6 + 20 e, as xx yy zz xy yz zx) plus 7.5.
TEST(Fields, ValuesAreThoseOfTheBodies) {
  const Folder folder;
  write_first_frame(folder);
  const std::string data = folder / "fields/000000.h5", bodies = folder / "fields/bodies.h5";

  EXPECT_THAT(read_hdf5(bodies, "/body0/cells").values, ElementsAre(0, 1, 4, 3, 1, 2, 5, 4));
  EXPECT_THAT(read_hdf5(bodies, "/body1/cells").values, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(read_hdf5(bodies, "/body1/points").values,
              ElementsAre(0, 3, 0, 0.5, 3, 0, 1, 3, 0, 1.5, 3, 0, 2, 3, 0));
  EXPECT_EQ(read_text_attribute(bodies, "/body1", "name"), "grains");
  EXPECT_THAT(read_hdf5(data, "/body1/displacement").values,
              ElementsAre(0, .1, 0, 1, 1.1, 0, 2, 2.1, 0, 3, 3.1, 0, 4, 4.1, 0));
  EXPECT_THAT(
      read_hdf5(data, "/body0/velocity").values,
      ElementsAre(100, 100.1, 0, 101, 101.1, 0, 102, 102.1, 0, 103, 103.1, 0, 104, 104.1, 0, 105, 105.1, 0));

  EXPECT_THAT(read_hdf5(data, "/body0/stress").values,
              ElementsAre(8.5, 11.5, 13.5, 11.5, 9.5, 12.5, 13.5, 12.5, 10.5, 28.5, 31.5, 33.5, 31.5, 29.5,
                          32.5, 33.5, 32.5, 30.5));
  const auto strain = read_hdf5(data, "/body1/strain").values;
  EXPECT_EQ(std::vector<double>(strain.begin() + 9, strain.begin() + 18),
            (std::vector<double>{
                .011, .014, .016, .014, .012, .015, .016, .015, .013}));  // exactly: no mean of one point
}

/// Adding pressure changes no deviator, but the shears 4 5 6 + 10 m grow: sqrt((1 + 1 + 4)/2 + 3 (xy^2 + yz^2
/// + zx^2)).
TEST(Fields, EquivalentStressIsVonMises) {
  const Folder folder;
  write_first_frame(folder);
  const auto expected = [](double m) {
    const double xy = 4 + 10 * m, yz = 5 + 10 * m, zx = 6 + 10 * m;
    return std::sqrt(3 + 3 * (xy * xy + yz * yz + zx * zx));
  };
  const std::string data = folder / "fields/000000.h5";
  EXPECT_THAT(read_hdf5(data, "/body1/equivalent_stress").values,
              Pointwise(testing::DoubleEq(),
                        std::vector{expected(0), expected(1), expected(2), expected(3), expected(4)}));
  EXPECT_THAT(
      read_hdf5(data, "/body0/equivalent_stress").values,
      Pointwise(testing::DoubleEq(),
                std::vector{(expected(0) + 3 * expected(1)) / 4, (expected(2) + 3 * expected(3)) / 4}));
}

TEST(Fields, UncommittedSnapshotsLeaveNothing) {
  const Folder folder;
  {
    FieldWriter writer(folder.path());
    writer.add_body("beam", mesh);
    snapshot(writer, 0, mesh, 0, 0.0);
  }
  EXPECT_TRUE(folder.files().empty());
}

/// What goes to disk behind the caller is what commit() puts there, in the same order; the next call has
/// waited for it.
TEST(Fields, CommittedLaterIsTheSame) {
  const Folder at_once, later;
  for (const Folder* folder : {&at_once, &later}) {
    FieldWriter writer(folder->path());
    writer.add_body("beam", mesh);
    for (long step : {0, 7, 14}) {
      snapshot(writer, 0, mesh, step, 0.1 * double(step));
      if (folder == &at_once)
        writer.commit();
      else
        writer.commit_later();
    }
    writer.settle();
    EXPECT_EQ(folder->files().size(), 5u);
    EXPECT_EQ(count(read(*folder / "fields.xdmf"), "CollectionType=\"Spatial\""), 3u);
  }
  for (const std::string& file : at_once.files()) EXPECT_EQ(read(at_once / file), read(later / file)) << file;
}

TEST(Fields, ALaterFailureIsReported) {
  const Folder folder;
  FieldWriter writer(folder.path());
  writer.add_body("beam", mesh);
  snapshot(writer, 0, mesh, 0, 0.0);
  writer.commit();
  const std::string before = read(folder / "fields.xdmf");
  std::filesystem::create_directory(folder / "fields/000001.h5");
  snapshot(writer, 0, mesh, 1, 0.1);
  writer.commit_later();
  EXPECT_THAT([&] { snapshot(writer, 0, mesh, 2, 0.2); },
              ThrowsMessage<std::runtime_error>(HasSubstr("fields/000001.h5: Is a directory")));
  EXPECT_EQ(read(folder / "fields.xdmf"), before);  // the last good state
  std::filesystem::remove(folder / "fields/000001.h5");
  snapshot(writer, 0, mesh, 2, 0.2);  // replaces what was lost
  writer.commit();
  EXPECT_EQ(expect_items_exist(folder, read(folder / "fields.xdmf")), 2u * 8u);
}

TEST(Fields, AnEarlierRunIsRemovedAndNothingElse) {
  const Folder folder;
  std::filesystem::create_directory(folder / "fields");
  for (const char* name :
       {"fields.xdmf", "fields/bodies.h5", "fields/000041.h5", "fields/mine.h5", "other.csv"})
    std::ofstream(folder / name) << "before";
  const FieldWriter writer(folder.path());
  EXPECT_THAT(folder.files(), ElementsAre("fields/mine.h5", "other.csv"));
}

TEST(Fields, SaysWhatIsInTheWay) {
  const Folder folder;
  std::ofstream(folder / "file") << "x";
  EXPECT_THAT(
      [&] { FieldWriter writer(folder / "file"); },
      ThrowsMessage<std::runtime_error>(AllOf(HasSubstr(folder / "file"), HasSubstr("Not a directory"))));
  FieldWriter writer(folder / "other");
  writer.add_body("beam", mesh);
  snapshot(writer, 0, mesh, 0, 0.0);
  std::filesystem::create_directory(folder / "other/fields/000000.h5");
  EXPECT_THAT([&] { writer.commit(); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr(folder / "other/fields/000000.h5"), HasSubstr("Is a directory"))));
}

TEST(Fields, MisuseIsReported) {
  const Folder folder;
  FieldWriter writer(folder.path());
  writer.add_body("beam", mesh);
  snapshot(writer, 0, mesh, 0, 0.0);
  EXPECT_THROW(snapshot(writer, 0, mesh, 1, 0.1), std::logic_error);
  writer.commit();
  EXPECT_THROW(writer.add_body("late", particles), std::logic_error);
}

}  // namespace
}  // namespace femsph::test
