// A run of islands as it is at one instant, for those who look on.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "mariotte/flow/choose.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/model/islands/free_balls.hpp"
#include "mariotte/model/islands/island.hpp"

namespace mariotte::model {

/// Free balls are known in closed form; an island is followed to the instant from where it was looked at
/// before, else from where it is for certain, once, when the first of its balls is asked for. Looking changes
/// nothing.
class Snapshot {
 public:
  /// Of balls, owners (−1 if free) and islands that outlive it.
  Snapshot(const FreeBalls& balls, const std::vector<int>& owner,
           const std::vector<std::unique_ptr<Island>>& islands, const hybrid::Options& options);

  /// From now on show the run at t, which is not before what is certain nor after what comes next.
  void move_to(Instant t);
  double time() const { return now_.value; }
  double velocity(Index ball);
  double gap(Index contact);
  double force(Index contact);

 private:
  struct Seen {
    int island;
    Index first;
    std::vector<double> velocity, gap, force;
  };
  /// How far an island has been followed from its certain state.
  struct Followed {
    Instant clock;
    std::vector<double> start, state;
    double elapsed = 0;
  };
  const Seen& see(int island);
  ConstState follow(std::size_t island, flow::Problem& phase);
  /// Null if contact j is not inside an island.
  const Seen* around(Index j);

  const FreeBalls& balls_;
  const std::vector<int>& owner_;
  const std::vector<std::unique_ptr<Island>>& islands_;
  double accuracy_;
  std::optional<flow::Kind> requested_;
  flow::Flows flows_;
  Instant now_;
  std::vector<Seen> seen_;
  std::vector<Followed> followed_;  ///< by island
};

/// Looks at a run from outside, at instants of its own choice. All times are dimensionless.
class SnapshotObserver {
 public:
  virtual ~SnapshotObserver() = default;
  /// When to look next; infinite for never again.
  virtual double next_look() const = 0;
  virtual void look(Snapshot& run) = 0;
  /// The ending.
  virtual void look_last(Snapshot& run) = 0;
  /// The run has come so far. Called after every change of the contact set.
  virtual void passed(double time, Index events) = 0;
  /// True gives the run up. Asked as often.
  virtual bool gives_up() const = 0;
};

}  // namespace mariotte::model
