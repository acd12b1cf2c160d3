#pragma once
// Runs the program as a user does.

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace femsph::test {

struct Outcome {
  int code;          ///< the exit code
  std::string text;  ///< of both streams
};

/// Runs `femsph ARGUMENTS` in a shell.
inline Outcome run_femsph(const std::string& arguments) {
  Outcome o{-1, {}};
  FILE* pipe = popen(fmt::format("{} {} 2>&1", FEMSPH_PROGRAM, arguments).c_str(), "r");
  std::array<char, 4096> buffer;
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) o.text.append(buffer.data(), n);
  o.code = WEXITSTATUS(pclose(pipe));
  return o;
}

}  // namespace femsph::test
