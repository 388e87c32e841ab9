// Ctrl-C while C++ runs without the interpreter's lock.
#pragma once
#include <pybind11/pybind11.h>

#include <chrono>

namespace mariotte::python {

/// Asked again and again by the thread that called from Python, which does not hold the lock. Every 50 ms it
/// looks for a signal; what its handler raises, as KeyboardInterrupt, ends the run.
class Interruption {
 public:
  void operator()() {
    const auto now = Clock::now();
    if (now - looked_ < std::chrono::milliseconds(50)) return;
    looked_ = now;
    const pybind11::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point looked_ = Clock::now();
};

}  // namespace mariotte::python
