// From the run of a chain or a network with slopes to its outcomes.
#pragma once
#include <algorithm>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/sensitivity/contact_notes.hpp"
#include "mariotte/impact/sensitivity/frame_slopes.hpp"
#include "mariotte/impact/sensitivity/resolved.hpp"
#include "mariotte/impact/sensitivity/slope_run.hpp"

namespace mariotte::impact {

/// Throws InvalidParameter if anything is driven.
inline void expect_no_drive(const std::vector<model::Drive>& drives) {
  if (!drives.empty()) throw InvalidParameter("slopes of what is driven are not computed");
}

/// `use` of the models around each parameter as seen within the frame, one after the other in the same
/// memory.
template <class Scaled, class Model, class Use>
void for_each_shifted(const Scaled& base, const MovingFrame& frame, const std::vector<Parameter<Model>>& by,
                      const SlopeWatch& watch, Use&& use) {
  auto moved = base;
  Model model;
  for (std::size_t c = 0; c < by.size(); ++c) {
    watch();
    const auto& one = by[c];
    std::span<const StencilPoint> points = stencil;
    if (one.is_linear) points = linear_stencil;
    for (std::size_t k = 0; k < points.size(); ++k) {
      one.set(one.value + points[k].offset * one.step, model);
      if (frame) enter(frame, model.velocity);
      restate(model, moved);
      use(ShiftedModel<Scaled>{moved, static_cast<Index>(c), one.step, points, k});
    }
  }
}

/// Where contacts remember, errors of what they remember count in slopes, too.
inline hybrid::Options refined(hybrid::Options options, const std::vector<contact::Law>& laws) {
  constexpr double share = 0.3;
  const auto remembers = [](const contact::Law& law) { return !power_law(law); };
  if (std::any_of(laws.begin(), laws.end(), remembers))
    options.accuracy = std::max(16 * epsilon, share * options.accuracy);
  return options;
}

/// With as many digits as slopes need; `run_at(options)` is a ContactSensitivity.
template <class RunAt>
Sensitivity resolved_contacts(const hybrid::Options& asked, RunAt&& run_at) {
  SlopeLoss loss{};
  const auto once = [&](const hybrid::Options& options) {
    auto run = run_at(options);
    loss = run.loss();
    return std::pair(run.take(), loss.times);
  };
  return resolved(asked, once, [&](double error) { return loss.note(error); });
}

/// A contact system with its slopes. `Impulses` sees the models around each parameter; `at(interval, p)`
/// fills p, and `add_slopes(c, interval, p)` adds what masses and gravity do at fixed states.
template <class System, class Topology, class Impulses>
class ContactSensitivity {
 public:
  using Scaled = typename Topology::Model;

  /// `base` is seen within the frame.
  template <class Model>
  ContactSensitivity(System& system, const Scaled& base, const MovingFrame& frame,
                     const std::vector<Parameter<Model>>& by, const hybrid::Options& options,
                     const SlopeWatch& watch)
      : base_(base),
        layout_(expect_few_of(system.layout(), std::ssize(by))),
        impulses_(base, layout_, std::ssize(by)),
        variation_(base, layout_, std::ssize(by), options.accuracy),
        start_(layout_.size, std::ssize(by)) {
    initial_state(base, layout_, x0_);
    for_each_shifted(base, frame, by, watch, [&](const ShiftedModel<Scaled>& shifted) {
      add_start(shifted);
      variation_.add(shifted);
      impulses_.add(shifted);
    });
    const auto inner = hybrid::scaled(refined(options, base.law), base.scale);
    end_ = SlopeLoop(system, variation_, inner, watch).follow(x0_, start_);
    move_limit(by, base.scale.time, end_);
    for (const auto& one : by) result_.parameter.push_back({one.name, one.value});
  }

  /// The largest there is. Pieces leave a tenth of what they may.
  SlopeLoss loss() const {
    const auto slow_ending = [](double error) { return slow_ending_note(error, {"time"}); };
    const SlopeLoss all[] = {{end_.time_loss, slow_ending},
                             {end_.onset_loss, shared_onset_note},
                             {0.1 * end_.shrinkage, shrinking_note},
                             {0.1 * growth(), growing_note}};
    const auto is_less = [](const SlopeLoss& a, const SlopeLoss& b) { return a.times < b.times; };
    return *std::max_element(std::begin(all), std::end(all), is_less);
  }
  Sensitivity take() {
    result_.ending = end_.run.ending;
    result_.message = end_.run.message;
    add_velocities();
    add_impulses();
    add_time();
    add_notes(end_, base_.scale.time, moving_with_the_end(), result_);
    ContactNotes<Topology>(base_, layout_, variation_, result_).add({x0_, start_}, end_);
    leave_out_unbounded(result_);
    return std::move(result_);
  }

 private:
  static const model::ContactLayout& expect_few_of(const model::ContactLayout& layout, Index parameters) {
    expect_few(layout.size, parameters);
    return layout;
  }
  Index columns() const { return start_.columns; }
  double slope(Index place, Index c) const { return end_.slopes(place, c) + end_.rate[place] * end_.time[c]; }

  /// By how much velocities change with a parameter, relative to both, or with those at the start: slopes
  /// grow with errors as these do.
  double growth() const {
    double most = 0;
    for (Index c = 0; c < columns(); ++c) {
      double moved = 0;
      for (const Index place : layout_.velocity) moved = std::max(moved, std::abs(start_(place, c)));
      const double size = moved > 0 ? base_.speed / moved : std::abs(result_.parameter[c].value);
      most = std::max(most, size * variation_.reach(end_.slopes, c));
    }
    return most;
  }

  /// The work of a contact that starts indented is its stored energy.
  void add_start(const ShiftedModel<Scaled>& shifted) {
    initial_state(shifted.model, layout_, moved_);
    for (Index r = 0; r < start_.rows; ++r)
      start_(r, shifted.column) += shifted.share() * (moved_[r] - x0_[r]);
  }

  /// At fixed masses and gravity impulses are linear in both states and the time between.
  SlopeMatrix impulse_slopes(const std::vector<Index>& periods) const {
    SlopeMatrix slopes(layout_.contacts(), columns());
    std::vector<double> after(layout_.size), p;
    for (Index c = 0; c < columns(); ++c) {
      for (Index r = 0; r < layout_.size; ++r) after[r] = slope(r, c);
      impulses_.at({start_.column(c), after, end_.time[c]}, p);
      impulses_.add_slopes(c, {x0_, end_.run.state, end_.run.time}, p);
      for (Index j = 0; j < layout_.contacts(); ++j)
        if (periods[j] > 0) slopes(j, c) = p[j];
    }
    return slopes;
  }

  /// The time alone, unless something presses or falls then.
  Names moving_with_the_end() const {
    const auto moves = [&](Index place) { return end_.rate[place] != 0; };
    if (std::any_of(layout_.velocity.begin(), layout_.velocity.end(), moves)) return {};
    return {"time"};
  }

  template <class Slope>
  void add(const char* name, std::optional<Index> index, const char* unit, std::optional<double> value,
           Slope&& slope_of) {
    auto& outcome = result_.outcome.emplace_back(OutcomeSlopes{name, index, unit, value, {}});
    for (Index c = 0; c < columns(); ++c) outcome.slope.push_back(slope_of(c));
  }

  void add_velocities() {
    const double unit = base_.scale.velocity;
    for (Index i = 0; i < layout_.velocities(); ++i) {
      const Index place = layout_.velocity[i];
      add("velocity", i, "m/s", end_.run.state[place] * unit,
          [&](Index c) { return slope(place, c) * unit; });
    }
  }

  void add_impulses() {
    const double unit = base_.scale.momentum();
    std::vector<double> p;
    std::vector<Index> periods;
    impulses_.at({x0_, end_.run.state, end_.run.time}, p);
    count_periods(end_.run.changes, layout_.contacts(), periods);
    clear_faint(base_, periods, p);
    const auto slopes = impulse_slopes(periods);
    for (Index j = 0; j < layout_.contacts(); ++j)
      add("impulse", j, "N s", p[j] * unit, [&](Index c) { return slopes(j, c) * unit; });
    for (Index j = 0; j + 1 < layout_.contacts(); ++j) {
      const auto ratio = correlation_ratio(p, j);
      add("icr", j, "1", ratio, [&](Index c) -> std::optional<double> {
        if (!ratio) return std::nullopt;
        return (slopes(j, c) - *ratio * slopes(j + 1, c)) / p[j + 1];
      });
    }
    if (impulses_tell_losses()) add_dissipated(p, slopes);
  }

  /// Nothing but contacts moves anything, and none stores energy at the start or at the end.
  bool impulses_tell_losses() const {
    const Topology topology{base_, layout_};
    for (Index i = 0; i < layout_.velocities(); ++i)
      if (topology.acceleration(i) != 0) return false;
    const auto is_pressed = [&](Index gap) { return x0_[gap] < 0; };
    const auto dissipates = [](const contact::Law& law) { return contact::dissipates(law); };
    return end_.run.ending == hybrid::Ending::separated &&
           std::none_of(layout_.gap.begin(), layout_.gap.end(), is_pressed) &&
           std::any_of(base_.law.begin(), base_.law.end(), dissipates);
  }

  /// ½ Σ p (δ̇⁻ + δ̇⁺): impulses take so much from the motion, whatever masses are.
  void add_dissipated(const std::vector<double>& p, const SlopeMatrix& slopes) {
    const Topology topology{base_, layout_};
    const auto both = [&](ConstState before, ConstState after, Index j) {
      return topology.approach(before, j) + topology.approach(after, j);
    };
    const double unit = 0.5 * base_.scale.energy();
    double value = 0;
    for (Index j = 0; j < layout_.contacts(); ++j) value += unit * p[j] * both(x0_, end_.run.state, j);
    add("dissipated", {}, "J", value, [&](Index c) {
      std::vector<double> after(layout_.size);
      for (Index r = 0; r < layout_.size; ++r) after[r] = slope(r, c);
      double sum = 0;
      for (Index j = 0; j < layout_.contacts(); ++j)
        sum += slopes(j, c) * both(x0_, end_.run.state, j) +
               p[j] * (both(start_.column(c), after, j) + variation_.rate_slope(j, c, x0_) +
                       variation_.rate_slope(j, c, end_.run.state));
      return unit * sum;
    });
  }

  void add_time() {
    add("time", {}, "s", end_.run.time * base_.scale.time, [&](Index c) -> std::optional<double> {
      if (end_.time_is_noise || end_.time_is_shared[c]) return std::nullopt;
      return end_.time[c] * base_.scale.time;
    });
  }

  const Scaled& base_;
  const model::ContactLayout& layout_;
  Impulses impulses_;
  ContactVariation<Topology> variation_;
  SlopeMatrix start_;
  std::vector<double> x0_, moved_;
  SlopeRun<System> end_;
  Sensitivity result_;
};

}  // namespace mariotte::impact
