// Any bytes as a study beside the scenes of tests/scenes: a Study, or an InputError.

#include "compare/study/reader/study.hpp"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  try {
    femsph::compare::parse_study(
        std::string(reinterpret_cast<const char*>(data), size), FEMSPH_SOURCE_DIR "/tests/scenes/study.toml");
  } catch (const femsph::InputError& e) {
    if (e.faults().empty()) std::abort();
  }
  return 0;
}
