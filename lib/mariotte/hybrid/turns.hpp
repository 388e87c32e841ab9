// Which flow follows a phase, and which one goes on where that gives up.
#pragma once
#include <optional>

#include "mariotte/flow/choose.hpp"

namespace mariotte::hybrid {

/// The flows of one phase in turn: the cheapest, and after it those that may take over. A flow that gave up
/// for the length of the phase alone goes on with it if the next one takes no longer steps, until it has lost
/// patience.
class Turns {
 public:
  /// Options and problem must live as long. A flow gives up a phase for its length after `most_steps`.
  Turns(flow::Flows& flows, const flow::Problem& problem, const std::optional<flow::Kind>& requested,
        Index most_steps)
      : flows_(flows),
        problem_(problem),
        requested_(requested),
        most_steps_(most_steps),
        now_(flows.choose(problem, requested)) {}

  flow::Kind kind() const { return now_->kind; }
  flow::Flow& flow() { return now_->flow; }
  /// Adds to a request how much effort is worth while.
  flow::Request asking(flow::Request request) const {
    request.least_step = left_ ? least_step_ : 0;
    request.most_steps = most_steps_;
    request.patient = patient_ || left_ || (requested_ && is_cvode(*requested_));
    return request;
  }

  /// On to who takes over after this arrival; false if nobody does.
  bool pass_on(const flow::Arrival& arrival) {
    const bool stiff = arrival.outcome == flow::Outcome::stiff;
    if (arrival.exhausted) return false;
    if (stiff && left_) {
      now_.emplace(*left_);
      left_.reset();
      return patient_ = true;
    }
    if (stiff && arrival.resumable) {
      left_.emplace(*now_);
      least_step_ = arrival.duration / static_cast<double>(arrival.steps);
    }
    const auto next = flows_.instead_of(now_->kind, stiff, problem_, requested_);
    if (next) now_.emplace(*next);
    return next.has_value();
  }

  /// Steps that are worth while in the next phase, after this one has come to its end.
  Index most_steps(const flow::Arrival& arrival) const {
    return left_ ? flow::worth_while(arrival) : most_steps_;
  }

 private:
  flow::Flows& flows_;
  const flow::Problem& problem_;
  const std::optional<flow::Kind>& requested_;
  Index most_steps_;
  std::optional<flow::Choice> now_, left_;  ///< who follows, and who gave up for the length of the phase
  double least_step_ = 0;                   ///< average step of who gave up
  bool patient_ = false;
};

}  // namespace mariotte::hybrid
