// A history given as a table, to compare with.

#include <gmock/gmock.h>

#include <cmath>

#include "compare/measure/errors.hpp"
#include "compare/reference/reference_table.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::HasSubstr;

class ReferenceFile : public ::testing::Test {
 protected:
  test::Folder folder{"table"};
  std::string message(const std::string& text) {
    try {
      read_reference_table(folder.write("x.csv", text), "m");
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "";
  }
};

/// Of a history that is 1 % too large everywhere the distance is 1 %, whatever units the table has and
/// wherever its rows lie.
TEST_F(ReferenceFile, IsComparedInSiOverTheTimesInCommon) {
  const ReferenceTable table = read_reference_table(
      folder.write("x.csv", "time [ms],tip [mm]\n0,0\n1,2\r\n2,4\n"), "m");
  EXPECT_DOUBLE_EQ(table.value[2], 4e-3);
  EXPECT_DOUBLE_EQ(table.at[2], 2e-3);
  const std::vector<double> at{0, 0.3e-3, 0.9e-3, 1.7e-3, 5e-3},
      value{0, 1.01 * 0.6e-3, 1.01 * 1.8e-3, 1.01 * 3.4e-3, 99};
  EXPECT_NEAR(percent_from(table, at, value), 1, 1e-9);  // the last lies beyond the table
  EXPECT_THROW(percent_from(table, {3e-3, 4e-3}, {1, 1}), std::runtime_error);
}

TEST_F(ReferenceFile, SaysWhatIsWrongWithItsLine) {
  EXPECT_THAT(message("time,tip\n0,1\n1,1\n"),
              HasSubstr("x.csv:1: the column \"time\" has no unit; expected it in brackets"));
  EXPECT_THAT(message("time [s],tip [N]\n0,1\n1,1\n"), HasSubstr("expected one of the same kind as \"m\""));
  EXPECT_THAT(
      message("time [s],tip [m]\n0,1\n1,\n"), HasSubstr("x.csv:3: \"1,\" is not a row of two numbers"));
  EXPECT_THAT(message("time [s],tip [m]\n0,1\n1,nan\n"), HasSubstr("x.csv:3:"));
  EXPECT_THAT(message("time [s],tip [m]\n0,1\n0,2\n"), HasSubstr("x.csv:3: the times do not increase"));
  EXPECT_THAT(message("time [s],tip [m]\n0,1\n"), HasSubstr("at least two rows"));
}

}  // namespace
}  // namespace femsph::compare
