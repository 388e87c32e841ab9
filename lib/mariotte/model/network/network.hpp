// A contact network: any number of degrees of freedom, and contacts whose gap rates are linear in their
// velocities.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/network/mass_matrix.hpp"

namespace mariotte::model {

/// n dofs with a constant mass matrix M, m contacts with directions G, M v̇ = Gᵀ f, ġ = G v. Directions do
/// not turn during the impact [theory page, "Networks"].
struct Network {
  MassMatrix mass;                          ///< M
  std::vector<ContactDirection> direction;  ///< G, m rows
  std::vector<contact::Law> law;            ///< m values
  std::vector<double> gap;                  ///< start gaps, m values [m]; < 0 only if `precompressed`
  std::vector<double> velocity;             ///< start velocities, n values
  bool precompressed = false;
  Index dimension = 0;  ///< of balls, whose coordinates are the dofs in turn; 0 for any other dofs
  /// Between the centres of the balls of each contact at the start, m values [m]; empty for other dofs.
  std::vector<double> distance = {};
  std::vector<Drive> drive = {};  ///< of dofs of infinite mass, or forces on others
};

/// Throws InvalidParameter, naming the contact (from 1), unless the network is one that can be simulated.
void validate(const Network& network);

/// Throws InvalidParameter if the network is driven and no `max_time` [s] ends that.
void expect_end(const Network& network, double max_time);

/// A chain written as a network. Throws InvalidParameter if gravity acts on it.
Network as_network(const Chain& chain);

/// A ball that can move in a plane or in space.
struct Ball {
  std::vector<double> position;  ///< of the centre, 2 or 3 values [m]
  std::vector<double> velocity;  ///< as many [m/s]
  double mass;                   ///< [kg]; ∞ for one that does not move
  double radius;                 ///< [m]
};

/// Frictionless balls of which those within `reach` of each other can touch; dofs are the coordinates of
/// ball 1, of ball 2, … `law(i, j)` is that of balls i and j. Gaps below rounding of the positions are zero.
/// Throws InvalidParameter.
template <class LawOfPair>
Network ball_network(const std::vector<Ball>& balls, double reach, LawOfPair&& law);

/// Direction and gap of the contact of two balls i and j.
struct BallContact {
  ContactDirection direction;
  double gap;
  double distance = 0;  ///< of the centres [m]
};
/// Numbers of two balls, from 0, the smaller first.
struct BallPair {
  Index left, right;
};
/// Those that may be within `reach` of each other, in order: all that are, and others nearly so.
std::vector<BallPair> near_pairs(const std::vector<Ball>& balls, double reach);
/// Of two of the balls, wherever they are. Throws InvalidParameter if they are at one place.
BallContact ball_contact(const std::vector<Ball>& balls, Index i, Index j);

/// The balls that a contact of a network of balls joins; empty for other networks.
std::optional<BallPair> balls_of(const Network& network, Index contact);

/// Freedoms of the balls without contacts. Throws InvalidParameter.
Network free_balls(const std::vector<Ball>& balls);

template <class LawOfPair>
Network ball_network(const std::vector<Ball>& balls, double reach, LawOfPair&& law) {
  auto network = free_balls(balls);
  for (const auto& [i, j] : near_pairs(balls, reach)) {
    auto [direction, gap, distance] = ball_contact(balls, i, j);
    if (direction.empty() || gap > reach) continue;
    network.direction.push_back(std::move(direction));
    network.gap.push_back(gap);
    network.distance.push_back(distance);
    network.law.push_back(law(i, j));
  }
  return network;
}

}  // namespace mariotte::model
