// How far the directions of contacts would turn if they did not stay those of the start.
#pragma once
#include <cmath>
#include <vector>

#include "mariotte/core/scale.hpp"
#include "mariotte/flow/flow.hpp"
#include "mariotte/model/contacts/contact_phase.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::impact {

/// Follows the centres of the balls of a network. The direction of a contact would turn by what they move
/// across it, divided by the distance between them; contacts that are open do not count.
class TurningObserver {
 public:
  /// Both must outlive this; the network is one of balls.
  TurningObserver(const model::Network& network, const model::ContactPhase& phase, const Scale& scale);

  void observe(const flow::Step& step);
  double largest() const { return std::atan(largest_); }  ///< so far [rad]

 private:
  double across(Index contact) const;

  const model::Network& network_;
  const model::ContactPhase& phase_;
  double length_;              ///< of one unit of `moved_` [m]
  std::vector<double> moved_;  ///< every coordinate since the start
  std::vector<double> inside_;
  double largest_ = 0;  ///< tangent
};

}  // namespace mariotte::impact
