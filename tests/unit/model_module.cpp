// The program loads a module only from its own build: a module that is missing, or of another build, gives
// one clear message.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "model/numerics/module.hpp"

namespace femsph {
namespace {

using testing::HasSubstr;

std::string refusal_of(const std::string& name, const char* build) {
  try {
    open_module(name, build);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "opened";
}

TEST(Module, OneOfAnotherBuildIsRefused) {
  const std::string why = refusal_of("femsph_gmsh", "another");
  EXPECT_THAT(why, HasSubstr("libfemsph_gmsh.so belongs to another build of femsph ("));
  EXPECT_THAT(why, HasSubstr("; expected another): build or install femsph whole"));
}

TEST(Module, AMissingOneIsNamed) {
  EXPECT_THAT(
      refusal_of("femsph_absent", ""),
      HasSubstr("the module libfemsph_absent.so of unit_model is missing; expected beside the program"));
}

}  // namespace
}  // namespace femsph
