// A long chain as islands between free balls: cost follows what moves, not the length of the chain.
//
//   form islands around the contacts that push; reckon when free neighbours meet
//   repeat
//     take the earliest: an arrival of an island, or a meeting. Nothing due earlier can interfere with it
//       there is none                 → separated
//       it comes after the time limit → time_limit
//     arrival: the island's next state becomes certain, its contact set makes its transition
//     an island whose wave is as it was twelve balls before is moved on as far as equal balls wait for it
//     meeting: the contact closes; islands whose end balls meet are brought to that time and dissolved
//     an island that has grown, shrunk or fallen apart, and what was dissolved, is cut anew
//     follow every new contact set to its next guard: uncertain until its turn comes
#pragma once
#include "mariotte/flow/choose.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/hybrid/trajectory.hpp"
#include "mariotte/model/islands/checkpoint.hpp"
#include "mariotte/model/islands/free_balls.hpp"
#include "mariotte/model/islands/island.hpp"
#include "mariotte/model/islands/snapshot.hpp"

namespace mariotte::model {

/// What became of the islands of a run.
struct IslandCount {
  Index formed = 0;
  Index widest = 0;    ///< contacts of the largest
  Index at_once = 0;   ///< most at one time
  Index redone = 0;    ///< stretches followed again because something interfered
  Index moved_on = 0;  ///< balls that steady waves passed without being followed
};

/// Runs one chain once. Balls are owned by an island or free; the end balls of an island fly freely, so that
/// every contact which is not inside an island is between two balls whose motion is known in closed form.
class Islands {
 public:
  using Run = hybrid::Trajectory<ContactChange>;

  /// Options are dimensionless; `stay` as for ChainSystem; `make_log` may be empty.
  Islands(const DimensionlessChain& chain, const ChainLayout& layout, ConstState start,
          const hybrid::Options& options, bool stay, IslandObserverMaker make_log);
  /// Goes on from where another run of the same chain was. What it counts and lists begins there.
  Islands(const DimensionlessChain& chain, const ChainLayout& layout, const Checkpoint& from,
          const hybrid::Options& options, bool stay, IslandObserverMaker make_log);

  /// To the ending; `observer` may be null.
  void run(SnapshotObserver* observer = nullptr);
  /// Where the run is. For an observer that is told how far it has come.
  Checkpoint checkpoint() const;
  /// Valid after `run`.
  Run& result() { return run_; }
  const contact::ContactSet& mode() { return balls_.modes(); }
  const IslandCount& count() const { return count_; }

 private:
  Islands(const DimensionlessChain& chain, const ChainLayout& layout, FreeBalls balls,
          const hybrid::Options& options, bool stay, IslandObserverMaker make_log);

  // One appointment after the other.
  void begin();
  bool is_over();
  bool is_beyond_limit(const Appointment& next) const;
  void keep(const Appointment& appointment);
  void arrive(Index id);
  void meet(Index contact);
  void record();
  void show(double until);
  void end(hybrid::Ending ending);

  // One island.
  flow::Request request_of(Island& island, double limit);
  /// A `patient` one gives up no phase for its length until much later.
  void follow(Island& island, double limit, bool patient = false);
  void commit(Island& island);
  void dissolve(Index id);
  Island& add_island();
  void form(Index first, Index last);
  void prepare(Island& island) const;
  void go_on(Index id);

  // A steady wave.
  bool may_become_steady(const Island& island) const;
  std::optional<Repetition> find_repetition(Island& island);
  WaveStamp stamp_of(const Island& island) const;
  bool leaves_rest(const Repetition& wave) const;
  bool is_alone(const Repetition& wave, std::size_t since) const;
  void move_on(Island& island, Repetition wave);
  Index periods_in_peace(double period);
  Index periods_in_events() const;
  Index count_waiting(const Repetition& wave, Index most) const;

  // Cutting a range of contacts, none of them inside an island, into islands.
  void absorb(Index id);
  void absorb_owners(Index contact);
  void cut();
  void close_due();
  void pass(Index j);
  void press(Index from, Index direction);
  Index find_owner_in_the_way() const;
  void form_groups();
  Index walk(Index ball, Index direction, Index most) const;
  Index spare(Index contact, Index direction) const;
  void schedule(Index contact);

  bool is_inside(Index contact) const {
    return owner_[contact] >= 0 && owner_[contact] == owner_[contact + 1];
  }

  const DimensionlessChain& chain_;
  hybrid::Options options_;
  std::optional<flow::Kind> requested_;
  bool stay_;
  Index margin_of_rows_;
  IslandObserverMaker make_log_;
  Instant now_;
  FreeBalls balls_;
  std::vector<int> owner_;  ///< island of each ball, −1 if it is free
  std::vector<std::unique_ptr<Island>> islands_;
  std::vector<Index> unused_;  ///< among them
  IslandQueue queue_;
  flow::Flows flows_;
  Index most_steps_ = flow::Request::usual_steps;  ///< after which a phase is given up for its length
  Snapshot snapshot_;
  SnapshotObserver* observer_ = nullptr;
  std::vector<ContactChange> changes_;
  std::vector<Index> walls_;  ///< contacts with a wall
  Index from_ = 0, to_ = -1;  ///< contacts to be cut
  std::vector<Group> groups_;
  Index crests_ = 0;  ///< of waves looked at since one was steady
  Run run_;
  IslandCount count_;
};

}  // namespace mariotte::model
