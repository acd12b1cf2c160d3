#include "compare/report/readme.hpp"

#include <stdexcept>

namespace femsph::compare {

bool has_table(const std::string& readme, const std::string& name) {
  return readme.find("<!-- femsph:" + name + " -->") != std::string::npos;
}

std::string with_table(const std::string& readme, const std::string& table, const std::string& name) {
  const std::string opens = "<!-- femsph:" + name + " -->", closes = "<!-- /femsph:" + name + " -->";
  const auto open = readme.find(opens), close = readme.find(closes);
  const bool once = open != std::string::npos && close != std::string::npos &&
                    readme.find(opens, open + 1) == std::string::npos &&
                    readme.find(closes, close + 1) == std::string::npos;
  if (!once || close < open)
    throw std::runtime_error("expected one line " + opens + " and, after it, one line " + closes);
  const std::string gap = table.ends_with("\n") ? "\n" : "\n\n";
  return readme.substr(0, open + opens.size()) + "\n\n" + table + gap + readme.substr(close);
}

}  // namespace femsph::compare
