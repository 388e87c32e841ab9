#include "interruption.hpp"

#include <signal.h>
#include <time.h>

#include <csignal>

namespace mariotte::command {
namespace {

volatile std::sig_atomic_t noted = 0;
volatile time_t since = 0;

time_t now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec;
}

extern "C" void note_signal(int signal) {
  if (noted == 0) {
    since = now();
    noted = signal;
  } else if (now() - since > 1) {
    std::signal(signal, SIG_DFL);
    ::raise(signal);
  }
}

void await(int signal) {
  struct sigaction action {};
  action.sa_handler = note_signal;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void await_interruption() {
  await(SIGINT);
  await(SIGTERM);
  struct sigaction hangup {};
  ::sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) await(SIGHUP);  // nohup ignores it
}

int interruption() {
  return noted;
}

}  // namespace mariotte::command
