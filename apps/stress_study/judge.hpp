// What the runs of one scene say about each other.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "run.hpp"

namespace mariotte::stress_study {

/// A run, and the error that it may have.
struct Trial {
  std::string name = {};
  double accuracy = 0;
  Found found = {};
  bool counts = false;       ///< its contact periods are compared, too
  bool many_events = false;  ///< so many that a limit of events is no fault
  bool rival = false;        ///< by a flow that was asked for by name, and may not be made for the scene
};

/// How results follow inputs.
struct Sensitivity {
  double amplification = 1;    ///< largest change of results over that of inputs
  bool counts_change = false;  ///< so do numbers of contact periods
};
/// Measured with perturbations of a size, relative to what is natural, until the amplification is `enough`.
/// Asked only if something needs to be explained.
using Measure = std::function<Sensitivity(double size, double enough)>;

/// What is wrong with a scene.
struct Judgement {
  double worst = 0;                        ///< deviation over what the run may have
  bool counts_differ = false;              ///< of contact periods, whatever explains it
  int failures = 0;                        ///< runs that failed, or were unsure
  int limits = 0;                          ///< runs that were given up after too many events
  int refusals = 0;                        ///< runs refused by name
  int rivals = 0;                          ///< runs of rivals that came to no end
  std::vector<std::string> findings = {};  ///< what nothing explains, a sentence each
};

/// Deviations above this many times the accuracy need an explanation.
inline constexpr double tolerated = 10;

/// Compare trials with the best run. A deviation is explained up to `tolerated` × accuracy × amplification.
Judgement judge(const Trial& best, const std::vector<Trial>& trials, const Measure& measure);

/// Whether a run came to an end that can be compared.
bool has_ended(const Found& found);

}  // namespace mariotte::stress_study
