// Following one smooth field to the next guard: the one interface of all flows.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "mariotte/flow/problem.hpp"
#include "mariotte/flow/push_series.hpp"

namespace mariotte::flow {

/// Forces of a closed contact, and its indentation, as polynomials in the clock of a step, from 0 to `end`.
struct ForceSeries {
  std::span<const double> normal, friction, depth;
  bool is_square = false;  ///< of friction
  double end = 0;
};

/// Indentation of a contact and its rate, as polynomials in the clock of a step, from 0 to `end`.
struct IndentationSeries {
  PushPolynomial depth, rate;
  int order = 0;
  double end = 0;
  std::size_t found = 0;  ///< among what a step knows; the search for the next goes on there
};

/// A dense piece of trajectory, valid during the call that hands it out.
class Step {
 public:
  virtual ~Step() = default;
  double start = 0;  ///< local time of the phase
  double end = 0;
  ConstState before;  ///< state at start
  ConstState after;   ///< state at end
  /// State at start ≤ time ≤ end.
  virtual void at(double time, State x) const = 0;
  /// State at a fraction of the step, from 0 to 1 in whatever clock it has: quicker where that is not time.
  virtual void inside(double fraction, State x) const { at(start + fraction * (end - start), x); }
  /// Fill in the series of all contacts that carry force in this step; false if there are none.
  virtual bool series(PushSeries&) const { return false; }
  /// Fill in the motion of the contact whose gap stands there in the state; false if it is not known.
  virtual bool indentation(Index /*gap*/, IndentationSeries&) const { return false; }
  /// Fill in the forces of all closed contacts, in the order of the phase; false if they are not known.
  virtual bool forces(std::vector<ForceSeries>&) const { return false; }
};

/// A step whose state at a time `at(time, x)` tells.
template <class At>
class StepOf final : public Step {
 public:
  explicit StepOf(const At& at) : at_(at) {}
  void at(double time, State x) const override { at_(time, x); }

 private:
  At at_;
};

/// Sees every step of a flow; peaks, traces and pictures come from here.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  virtual void observe(const Step& step) = 0;
  /// Differentiates steps: the root of a contact that begins or ends bounds slopes more than the motion.
  virtual bool has_slopes() const { return false; }
};

/// Takes events at which a flow need not stop.
class EventTaker {
 public:
  virtual ~EventTaker() = default;
  /// The guard of a gap has fired, it alone, after a time of the phase, at a rate of its contact's
  /// indentation. True if the mode is another one now, with the problem, that the same flow follows; else
  /// nothing is done.
  virtual bool take(Index guard, double time, double rate) = 0;
};

/// Why a flow stopped.
enum class Outcome {
  guard,  ///< guards fired, or the problem ended its mode itself
  limit,  ///< the time limit came first
  never,  ///< no guard will ever fire
  stiff,  ///< followed so far; the rest of the phase is too stiff for this flow
  failed  ///< the flow could not go on; `Arrival::message` says why
};

/// Where a flow stopped.
struct Arrival {
  Outcome outcome = Outcome::failed;
  double duration = 0;  ///< local time from the start of the phase
  Index steps = 0;
  Index rhs = 0;  ///< evaluations of the right-hand side
  std::string message = {};
  bool resumable = false;  ///< given up for its length alone: the flow could go on
  bool exhausted = false;  ///< failed after all steps that a phase may have: another flow would take no less
};

/// So many steps without an event end a run.
inline constexpr Index most_steps_of_phase = 10'000'000;
inline constexpr auto exhaustion = "ten million steps without an event";

/// What a flow is asked for.
struct Request {
  /// Steps after which a phase that may be stiff is given up, unless one has learned better.
  static constexpr Index usual_steps = 5000;
  double limit = infinity;           ///< longest duration
  double accuracy = 1e-10;           ///< wanted error at the end of the run, relative to the magnitudes
  StepObserver* observer = nullptr;  ///< may be null
  EventTaker* events = nullptr;      ///< likewise
  double least_step = 0;  ///< average step below which another flow goes on: the phase is given up as `stiff`
  bool patient = false;   ///< a phase is given up for its length much later
  Index most_steps = usual_steps;  ///< else after so many steps
};

/// Steps after which to give up the next phase, where BDF has followed one that was given up: so many as cost
/// what BDF took, about ten for one of its own.
inline Index worth_while(const Arrival& arrival) {
  return std::clamp<Index>(10 * arrival.steps, 100, Request::usual_steps);
}

/// A method that follows a smooth field.
class Flow {
 public:
  virtual ~Flow() = default;
  /// False if the flow's memory was made for problems of another shape.
  virtual bool fits(const Problem&) const { return true; }
  /// True if the flow can follow the present mode. Asked before `follow`, which uses what it has found out.
  virtual bool admits(const Problem&) { return true; }
  /// Follow the field from x until a guard crosses zero the way that fires it, and leave x there. A guard
  /// that is zero at the start does not fire. All guards that fire at that instant are appended to `fired`.
  virtual Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) = 0;
};

}  // namespace mariotte::flow
