#include <algorithm>
#include <cmath>

#include "mariotte/flow/flows.hpp"
#include "mariotte/flow/modal/linked_vibration.hpp"
#include "mariotte/flow/modal/modal_step.hpp"
#include "mariotte/flow/modal/row_vibration.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"

namespace mariotte::flow {
namespace {

/// Half-periods of the slowest mode until a phase without end is given up.
constexpr double patience = 1e6;

/// Share of a state that its modes may leave out: rounding, unless they are nearly alike.
constexpr double most_misfit = 1e-10;

/// Instead of a guard: a contact touched at rest is pulled apart, and the mode is over. Not in rows, where
/// what presses one contact presses the next.
constexpr Index parts = -1;
/// Instead of a guard: one that touched at rest pulls, which no modes may.
constexpr Index pulls = -2;

/// A wave that is positive until its guard fires.
struct Watched {
  Index guard;
  Index contact;
  Wave wave;
};

class Modal final : public Flow {
 public:
  bool admits(const Problem& problem) override {
    if (problem.drives()) return false;
    if (const auto* phase = problem.serial())
      return !has_acceleration(*phase) && !presses_beyond(*phase) && take(row_, *phase);
    const auto* phase = problem.linked();
    return phase && take(linked_, *phase);
  }
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override {
    begin(x);
    if (vibration_->misfit(x) > most_misfit)
      return {.outcome = Outcome::failed,
              .message = "modes that are nearly alike do not add up to the state"};
    Index guard = parts;
    const auto event = first_event(request.limit, guard);
    if (event && guard == pulls)
      return {.outcome = Outcome::stiff, .message = "a damper draws a contact apart that touched at rest"};
    if (!event && !std::isfinite(request.limit))
      return {.outcome = Outcome::failed,
              .message = "no guard fired within a million half-periods of the slowest mode"};
    const double duration = event.value_or(request.limit);

    ModalStep step(*vibration_, start_, workspace_);
    if (request.observer) show(step, duration, *request.observer);
    accept_loads(problem, step, duration);
    step.at(duration, x);
    if (event) {
      if (guard != parts) fired.push_back(guard);
      simultaneous_.collect(problem, x, simultaneity_window(problem, request.accuracy), fired);
    }
    return {.outcome = event ? Outcome::guard : Outcome::limit, .duration = duration, .steps = 1};
  }

 private:
  RowVibration row_;
  LinkedVibration linked_;
  Vibration* vibration_ = nullptr;  ///< one of these
  std::vector<Watched> watched_;
  Index guards_ = 0;                      ///< as many of the watched are in use
  double speed_ = 0, reached_speed_ = 0;  ///< natural; what rounding of rates is relative to
  std::vector<double> start_, before_, after_, bounds_;
  std::vector<double> watched_from_;  ///< by contact: touched at rest, it is watched once out of the noise
  Wave scratch_;
  ModalStep::Workspace workspace_;
  Simultaneous simultaneous_;

  bool take(auto& its, const auto& phase) {
    vibration_ = &its;
    speed_ = phase.speed;
    reached_speed_ = phase.reached_speed;
    return are_linear(phase.contact) && its.find(phase);
  }

  const PhaseContact& contact(Index j) const { return vibration_->contacts()[j]; }
  Index contacts() const { return std::ssize(vibration_->contacts()); }

  void begin(ConstState x) {
    vibration_->start(x);
    start_.assign(x.begin(), x.end());
    after_.resize(start_.size());
    workspace_.swing.resize(vibration_->modes().size());
    workspace_.progress.resize(vibration_->modes().size());
    guards_ = 0;
    watched_from_.assign(contacts(), 0.0);
    for (Index j = 0; j < contacts(); ++j) watch_contact(j);
  }

  void watch_contact(Index j) {
    const auto& c = contact(j);
    const auto& motion = vibration_->of(j);
    if (c.role == Role::open)
      watch(c.guard, j, motion.depth, -1, c.level);
    else if (c.role == Role::slack)
      watch(c.guard, j, motion.depth, 1, 0), watch_load(j, -1);
    else if (c.load_guard >= 0)
      watch_load(j, 1);
    else
      watch(c.guard, j, motion.depth, 1, 0);
    if (c.role == Role::touching && vibration_ == &linked_) watch_parting(j);
  }
  /// A load that has just changed its sign is what a strong damper makes of the rounding of a rate, the
  /// difference of two velocities: it changes it again once it is beyond that.
  void watch_load(Index j, double sign) {
    const auto& motion = vibration_->of(j);
    const double load = sign * motion.force.at(vibration_->modes(), 0);
    const double noise = 16 * epsilon * contact(j).damping * reached_speed_;
    watch(contact(j).load_guard, j, motion.force, sign, load <= noise ? noise : 0);
  }
  /// A strong damper would pull noticeably before its contact parts.
  void watch_parting(Index j) {
    const auto& c = contact(j);
    const auto& motion = vibration_->of(j);
    if (may_pull(c, speed_))
      watch(pulls, j, motion.force, 1, 64 * epsilon * c.damping * reached_speed_);
    else
      watch(parts, j, motion.depth, 1, 1.01 * c.loaded());
  }
  /// sign · wave + level.
  void watch(Index guard, Index contact, const Wave& wave, double sign, double level) {
    if (guards_ == static_cast<Index>(watched_.size())) watched_.emplace_back();
    auto& w = watched_[guards_++];
    w.guard = guard;
    w.contact = contact;
    set(w.wave, wave, sign, level);
  }
  static void set(Wave& to, const Wave& wave, double sign, double level) {
    to.constant = sign * wave.constant + level;
    to.slope = sign * wave.slope;
    to.weight = wave.weight;
    if (sign < 0)
      for (auto& weight : to.weight) weight = {-weight.even, -weight.odd};
  }

  /// Where the indentation of a contact touched at rest leaves the noise, if it does before `limit`: early,
  /// as a rule, so that the search begins with short stretches.
  double leaves_noise(Index contact, double limit) {
    set(scratch_, vibration_->of(contact).depth, -1, 1.01 * this->contact(contact).loaded());
    std::optional<double> time;
    for (double from = 0, to = 1e-3 / vibration_->fastest(); !time && from < limit; from = to, to *= 4)
      time = first_fall(scratch_, vibration_->modes(), from, std::min(to, limit));
    return time.value_or(infinity);
  }

  /// First fall of any watched wave before `limit`. The horizon begins with a half-period of the slowest mode
  /// and doubles.
  std::optional<double> first_event(double limit, Index& guard) {
    std::optional<double> first;
    const double half_period = 3.2 / vibration_->slowest();
    const double last = std::min(limit, patience * half_period);
    for (double from = 0, to = half_period; !first && from < last; from = to, to *= 2) {
      to = std::min(to, last);
      for (Index j = 0; j < contacts(); ++j)
        if (contact(j).role == Role::touching && watched_from_[j] >= from)
          watched_from_[j] = leaves_noise(j, to);
      for (Index i = 0; i < guards_; ++i) {
        const double end = first.value_or(to);
        const double begin =
            watched_[i].guard < 0 ? from : std::max(from, watched_from_[watched_[i].contact]);
        if (begin >= end) continue;
        const auto time = first_fall(watched_[i].wave, vibration_->modes(), begin, end);
        if (!time || (first && *time >= *first)) continue;
        first = time;
        guard = watched_[i].guard;
      }
    }
    return first;
  }

  /// Tell the problem of each indentation that has left the noise on the way.
  void accept_loads(Problem& problem, const ModalStep& step, double duration) {
    for (Index j = 0; j < contacts(); ++j) {
      if (contact(j).role != Role::touching || watched_from_[j] >= duration) continue;
      step.at(watched_from_[j], after_);
      problem.accept(after_);
    }
  }

  /// Pieces that put the largest indentation and force of each contact where a observer looks.
  void show(ModalStep& step, double duration, StepObserver& observer) {
    bounds_.clear();
    for (Index j = 0; j < contacts(); ++j) {
      if (!contact(j).pushes()) continue;
      add_summit(vibration_->of(j).depth, duration);
      if (contact(j).load_guard >= 0) add_summit(vibration_->of(j).force, duration);
    }
    bounds_.push_back(duration);
    std::sort(bounds_.begin(), bounds_.end());
    before_ = start_;
    for (const double end : bounds_) {
      if (!(end > step.end) && end < duration) continue;
      step.start = step.end;
      step.end = end;
      step.at(end, after_);
      step.before = before_;
      step.after = after_;
      observer.observe(step);
      before_.swap(after_);
    }
  }
  /// The slope changes sign within a piece of its own.
  void add_summit(const Wave& wave, double duration) {
    const auto summit = highest(wave, vibration_->modes(), 0, duration);
    if (!summit) return;
    bounds_.push_back(summit->time - summit->reach);
    bounds_.push_back(summit->time + summit->reach);
  }
};

}  // namespace

std::unique_ptr<Flow> make_modal_flow() {
  return std::make_unique<Modal>();
}

}  // namespace mariotte::flow
