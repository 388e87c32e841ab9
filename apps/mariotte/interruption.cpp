#include "interruption.hpp"

#include <csignal>

namespace mariotte::command {
namespace {

volatile std::sig_atomic_t noted = 0;

extern "C" void note_signal(int signal) {
  noted = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void await_interruption() {
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

int interruption() {
  return noted;
}

}  // namespace mariotte::command
