// Ways through a long row.
#pragma once
#include <string>
#include <vector>

#include "measurement.hpp"

namespace mariotte::scaling_study {

/// What becomes of the wave once it is steady.
enum class Wave { moved_on, followed };

/// This library, asked for an accuracy. Repeated while the least CPU time may still fall.
Measurement measure_own(std::size_t balls, double accuracy, Wave wave);

/// A method that integrates every ball at every step, set to errors of 1e-8 … 1e-6 at a thousand balls.
struct Rival {
  std::string name;
  Measurement (*measure)(std::size_t balls);
};

/// CVODE by Adams, Boost.odeint by a Runge–Kutta–Fehlberg pair of orders 7 and 8, velocity Verlet.
std::vector<Rival> rivals();

Measurement measure_cvode(std::size_t balls);
Measurement measure_odeint(std::size_t balls);
Measurement measure_verlet(std::size_t balls);

}  // namespace mariotte::scaling_study
