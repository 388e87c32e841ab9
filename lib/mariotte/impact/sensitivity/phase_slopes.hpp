// Slopes along one phase: the variational equation S' = f_x S + f_p on every step that a flow has taken.
#pragma once
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/sensitivity/collocation.hpp"

namespace mariotte::impact {

/// Sees the steps of a run and carries slopes along. `Variation::source(x, mode, b)` is f_p.
template <class Variation, class Mode>
class PhaseSlopes final : public hybrid::PhaseObserver {
 public:
  PhaseSlopes(const flow::Problem& problem, const Variation& variation, const Mode& mode, double accuracy,
              const std::function<void()>& watch)
      : slopes(problem.size(), variation.columns()),
        problem_(problem),
        variation_(variation),
        mode_(mode),
        watch_(watch),
        accuracy_(accuracy) {}

  /// The problem has another size or pattern from now on.
  void fit() {
    unresolved_ = unresolved();
    collocation_.reset();
  }
  /// Largest error of what collocation could not resolve, relative to the slopes.
  double unresolved() const {
    return collocation_ ? std::max(unresolved_, collocation_->unresolved()) : unresolved_;
  }

  /// A flow that gives up may have gone back to where the phase began.
  void begin_phase(double time, ConstState) override {
    if (time != phase_start_) at_start_ = {slopes, std::max(0.0, reached_ - last_end_)};
    slopes = at_start_.slopes;
    reached_ = at_start_.reached;
    last_end_ = 0;
    phase_start_ = time;
  }
  void observe(const flow::Step& step) override {
    watch_();
    if constexpr (requires { variation_.see(step, mode_); }) variation_.see(step, mode_);
    last_end_ = step.end;
    const double from = std::max(step.start, std::exchange(reached_, step.end));
    if constexpr (requires { variation_.advance(step, mode_, slopes); })
      if (variation_.advance(step, mode_, slopes)) return void(end_.reset());
    const double beyond = find_end(step);
    Along field(*this, step);
    if (!collocation_)
      collocation_.emplace(pattern(), problem_.magnitudes(), variation_.natural_slopes(), accuracy_, places(),
                           unneeded());
    reached_ = end_.value_or(step.end);
    collocation_->advance(
        field, from, reached_,
        {.begins = step.start == 0 && may_begin_steeply(), .beyond = beyond, .is_steep = is_steep_}, slopes);
  }
  bool has_slopes() const override { return true; }
  /// What comes next is another phase, even if it begins at the same time.
  void end_phase() { phase_start_ = -1; }

  SlopeMatrix slopes;

 private:
  class Along final : public LinearField {
   public:
    Along(const PhaseSlopes& owner, const flow::Step& step)
        : owner_(owner), step_(step), x_(owner.problem_.size()) {}
    double at(double time, double left, std::span<double> jacobian, SlopeMatrix& source) override {
      owner_.state_at(step_, time, left, x_);
      owner_.variation_.jacobian(owner_.problem_, x_, owner_.mode_, jacobian);
      owner_.variation_.source(x_, owner_.mode_, source);
      if constexpr (requires { owner_.variation_.cancellation(x_, owner_.mode_); })
        return owner_.variation_.cancellation(x_, owner_.mode_);
      return 1;
    }

   private:
    const PhaseSlopes& owner_;
    const flow::Step& step_;
    std::vector<double> x_;
  };

  std::vector<flow::Entry> pattern() const {
    if constexpr (requires { variation_.pattern(mode_); })
      return variation_.pattern(mode_);
    else
      return problem_.pattern();
  }

  std::vector<Index> places() const {
    if constexpr (requires { variation_.places(); }) return variation_.places();
    return {};
  }

  std::vector<Index> unneeded() const {
    if constexpr (requires { variation_.unneeded(); }) return variation_.unneeded();
    return {};
  }

  /// Whether a contact may have begun that is not smooth there.
  bool may_begin_steeply() const {
    if constexpr (requires { variation_.may_begin_steeply(mode_); })
      return variation_.may_begin_steeply(mode_);
    return true;
  }

  /// How far beyond the step a guard will be met, in lengths of the step. One that ends the phase is met a
  /// little before or behind the end of the step: a contact that lets go has the root of its force there,
  /// whose unbounded slope the clock has to meet.
  double find_end(const flow::Step& step) {
    const auto guards = static_cast<std::size_t>(problem_.guard_count());
    value_.resize(guards);
    rate_.resize(guards);
    dx_.resize(problem_.size());
    problem_.guards(step.after, value_);
    problem_.derivative(step.after, dx_);
    problem_.guard_rates(step.after, dx_, rate_);
    end_.reset();
    const double length = step.end - step.start;
    double beyond = infinity;
    for (std::size_t i = 0; i < guards; ++i) {
      const auto sign = static_cast<double>(problem_.crossings()[i]);
      const double past = value_[i] / rate_[i] / length;
      if (!(sign * rate_[i] > 0 && past < 1e-3 && variation_.has_root(static_cast<Index>(i), mode_)))
        continue;
      if (past > -1e-11 || past * length > -closest * problem_.time_scale())
        return meet(step, static_cast<Index>(i), past * length);
      if (past <= -1 || -past >= beyond) continue;
      set_end(static_cast<Index>(i));
      beyond = time_until(step, i, -past * length) / length;
    }
    return beyond;
  }

  /// Time from the end of a step until guard i is met, which a straight line says to be `about`: by the
  /// cubic that has its rates at the end, and so long and twice so long before it.
  double time_until(const flow::Step& step, std::size_t i, double about) {
    const double h = std::min(about, 0.5 * (step.end - step.start));
    const double last = rate_[i], one = rate_before(step, i, h), two = rate_before(step, i, 2 * h);
    const double bend = (3 * last - 4 * one + two) / (2 * h), turn = (last - 2 * one + two) / (2 * h * h);
    double time = about;
    for (int n = 0; n < 4; ++n) {
      const double value = value_[i] + time * (last + time * (bend / 2 + time * turn / 3));
      time -= value / (last + time * (bend + time * turn));
    }
    return time > 0.5 * about && time < 2 * about ? time : about;
  }
  double rate_before(const flow::Step& step, std::size_t i, double time) {
    std::vector<double> x(step.after.size()), dx(x.size()), rates(rate_.size());
    step.at(step.end - time, x);
    problem_.derivative(x, dx);
    problem_.guard_rates(x, dx, rates);
    return rates[i];
  }

  void set_end(Index i) {
    if constexpr (requires { variation_.ends_steeply(i, mode_); })
      is_steep_ = variation_.ends_steeply(i, mode_);
  }

  /// The state where guard i has been met, so much before the end of the step.
  double meet(const flow::Step& step, Index i, double past) {
    last_.resize(step.after.size());
    for (std::size_t k = 0; k < last_.size(); ++k) last_[k] = step.after[k] - past * dx_[k];
    variation_.meet(i, mode_, last_);
    set_end(i);
    end_ = step.end - past;
    return 0;
  }

  /// So near to the end of a phase that rounding is as much as the bend of the motion, this is straight.
  void state_at(const flow::Step& step, double time, double left, State x) const {
    if (!end_ || left > 1e-8 * problem_.time_scale()) return step.at(time, x);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = last_[k] - left * dx_[k];
  }

  static constexpr double closest = 4096 * epsilon;  ///< to a root where other guards say that it is met

  const flow::Problem& problem_;
  const Variation& variation_;
  const Mode& mode_;
  const std::function<void()>& watch_;
  double accuracy_;
  std::optional<Collocation> collocation_;  ///< made for the first step that needs it
  struct {
    SlopeMatrix slopes;
    double reached = 0;
  } at_start_;
  std::vector<double> value_, rate_, dx_;  ///< of guards, and of the state
  std::vector<double> last_;               ///< state at the guard that ends the phase
  std::optional<double> end_;              ///< when it is met, in this step
  double last_end_ = 0;                    ///< of the last step
  double reached_ = 0;                     ///< up to which slopes have been carried, perhaps beyond that
  bool is_steep_ = false;                  ///< of the guard that will be met
  double phase_start_ = -1;
  double unresolved_ = 0;  ///< with patterns before this one
};

}  // namespace mariotte::impact
