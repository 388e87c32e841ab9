// The linear equations between the values of a piece's components at its Gauss points,
//
//   Z_i = R_i + Σ_j a_ij h_j J_j Z_j.
//
// Components that do not depend on each other, such as gaps, which depend on velocities alone, are eliminated
// by hand: half of the unknowns, and seven eighths of a division. What nothing acts on in this piece, such as
// balls in flight, is known.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "mariotte/flow/flow.hpp"

namespace mariotte::impact {

class StageSystem {
 public:
  /// `position` of a component among those that rates depend on, or −1; their natural sizes.
  StageSystem(const std::vector<flow::Entry>& pattern, const std::vector<Index>& position,
              std::vector<double> magnitude);
  ~StageSystem();

  /// Unknowns of a division, at most.
  Index unknowns() const;
  /// Adds to values what sources have given at each point: theirs at all points one component after the
  /// other.
  void add_integral(Index component, std::span<const double> source, std::span<double> values) const;
  /// R becomes Z: values by point and component, one such row after the other. Entries of J by point, and h.
  void solve(const std::vector<double>* jacobian, const double* h, std::span<double> values);

 private:
  class Equations;
  std::unique_ptr<Equations> equations_;
};

}  // namespace mariotte::impact
