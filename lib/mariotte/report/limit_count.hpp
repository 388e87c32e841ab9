// How many of many runs are beyond the limits of their model. Some of them are looked at.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mariotte/scene/scene.hpp"

namespace mariotte::report {

/// One in ten of `count` runs, from 0, the ends among them, but no more than 8.
std::vector<Index> some_of(Index count);

class LimitCount {
 public:
  /// Simulates a scene as a whole, if it may have a number of the validity.
  void look(const scene::Scene& scene);

  Index invalid() const { return invalid_; }  ///< runs that ended so

  /// "at 2 of 8 points that were looked at, max a/R is above 0.1: strains are …" for each limit; `points` is
  /// what the runs are called, and `option` what its key stands behind, if that is to be told.
  std::vector<std::string> sentences(std::size_t looked_at, const char* points,
                                     const char* option = "") const;

 private:
  std::array<Index, impact::validity_limits.size()> beyond_ = {};
  Index invalid_ = 0;
};

}  // namespace mariotte::report
