// What a campaign has found, family by family.
#pragma once
#include <string>
#include <vector>

#include "examine.hpp"

namespace mariotte::stress_study {

/// Everything about the scenes of one family.
struct Tally {
  std::string family;
  std::uint64_t scenes = 0, left_out = 0, naive = 0, counts_differ = 0, failures = 0, killed = 0,
                refusals = 0, rivals = 0;
  std::uint64_t unexplained = 0;           ///< scenes with findings
  std::uint64_t runs = 0, within[3] = {};  ///< runs of `auto` that can be judged; within 1, 10, 100 ×
  double cost = 0;                         ///< CPU time [s]
  double worst = 0;                        ///< deviation over what was asked
  std::uint64_t worst_scene = 0;
  std::vector<float> seconds = {};  ///< of `auto`, per scene
};

void add(const Verdict& verdict, Tally& tally);

/// Scenes slower than 100 × the median.
std::uint64_t slow(const Tally& tally);

/// A row per family of which there are scenes, and their sum.
std::string table(const std::vector<Tally>& tallies);

}  // namespace mariotte::stress_study
