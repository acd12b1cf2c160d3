#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "model/results/record.hpp"

namespace femsph {

namespace {

constexpr double interval = 0.2;  // s

bool can_overwrite_lines() {
  const char* kind = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) && kind && std::string_view(kind) != "dumb";
}

/// Longer lines would wrap and could not be overwritten.
std::size_t terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col - 1u : 79u;
}

std::string duration(double seconds) {
  const long s = long(seconds + 0.5);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
}

}  // namespace

std::string progress_line(const std::string& what, long step, long steps, double time,
                          double steps_per_second) {
  std::string line = fmt::format("{}: step {}", what, step);
  if (steps > 0) line += fmt::format(" of {}", steps);
  line += fmt::format(", t = {:.4g} s", time);
  if (steps_per_second <= 0) return line;
  line += fmt::format(", {:.4g} steps/s", steps_per_second);
  if (steps > step) line += fmt::format(", {} left", duration(double(steps - step) / steps_per_second));
  return line;
}

Progress::Progress(std::string what)
    : what_(std::move(what)), last_(wall_seconds()), terminal_(can_overwrite_lines()) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(long step, long steps, double time) {
  if (!terminal_) return;
  const double now = wall_seconds();
  if (first_ < 0) {
    first_ = step;
    start_ = now;
  }
  if (now - last_ < interval) return;
  last_ = now;
  shown_ = true;
  const double rate = now > start_ ? double(step - first_) / (now - start_) : 0.0;
  fmt::print(stderr, "\r{}\033[K", progress_line(what_, step, steps, time, rate).substr(0, terminal_width()));
  std::fflush(stderr);
}

}  // namespace femsph
