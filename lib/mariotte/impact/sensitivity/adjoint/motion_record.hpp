// The motion of a row while contacts push, kept so that it can be read backwards.
//
// Steps are kept as values in the Gauss points of their pieces: the rate of the clock, and indentation and
// its rate of every contact that pushes. A clock u runs from 0 to 1 over a piece; the points resolve the
// stiffness of contacts in it.
#pragma once
#include <array>
#include <vector>

#include "mariotte/core/instant.hpp"
#include "mariotte/flow/push_series.hpp"
#include "mariotte/impact/sensitivity/gauss.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/model/islands/island.hpp"

namespace mariotte::impact {

/// Of something in each Gauss point.
using Nodes = std::array<double, stages>;

/// Its integral, if it is a rate.
inline double total(const Nodes& rate) {
  double sum = 0;
  for (int i = 0; i < stages; ++i) sum += gauss.weight[i] * rate[i];
  return sum;
}

/// Lists from the first to the last; each element says how many of the next list belong to it.
struct MotionRecord {
  /// Balls `first` to `last` between two events.
  struct Stretch {
    Index first, last;
    Instant start, end;
    Index pieces = 0;
    Index closings = 0;  ///< contacts whose force begins with a jump at the start
  };
  struct Piece {
    Nodes pace;          ///< dt/du
    Index contacts = 0;  ///< that push
    Index shallow = 0;   ///< the last of them, which hardly do
  };
  struct Contact {
    Index number;
    Nodes depth;
    int rise = 0, fall = 0;  ///< δ begins and ends as powers of u and 1 − u
  };
  std::vector<Stretch> stretch;
  std::vector<Piece> piece;
  std::vector<Contact> contact;
  std::vector<Nodes> rate;  ///< of the contacts with a damper
  std::vector<Index> closing;

  std::size_t bytes() const;
};

/// Records one stretch after the other of the rows that islands follow. Throws InvalidParameter at a step
/// that is no series.
class MotionRecorder final : public model::IslandObserver {
 public:
  /// Steps are divided until what is `accuracy` of the motion does not count. `all` must outlive this.
  MotionRecorder(double accuracy, const SlopeWatch& watch, MotionRecord& all)
      : accuracy_(accuracy), watch_(watch), all_(all) {}

  void begin(const model::ChainSystem& slice, Index first, Instant start) override;
  void observe(const flow::Step& step) override;
  void keep() override;

 private:
  struct Places;
  const contact::PowerLaw& law(Index number) const {
    return *power_law(slice_->chain().law[number - seen_.stretch.front().first]);
  }
  void note_closings(ConstState x);
  Places places(double begin, double width) const;
  void add(const flow::Step& step, double begin, double width, int halvings);
  Index number_of(Index gap) const;
  void add_contact(const flow::PushSeries::Contact& contact, const Places& places);
  bool ends(const flow::PushSeries::Contact& contact, const Nodes& depth) const;
  void drop(std::size_t contacts, std::size_t rates);
  void add_dozing(const flow::Step& step, const Places& places);
  bool is_shallow(const flow::PushSeries::Contact& contact) const;
  bool are_resolved(const MotionRecord::Piece& piece) const;

  double accuracy_;
  const SlopeWatch& watch_;
  MotionRecord& all_;
  const model::ChainSystem* slice_ = nullptr;
  MotionRecord seen_;  ///< of the present stretch
  double end_ = 0;     ///< of its last step
  flow::PushSeries series_;
};

}  // namespace mariotte::impact
