#include "judge.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mariotte::stress_study {
namespace {

using hybrid::Ending;

/// One is captured, and the other flies off.
bool ends_otherwise(const Found& one, const Found& other) {
  return (one.ending == Ending::captured) != (other.ending == Ending::captured);
}

double deviation(const Trial& trial, const Trial& best) {
  return ends_otherwise(trial.found, best.found) ? 1 : distance(trial.found, best.found);
}

/// Failures and limits; true if the run can be compared.
bool take_ending(const Trial& trial, Judgement& judgement) {
  const auto& found = trial.found;
  if (has_ended(found)) return true;
  if (found.refused) {
    ++judgement.refusals;
  } else if (trial.rival) {
    ++judgement.rivals;
  } else if (found.ending == Ending::event_limit) {
    ++judgement.limits;
    if (!trial.many_events)
      judgement.findings.push_back(
          fmt::format("{}: {} events in less time than so many contacts need", trial.name, most_events));
  } else {
    ++judgement.failures;
    judgement.findings.push_back(
        fmt::format("{}: {}: {}", trial.name, hybrid::name(found.ending), found.message));
  }
  return false;
}

void take_deviation(const Trial& trial, const Trial& best, const Measure& measure, Judgement& judgement) {
  const double error = std::max(0.0, deviation(trial, best) - best.found.rounding);
  judgement.worst = std::max(judgement.worst, error / trial.accuracy);
  if (error <= tolerated * std::max(trial.accuracy, trial.found.estimate)) return;
  const bool is_number = error < infinity;  // nothing explains what is not
  const double needed = error / (tolerated * trial.accuracy);
  const double amplification = is_number ? std::max(1.0, measure(trial.accuracy, needed).amplification) : 1;
  if (needed <= amplification) return;
  judgement.findings.push_back(
      fmt::format("{} and {} differ by {:.3g}, {:.2g} times what may be; perturbations grow {:.2g} times",
                  trial.name, best.name, error, error / trial.accuracy, amplification));
}

void take_balance(const Trial& trial, Judgement& judgement) {
  const double imbalance = trial.found.imbalance - trial.found.rounding;
  if (imbalance <= tolerated * std::max(trial.accuracy, trial.found.estimate)) return;
  judgement.findings.push_back(
      fmt::format("{}: a balance does not close: {:.3g} of the energy", trial.name, imbalance));
}

/// Peaks are told to fewer digits than velocities.
void take_peaks(const Trial& trial, Judgement& judgement) {
  constexpr double gross = 1e-3;
  if (trial.found.peak_misfit <= gross) return;
  judgement.findings.push_back(fmt::format("{}: a largest force is {:.2g} of the largest of all off its law",
                                           trial.name, trial.found.peak_misfit));
}

/// Periods that bring no impulse beyond the tolerance are below what was asked for: whether a touch counts as
/// one, or a rest as two, is decided by less.
bool same_impulses(const Trial& trial, const Trial& best) {
  const auto& one = trial.found.impulse;
  const auto& other = best.found.impulse;
  for (std::size_t j = 0; j < std::min(one.size(), other.size()); ++j)
    if (!(std::abs(one[j] - other[j]) <= tolerated * trial.accuracy)) return false;
  return one.size() == other.size() && !one.empty();
}

void take_counts(const Trial& trial, const Trial& best, const Measure& measure, Judgement& judgement) {
  if (!trial.counts || trial.found.periods == best.found.periods) return;
  judgement.counts_differ = true;
  if (same_impulses(trial, best)) return;
  for (const double size : {trial.accuracy, tolerated * trial.accuracy})
    if (measure(size, infinity).counts_change) return;
  judgement.findings.push_back(fmt::format("contact periods: {} of {}, {} of {}",
                                           fmt::join(trial.found.periods, " "), trial.name,
                                           fmt::join(best.found.periods, " "), best.name));
}

}  // namespace

bool has_ended(const Found& found) {
  return !found.refused && (found.ending == Ending::separated || found.ending == Ending::captured ||
                            found.ending == Ending::time_limit);
}

Judgement judge(const Trial& best, const std::vector<Trial>& trials, const Measure& measure) {
  Judgement judgement;
  const bool comparable = take_ending(best, judgement);
  if (comparable) take_balance(best, judgement);
  for (const auto& trial : trials) {
    if (!take_ending(trial, judgement)) continue;
    take_balance(trial, judgement);
    take_peaks(trial, judgement);
    if (!comparable) continue;
    take_deviation(trial, best, measure, judgement);
    take_counts(trial, best, measure, judgement);
  }
  return judgement;
}

}  // namespace mariotte::stress_study
