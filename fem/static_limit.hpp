#pragma once

#include <map>
#include <string>
#include <vector>

namespace femsph::fem {

/// A converged static solution: the values at the probes and along the sections of a scene.
struct StaticLimit {
  std::map<std::string, std::vector<double>> probes;
  std::map<std::string, std::vector<std::vector<double>>> sections;  ///< per section, per point
};

}  // namespace femsph::fem
