#include "model/scene/shapes/child.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>

namespace femsph {
namespace {

void limit(decltype(RLIMIT_CPU) what, rlim_t most) {
  rlimit now{};
  getrlimit(what, &now);
  now.rlim_cur = std::min(now.rlim_cur, most);
  setrlimit(what, &now);
}

#ifndef FEMSPH_SANITIZED  // the shadow memory of sanitizers takes terabytes
std::size_t address_space() {
  std::size_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%zu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * std::size_t(sysconf(_SC_PAGESIZE));
}
#endif

void confine(const ChildLimits& limits) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS})
    std::signal(signal, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds);
  alarm(20 * limits.seconds);
#ifndef FEMSPH_SANITIZED
  if (const std::size_t now = address_space()) limit(RLIMIT_AS, now + limits.bytes);
#endif
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
}

bool write_all(int to, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t n = write(to, bytes.data() + at, bytes.size() - at);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += std::size_t(n);
  }
  return true;
}

}  // namespace

bool in_child(const std::function<std::string()>& work, const ChildLimits& limits, std::string& result,
              const std::function<void()>& prepare) {
  int ends[2];
  if (pipe(ends) != 0) return false;
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    bool done = false;
    try {
      if (prepare) prepare();
      confine(limits);
      done = write_all(ends[1], work());
    } catch (...) {
    }
    _exit(done ? 0 : 1);  // no destructors, which would act on the parent's resources
  }
  close(ends[1]);
  result.clear();
  char some[1 << 16];
  while (child > 0) {
    const ssize_t n = read(ends[0], some, sizeof some);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    result.append(some, std::size_t(n));
  }
  close(ends[0]);
  if (child < 0) return false;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace femsph
