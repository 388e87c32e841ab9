#include "slopes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "differences.hpp"
#include "measuring/timing.hpp"

namespace mariotte::stress_study {
namespace {

using impact::Sensitivity;

/// Differences of which more than this share of the slope is uncertain cannot tell anything.
constexpr double most_doubt = 1e-4;
/// CPU time of slopes beyond which a brisk campaign leaves a scene out; differences take hundreds of runs
/// [s].
constexpr double most_brisk_seconds = 0.01;
/// Slopes that may be off by more than this are left out.
constexpr double left_out_from = 0.1;
/// By how much of their units numbers are moved to tell how slopes follow.
constexpr double perturbation = 1e-6;

/// Slopes by one number in natural units; what has none is not a number.
std::vector<double> column(const Sensitivity& slopes, std::size_t c, double unit,
                           const std::vector<double>& sizes) {
  std::vector<double> list;
  for (std::size_t i = 0; i < slopes.outcome.size(); ++i)
    list.push_back(slopes.outcome[i].slope[c].value_or(std::nan("")) * unit / sizes[i]);
  return list;
}

double largest(const std::vector<double>& list) {
  double most = 1;
  for (const double one : list)
    if (std::isfinite(one)) most = std::max(most, std::abs(one));
  return most;
}

class SlopeExamination {
 public:
  SlopeExamination(const SlopeSubject& subject, std::uint64_t number, const Announce& announce, bool brisk)
      : subject_(subject), announce_(announce), brisk_(brisk) {
    verdict_.scene = number;
  }

  Verdict verdict() {
    for (const double accuracy : accuracies) {
      announce_(fmt::format("slopes at {:.0e}", accuracy));
      const double start = measuring::cpu_seconds();
      slopes_.push_back(subject_.slopes(accuracy));
      verdict_.seconds = measuring::cpu_seconds() - start;
      if (brisk_ && verdict_.seconds > most_brisk_seconds) return left_out(verdict_.scene);
    }
    sizes_ = outcome_sizes(slopes_.back(), subject_);
    for (std::size_t c = 0; c < subject_.probes.size(); ++c) {
      const auto steepness = largest(own_column(slopes_.back(), c));
      compare(c, differences(announced(subject_.probes[c]), slopes_.back(), sizes_, steepness));
    }
    return verdict_;
  }

 private:
  std::vector<double> own_column(const Sensitivity& slopes, std::size_t c) const {
    return column(slopes, c, subject_.probes[c].unit, sizes_);
  }
  /// Each of its runs may take as long as any.
  Probe announced(Probe probe) const {
    probe.outcomes = [this, name = probe.name, run = probe.outcomes](double value) {
      announce_("run with another " + name);
      return run(value);
    };
    return probe;
  }
  /// Unless a note of the slopes at accuracy k says that outcome i by number c may be off by so much.
  void find(const std::string& what, std::size_t k, std::size_t i, std::size_t c, double share) {
    const auto& notes = slopes_[k].notes;
    const auto excuses = [&](const impact::SlopeNote& note) {
      return concerns(note, name_of(slopes_[k].outcome[i]), subject_.probes[c].name) &&
             share <= tolerated * note.error;
    };
    if (std::any_of(notes.begin(), notes.end(), excuses))
      ++verdict_.refusals;
    else
      verdict_.findings.push_back(what);
  }

  void compare(std::size_t c, const Differences& expected) {
    const auto best = own_column(slopes_.back(), c);
    const double size = largest(best);
    for (std::size_t i = 0; i < best.size(); ++i) {
      const auto& outcome = slopes_.back().outcome[i];
      if (!(sizes_[i] > 0) || !outcome.value) continue;
      const auto what =
          fmt::format("{}[{}] by {}", outcome.name, outcome.index.value_or(0), subject_.probes[c].name);
      if (std::isnan(best[i]))
        find(what + " has no slope, and no note says why", accuracies.size() - 1, i, c, left_out_from);
      else
        compare_one(what, c, i, expected.of(i), size);
    }
  }

  /// Deviations count that differences can tell, and that the scene does not amplify. A contact that creeps
  /// may let go at one accuracy and not at another, and so end the run; both results say which.
  void compare_one(const std::string& what, std::size_t c, std::size_t i,
                   const std::vector<const Estimate*>& expected, double size) {
    const bool is_told = std::all_of(expected.begin(), expected.end(),
                                     [&](const Estimate* one) { return one->doubt[i] <= most_doubt * size; });
    if (expected.empty() || !is_told) return;
    verdict_.naive = true;
    for (std::size_t k = 0; k < accuracies.size(); ++k) {
      if (slopes_[k].ending != slopes_.back().ending) {
        ++verdict_.refusals;
        continue;
      }
      const double own = own_column(slopes_[k], c)[i];
      const auto [error, nearest] = deviation(own, i, expected);
      const double share = error / size;
      verdict_.error[k] = std::max(verdict_.error[k], share / accuracies[k]);
      verdict_.worst = std::max(verdict_.worst, share / accuracies[k]);
      if (share <= tolerated * accuracies[k]) continue;
      const double growth = std::max(amplification(c)[i], delay(i)) / size;
      if (share <= tolerated * accuracies[k] * growth) continue;
      find(fmt::format(
               "{} is {:.12g} at {:.0e}, differences {:.12g} ± {:.1e}; perturbations grow {:.2g} times", what,
               own, accuracies[k], nearest->slope[i], nearest->doubt[i], growth),
           k, i, c, share);
    }
  }

  /// From the nearest of the slopes that there may be, beyond its doubt.
  static std::pair<double, const Estimate*> deviation(double own, std::size_t i,
                                                      const std::vector<const Estimate*>& expected) {
    std::pair<double, const Estimate*> least{infinity, nullptr};
    for (const Estimate* one : expected) {
      const double error = std::max(0.0, std::abs(own - one->slope[i]) - tolerated * one->doubt[i]);
      if (error < least.first) least = {error, one};
    }
    return least;
  }

  /// By how much slopes by number c move with the numbers of the scene.
  const std::vector<double>& amplification(std::size_t c) {
    auto& known = amplification_[c];
    if (!known.empty()) return known;
    const auto before = own_column(subject_.slopes(tight), c);
    known.assign(before.size(), 0.0);
    for (const auto& probe : subject_.probes) {
      announce_("slopes" + std::string(perturbed_mark));
      const auto after = own_column(probe.slopes(probe.value + perturbation * probe.unit), c);
      for (std::size_t i = 0; i < std::min(after.size(), known.size()); ++i)
        known[i] = std::max(known[i], std::abs(after[i] - before[i]) / perturbation);
    }
    return known;
  }

  /// By how much an instant moves with any number of the scene, relative to itself: balls that meet late and
  /// slowly meet at another time for every error of their velocities.
  double delay(std::size_t i) {
    if (slopes_.back().outcome[i].unit != "s" || !subject_.all_slopes) return 0;
    announce_("slopes by all numbers");
    if (!all_slopes_) all_slopes_ = subject_.all_slopes();
    double most = 0;
    for (std::size_t c = 0; c < subject_.all_units.size(); ++c)
      if (const auto slope = all_slopes_->outcome[i].slope[c])
        most = std::max(most, std::abs(*slope * subject_.all_units[c] / sizes_[i]));
    return most;
  }

  const SlopeSubject& subject_;
  const Announce& announce_;
  bool brisk_;
  std::vector<Sensitivity> slopes_;
  std::optional<Sensitivity> all_slopes_;  ///< at the best accuracy, where they are needed
  std::vector<double> sizes_;
  std::map<std::size_t, std::vector<double>> amplification_;  ///< by number and outcome
  Verdict verdict_;
};

}  // namespace

Verdict examine_slopes(const SlopeSubject& subject, std::uint64_t number, const Announce& announce,
                       bool brisk) {
  return SlopeExamination(subject, number, announce, brisk).verdict();
}

}  // namespace mariotte::stress_study
