// Slopes along one phase: the variational equation S' = f_x S + f_p on every step that a flow has taken.
#pragma once
#include <cmath>
#include <vector>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/sensitivity/collocation.hpp"

namespace mariotte::impact {

/// Sees the steps of a run and carries slopes along. `Variation::source(x, mode, b)` is f_p.
template <class Variation, class Mode>
class PhaseSlopes final : public hybrid::PhaseObserver {
 public:
  PhaseSlopes(const flow::Problem& problem, const Variation& variation, const Mode& mode, double accuracy)
      : slopes(problem.size(), variation.columns()),
        problem_(problem),
        variation_(variation),
        mode_(mode),
        collocation_(problem.pattern(), problem.magnitudes(), variation.natural_slopes(), accuracy) {}

  /// A flow that gives up may have gone back to where the phase began.
  void begin_phase(double time, ConstState) override {
    if (time == phase_start_) slopes = at_start_;
    else at_start_ = slopes;
    phase_start_ = time;
  }
  void observe(const flow::Step& step) override {
    Along field(*this, step);
    collocation_.advance(field, step.start, end_of(step), step.start == 0, slopes);
  }
  /// What comes next is another phase, even if it begins at the same time.
  void end_phase() { phase_start_ = -1; }

  SlopeMatrix slopes;

 private:
  class Along final : public LinearField {
   public:
    Along(const PhaseSlopes& owner, const flow::Step& step)
        : owner_(owner), step_(step), x_(owner.problem_.size()) {}
    void at(double time, std::span<double> jacobian, SlopeMatrix& source) override {
      step_.at(time, x_);
      owner_.problem_.jacobian(x_, jacobian);
      owner_.variation_.source(x_, owner_.mode_, source);
    }

   private:
    const PhaseSlopes& owner_;
    const flow::Step& step_;
    std::vector<double> x_;
  };

  /// A step ends a little before or behind the guard that ends it. Where a contact lets go its force has a root there,
  /// whose unbounded slope the clock has to meet.
  double end_of(const flow::Step& step) {
    const auto guards = static_cast<std::size_t>(problem_.guard_count());
    value_.resize(guards);
    rate_.resize(guards);
    dx_.resize(problem_.size());
    problem_.guards(step.after, value_);
    problem_.derivative(step.after, dx_);
    problem_.guard_rates(step.after, dx_, rate_);
    const double length = step.end - step.start;
    for (std::size_t i = 0; i < guards; ++i) {
      const auto sign = static_cast<double>(problem_.crossings()[i]);
      const double past = value_[i] / rate_[i];
      if (sign * rate_[i] > 0 && past > -1e-11 * length && past < 1e-3 * length) return step.end - past;
    }
    return step.end;
  }

  const flow::Problem& problem_;
  const Variation& variation_;
  const Mode& mode_;
  Collocation collocation_;
  SlopeMatrix at_start_;
  std::vector<double> value_, rate_, dx_;  ///< of guards, and of the state
  double phase_start_ = -1;
};

}  // namespace mariotte::impact
