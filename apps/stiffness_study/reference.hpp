// What the right velocities are.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "measure.hpp"

namespace mariotte::stiffness_study {

struct Reference {
  std::vector<double> velocity;  ///< relative to the incident speed
  std::string source;            ///< "stored", "closed form" or "<flow> at <accuracy>"
};

/// Velocities / v do not depend on k, m and v but through the damping group, so one reference serves a whole
/// scaling family: stored numbers of extended precision where there are, the closed form of the linear
/// triplet, otherwise another flow at a hundredth of the accuracy.
class References {
 public:
  /// A flow that needs longer than `patience` [s] for a reference is not asked again in this study.
  explicit References(double patience) : patience_(patience) {}

  /// For a run whose contact phases were followed by `used` at `accuracy`; empty if nothing can tell.
  std::optional<Reference> find(const ImpactCase& one, const std::vector<std::string>& used, double accuracy);

 private:
  std::optional<Reference> computed(const ImpactCase& unit, const std::string& flow, double accuracy);

  double patience_;
  std::map<std::string, std::optional<Reference>> known_;
  std::map<std::string, double> slowest_;  ///< of a flow in a family [s]
};

}  // namespace mariotte::stiffness_study
