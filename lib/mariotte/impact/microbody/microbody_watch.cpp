#include "mariotte/impact/microbody/microbody_watch.hpp"

#include <algorithm>

#include "mariotte/impact/watch/highest.hpp"
#include "mariotte/impact/watch/thinning.hpp"

namespace mariotte::impact {
namespace {

/// The mass centre and the tips at one instant.
struct Reading {
  const model::MicrobodySystem& system;
  ConstState x;

  double velocity(Index i) const { return x[system.layout().place.velocity + i]; }
  double gap(Index i) const { return x[system.layout().place.gap[i]]; }
  double force(Index i) const {
    const auto mechanics = system.mechanics();
    return mechanics.normal_force(mechanics.tip(x, i), i);
  }
};

void drop_straightest(BodyTrace& t) {
  const auto tips = t.gap.front().size();
  std::vector<double> time;
  for (const auto& state : t.state) time.push_back(state.time);
  Bends bends(time);
  for (const auto motion : {&BodyState::velocity, &BodyState::spin})
    bends.add(3, [&](auto i, auto c) { return component(t.state[i].*motion, c); });
  bends.add(tips, [&](auto i, auto c) { return t.normal_force[i][c]; });
  bends.add(3 * tips, [&](auto i, auto c) { return component(t.friction[i][c / 3], c % 3); });
  keep_rows(bends.rows_to_keep(), t.state, t.gap, t.normal_force, t.friction, t.slip);
}

}  // namespace

MicrobodyObserver::MicrobodyObserver(const model::MicrobodySystem& system, const RunObserver& observers)
    : system_(system),
      observers_(observers),
      due_(observers, system.body().scale, 3, std::vector(system.layout().tips, system.body().time)) {}

BodyState body_state(const model::MicrobodySystem& system, double time, ConstState x) {
  const auto& scale = system.body().scale;
  const auto& place = system.layout().place;
  const auto q = quaternion_at(x, place.attitude);
  const auto& first = system.body().body.tips[0];
  const double height = x[place.gap[0]] + first.radius - rotate(q, first.centre).e1;
  return {.time = time * scale.time,
          .position = scale.length * Vector3{height, x[place.position], x[place.position + 1]},
          .attitude = q,
          .velocity = scale.velocity * vector_at(x, place.velocity),
          .spin = (1 / scale.time) * system.mechanics().spin(x)};
}

void MicrobodyObserver::begin_phase(double time, ConstState x) {
  start_ = time;
  milestones_.push_back({time, {x.begin(), x.end()}});
  peaks_.emplace_back(system_.layout().tips);
  shared_friction_ = shared_friction_ || system_.mechanics().forces(x, system_.mode()).redundant;
  if (!observers_.trace) return;
  auto& t = trace_;
  const auto rows = rows_until(time * system_.body().scale.time, t.state, &BodyState::time);
  cut_rows(rows, t.state, t.gap, t.normal_force, t.friction, t.slip);
  sample(time, x);  // friction jumps at events: one sample before, one after
}

TipPeaks MicrobodyObserver::now(ConstState x, Index i) const {
  const auto tip = system_.mechanics().tip(x, i);
  const double force = system_.mechanics().normal_force(tip, i);
  return {.push = force, .pull = -force, .depth = tip.indentation};
}

void MicrobodyObserver::search(const flow::Step& step, Index i) {
  constexpr int pieces = 4;
  std::array<TipPeaks, pieces + 1> samples;
  const auto at = [&](double share) {
    step.inside(share, inside_);
    return now(inside_, i);
  };
  for (int k = 0; k <= pieces; ++k) samples[k] = at(static_cast<double>(k) / pieces);
  for (const auto quantity : all_tip_peaks) {
    const auto best = std::max_element(samples.begin(), samples.end(), [&](const auto& a, const auto& b) {
      return a.*quantity < b.*quantity;
    });
    auto& peak = peaks_.back()[i].*quantity;
    peak = std::max(peak, (*best).*quantity);
    if ((*best).*quantity <= 0.5 * peak) continue;
    const auto k = static_cast<double>(best - samples.begin());
    peak = std::max(peak, highest([&](double share) { return at(share).*quantity; },
                                  std::max(0.0, k - 1) / pieces, std::min<double>(pieces, k + 1) / pieces));
  }
}

void MicrobodyObserver::observe(const flow::Step& step) {
  due_.take_within(start_, step, [&](ConstState x) { return Reading{system_, x}; });
  inside_.resize(step.before.size());
  for (Index i = 0; i < system_.layout().tips; ++i) {
    const Index gap = system_.layout().place.gap[i];
    if (step.before[gap] < 0 || step.after[gap] < 0) search(step, i);
  }
  if (!observers_.trace) return;
  constexpr int samples = 16;
  for (int k = 1; k < samples; ++k) {
    const double time = step.start + (step.end - step.start) * k / samples;
    step.at(time, inside_);
    sample(start_ + time, inside_);
  }
  sample(start_ + step.end, step.after);
}

void MicrobodyObserver::finish(double time, ConstState x) {
  due_.take_all(time, Reading{system_, x});
}

void MicrobodyObserver::sample(double time, ConstState x) {
  if (trace_.state.size() == most_rows) drop_straightest(trace_);
  const auto& mechanics = system_.mechanics();
  const auto& scale = system_.body().scale;
  auto now = body_state(system_, time, x);
  if (!trace_.state.empty()) now.time = std::max(now.time, trace_.state.back().time);  // rounding
  trace_.state.push_back(now);
  auto& gap = trace_.gap.emplace_back();
  auto& normal = trace_.normal_force.emplace_back();
  auto& friction = trace_.friction.emplace_back();
  auto& slip = trace_.slip.emplace_back();
  const auto forces = mechanics.forces(x, system_.mode());
  for (Index i = 0; i < system_.layout().tips; ++i) {
    gap.push_back(x[system_.layout().place.gap[i]] * scale.length);
    normal.push_back(forces.normal[i] * scale.force());
    friction.push_back(scale.force() * forces.friction[i]);
    slip.push_back(scale.velocity * mechanics.tip(x, i).slip);
  }
}

}  // namespace mariotte::impact
