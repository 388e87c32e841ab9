// All runs of one scene, and what they come to.
#pragma once
#include <array>
#include <cstdint>
#include <functional>

#include "family.hpp"
#include "judge.hpp"

namespace mariotte::stress_study {

/// Accuracies that `auto` is asked for at least, and the one that it is measured against.
inline constexpr std::array accuracies = {1e-6, 1e-8, 1e-10};
inline constexpr double tight = 1e-12;

/// Those of one scene: down to a tenth of these, since steps that are too long by chance are so at some
/// alone.
std::array<double, accuracies.size()> accuracies_of(std::uint64_t scene);

/// What a table needs of one scene.
struct Verdict {
  std::uint64_t scene = 0;
  std::array<double, accuracies.size()> error{};  ///< of `auto` over its accuracy; < 0 if not known
  double worst = 0;                               ///< of all runs, likewise
  double seconds = 0;                             ///< of `auto` at the last accuracy
  double cost = 0;                                ///< CPU time of all runs
  bool naive = false;                             ///< the naive simulator could follow it
  bool counts_differ = false;
  bool left_out = false;  ///< it takes too long for a brisk campaign
  int failures = 0, limits = 0, refusals = 0, killed = 0, rivals = 0;
  std::vector<std::string> findings = {};
};

/// Of a scene that takes too long for a brisk campaign.
inline Verdict left_out(std::uint64_t scene) {
  return {.scene = scene, .error = {-1, -1, -1}, .left_out = true};
}

/// Told what is about to be run.
using Announce = std::function<void(const std::string&)>;

/// What is announced of runs of perturbed scenes ends with this.
inline constexpr const char* perturbed_mark = ", perturbed";

/// What is left out of an examination.
struct Extent {
  bool spare = false;  ///< the flow asked for by name, and the general one for amplification
  bool brisk = false;  ///< the flow asked for by name, and scenes that take long
};

Verdict examine(const std::vector<Family>& list, std::uint64_t seed, std::uint64_t number,
                const Announce& announce, const Extent& extent = {});

}  // namespace mariotte::stress_study
