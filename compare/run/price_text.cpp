#include <fmt/format.h>

#include <algorithm>

#include "compare/run/run.hpp"

namespace femsph::compare {

std::string price_text(const Price& p, const std::string& unit) {
  std::string text = fmt::format(
      "  {:<24} {:.3g} s CPU ({:.3g} s with set-up); {:.3g} s wall, {} thread{}; {} steps, {:.3g} ns a step "
      "and {}; {:.3g} MB held, peak memory {:.3g} MB\n",
      "price", p.cpu, p.total_cpu, p.wall, p.threads, p.threads == 1 ? "" : "s", p.steps, p.nanoseconds(),
      unit, double(p.bytes) / 1e6, double(peak_memory()) / 1e6);
  // Set-up and the critical step come before the march; the other phases are parts of it.
  double march = p.wall;
  std::string phases;
  for (const auto& [phase, seconds] : p.phases) {
    phases += fmt::format("{}{} {:.3g} s", phases.empty() ? "" : ", ", phase, seconds);
    if (phase != "setup" && phase != "critical step") march -= seconds;
  }
  return text + fmt::format("  {:<24} {}{}march {:.3g} s (wall)\n", "phases", phases,
                            phases.empty() ? "" : ", ", std::max(0.0, march));
}

}  // namespace femsph::compare
