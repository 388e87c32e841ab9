// One closed contact, everything else in free flight: closed form, nothing is integrated.
#pragma once
#include <vector>

#include "mariotte/flow/flow.hpp"
#include "mariotte/flow/pair/pair_phase.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"

namespace mariotte::flow {

/// Velocities follow from momentum, time from quadrature in closed form. Other gaps are concave in time while
/// the contact pushes, so the sign at the end of the contact proves whether one of them closes before.
class Pair final : public Flow {
 public:
  bool admits(const Problem& problem) override;
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  /// What ends a phase, unless a limit comes first.
  struct End {
    double duration;
    Index guard;
    Indentation last;  ///< of the pair, if its own guard ends the phase
  };
  void begin(const Problem& problem, ConstState x);
  bool is_of_branch(Index guard) const;
  std::optional<End> end_of_branch(const Problem& problem, const PairMotion& motion,
                                   const Indentation& begin) const;
  End opening(const PairMotion& motion) const;
  End first_event(const Problem& problem, const PairMotion& motion, const Indentation& begin) const;

  std::optional<PairPhase> phase_;
  std::vector<double> start_, rate_, value_, value_rate_;
  Simultaneous simultaneous_;
};

}  // namespace mariotte::flow
