#include "compare/run/interruption.hpp"

#include <atomic>
#include <csignal>

namespace femsph::compare {

namespace {

std::atomic<bool> flag{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal handler may set no other kind

void set_flag(int) { flag.store(true, std::memory_order_relaxed); }

void handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
  flag = false;
  handle(set_flag);
}

Interruption::~Interruption() { handle(SIG_DFL); }

bool Interruption::asked() const { return flag.load(std::memory_order_relaxed); }

}  // namespace femsph::compare
