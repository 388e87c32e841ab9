#include "mariotte/impact/bodies/bodies_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mariotte/core/scale.hpp"
#include "mariotte/impact/watch/highest.hpp"
#include "mariotte/impact/watch/thinning.hpp"

namespace mariotte::impact {

using model::vector3;

namespace {

const Scale no_scale{};

template <int D>
std::vector<double> natural_times(const model::BodiesSystem<D>& system) {
  std::vector<double> times;
  for (const auto& contact : system.setting().contact) times.push_back(contact.time);
  return times;
}

/// Velocities of body 1, body 2, … with all their components; gaps and forces of contacts.
template <int D>
struct Reading {
  const model::BodiesSystem<D>& system;
  const model::BodiesMode& mode;
  ConstState x;

  double velocity(Index i) const { return x[system.layout(x).velocity(i / D) + i % D]; }
  double gap(Index c) const { return system.field(mode, x).approach(c).gap; }
  double force(Index c) const {
    const auto& field = system.field(mode, x);
    for (std::size_t k = 0; k < mode.closed.size(); ++k)
      if (mode.closed[k].contact == c) return field.contact(k).normal;
    return 0;
  }
};

/// Polynomials, each with one maximum at most.
using Rows = std::array<std::span<const double>, 3>;
struct ValuesAndSlopes {
  std::array<double, 3> value{}, slope{};
};

/// Side by side, so that none waits for another.
ValuesAndSlopes at(const Rows& row, double place) {
  ValuesAndSlopes sum;
  for (std::size_t k = row[0].size(); k-- > 0;)
    for (std::size_t i = 0; i < row.size(); ++i) {
      sum.slope[i] = sum.slope[i] * place + sum.value[i];
      sum.value[i] = sum.value[i] * place + row[i][k];
    }
  return sum;
}

struct Slope {
  double place, value;
};

bool is_below(double share, const Slope& one, const Slope& other) {
  return std::abs(one.value) <= share * std::abs(other.value);
}

/// The value between two places where the slope changes its sign; 0 if it does not. By Newton's method, which
/// halves the bracket where it would leave it. It is flat there, so a loose place is enough for a tight
/// value. A slope that is far smaller than the other is rounding.
double summit(std::span<const double> row, Slope first, Slope last) {
  constexpr double rounding = 1e-8, loose = 1e-4;
  constexpr int most = 30;
  if (!(first.value * last.value < 0) || is_below(rounding, first, last) || is_below(rounding, last, first))
    return 0;
  const double within = loose * (last.place - first.place);
  double place = std::lerp(first.place, last.place, first.value / (first.value - last.value)), value = 0;
  for (int i = 0; i < most; ++i) {
    double slope = 0, bend = 0;
    value = 0;
    for (std::size_t k = row.size(); k-- > 0;) {
      bend = bend * place + 2 * slope;
      slope = slope * place + value;
      value = value * place + row[k];
    }
    (slope * first.value > 0 ? first : last) = {place, slope};
    const double next = place - slope / bend;
    if (std::abs(next - place) <= within) return value + 0.5 * slope * (next - place);
    place = next > first.place && next < last.place ? next : std::midpoint(first.place, last.place);
  }
  return value;
}

/// What the rows of a contact come to at most.
struct Most {
  std::array<double, 3> value, size;
  void raise(std::size_t i, double with) {
    value[i] = std::max(value[i], with);
    size[i] = std::max(size[i], std::abs(with));
  }
};

/// Largest value and size of each. Slopes are told a little inside: at an end where it is flat, rounding has
/// the sign. Where a contact is the clock of a step, all is flat at its onset and its end: there the middle
/// is asked.
Most largest(const Rows& row, double end) {
  constexpr double inside = 1e-6, flat = 1e-3;
  const double low = inside * end, middle = 0.5 * end, high = end - low;
  const auto start = at({row[0].first(4), row[1].first(4), row[2].first(4)}, low), stop = at(row, high);
  Most most{};
  for (std::size_t i = 0; i < row.size(); ++i) {
    const Slope first{low, start.slope[i]}, last{high, stop.slope[i]};
    most.raise(i, row[i][0]);
    most.raise(i, stop.value[i] + low * stop.slope[i]);
    if (is_below(flat, first, last) || is_below(flat, last, first)) {
      const Slope half{middle, at({row[i], row[i], row[i]}, middle).slope[0]};
      most.raise(i, summit(row[i], first, half));
      most.raise(i, summit(row[i], half, last));
    } else {
      most.raise(i, summit(row[i], first, last));
    }
  }
  return most;
}

/// Whether the last terms of a polynomial are small beside the largest value. Forces of a contact that hardly
/// touches, and moves nothing, need not be followed so far.
bool has_converged(std::span<const double> row, double end, double largest) {
  constexpr double share = 1e-4;
  const auto last = row.size() - 1;
  const double terms = std::abs(row[last]) * end + std::abs(row[last - 1]);
  return terms * std::pow(end, static_cast<double>(last - 1)) <= share * largest;
}

/// Whether a force may have a maximum within a step: a parabola through its start, middle and end has its
/// vertex there, or a quarter of the step beside it.
bool may_peak(double first, double half, double last) {
  const double bend = first - 2 * half + last;
  return bend < 0 && std::abs(last - first) < -3 * bend;
}

void drop_straightest(BodiesTrace& t) {
  const auto bodies = t.body.front().size(), contacts = t.force.front().size();
  Bends bends(t.time);
  for (const auto motion : {&BodyEnd::velocity, &BodyEnd::spin})
    bends.add(3 * bodies, [&](auto i, auto c) { return component(t.body[i][c / 3].*motion, c % 3); });
  bends.add(contacts, [&](auto i, auto c) { return t.force[i][c]; });
  bends.add(3 * contacts, [&](auto i, auto c) { return component(t.friction[i][c / 3], c % 3); });
  keep_rows(bends.rows_to_keep(), t.time, t.body, t.gap, t.force, t.friction, t.slip);
}

double wrapped(double angle) {
  const double rest = std::remainder(angle, 2 * std::numbers::pi);
  return rest <= -std::numbers::pi ? std::numbers::pi : rest;
}

}  // namespace

template <int D>
std::vector<BodyEnd> bodies_at(const model::Bodies& bodies, const model::BodiesSetting<D>& setting,
                               ConstState x) {
  const model::BodiesLayout<D> at{.bodies = std::ssize(bodies.body), .slots = 0};
  std::vector<BodyEnd> list;
  for (Index i = 0; i < at.bodies; ++i) {
    const auto motion = model::motion_of(setting.body[i], at, x, i);
    BodyEnd end{.position = bodies.body[i].position + vector3(motion.shift),
                .attitude = {},
                .velocity = vector3(motion.velocity),
                .spin = vector3(motion.spin)};
    if constexpr (D == 2) {
      end.angle = wrapped(bodies.body[i].angle + x[at.turn(i)]);
      end.attitude = rotation({0, 0, 1}, end.angle);
    } else {
      end.attitude = normalized(model::attitude(setting.body[i], motion.turn));
    }
    list.push_back(end);
  }
  return list;
}

template <int D>
BodiesObserver<D>::BodiesObserver(const model::Bodies& bodies, const model::BodiesSystem<D>& system,
                                  const model::BodiesMode& mode, const RunObserver& observers)
    : bodies_(bodies),
      system_(system),
      mode_(mode),
      observers_(observers),
      due_(observers, no_scale, D * std::ssize(bodies.body), natural_times(system)),
      peaks_(system.setting().contact.size()) {}

template <int D>
void BodiesObserver<D>::begin_phase(double time, ConstState x) {
  start_ = time;
  if (!observers_.trace) return;
  auto& t = trace_;
  cut_rows(rows_until(time, t.time), t.time, t.body, t.gap, t.force, t.friction, t.slip);
  sample(time, x);  // friction may jump at events: one sample before, one after
}

template <int D>
void BodiesObserver<D>::search(const flow::Step& step) {
  if (mode_.closed.empty()) return;
  if (!step.forces(forces_)) return sample_forces(step);
  for (std::size_t k = 0; k < mode_.closed.size(); ++k) {
    const auto& one = forces_[k];
    const auto [most, size] = largest({one.normal, one.friction, one.depth}, one.end);
    if (!has_converged(one.normal, one.end, size[0]) || !has_converged(one.friction, one.end, size[1]))
      return sample_forces(step);
    raise(k, {most[0], one.is_square ? std::sqrt(size[1]) : size[1], most[2]});
  }
}

template <int D>
void BodiesObserver<D>::raise(std::size_t closed, const ContactPeaks& now) {
  auto& peak = peaks_[mode_.closed[closed].contact];
  peak.force = std::max(peak.force, now.force);
  peak.friction = std::max(peak.friction, now.friction);
  peak.indentation = std::max(peak.indentation, now.indentation);
}

template <int D>
void BodiesObserver<D>::read(ConstState x, std::vector<ContactPeaks>& list) const {
  const auto& field = system_.field(mode_, x);
  list.clear();
  for (std::size_t k = 0; k < mode_.closed.size(); ++k) {
    const auto& c = field.contact(k);
    list.push_back({c.normal, norm(c.friction), -c.motion.gap});
  }
}

template <int D>
void BodiesObserver<D>::sample_forces(const flow::Step& step) {
  inside_.resize(step.before.size());
  step.inside(0.5, inside_);
  read(step.before, before_);
  read(inside_, middle_);
  read(step.after, after_);
  for (std::size_t k = 0; k < mode_.closed.size(); ++k) {
    for (const auto* list : {&before_, &middle_, &after_}) raise(k, (*list)[k]);
    for (const auto which : {&ContactPeaks::force, &ContactPeaks::friction}) {
      double& most = peaks_[mode_.closed[k].contact].*which;
      const double first = before_[k].*which, half = middle_[k].*which, last = after_[k].*which;
      if (!may_peak(first, half, last) || std::max({first, half, last}) <= 0.9 * most) continue;
      const auto at = [&](double share) {
        step.inside(share, inside_);
        read(inside_, within_);
        return within_[k].*which;
      };
      most = std::max(most, highest(at, 0, 1));
    }
  }
}

/// A step of a series may cross half a contact: a picture needs points between.
template <int D>
int BodiesObserver<D>::pieces_of(double duration) const {
  constexpr double least = 4, most = 32, per_natural_time = 20;
  double natural = infinity;
  for (const auto& one : mode_.closed)
    natural = std::min(natural, system_.setting().contact[one.contact].time);
  return static_cast<int>(std::clamp(per_natural_time * duration / natural, least, most));
}

template <int D>
void BodiesObserver<D>::observe(const flow::Step& step) {
  due_.take_within(start_, step, [&](ConstState x) { return Reading<D>{system_, mode_, x}; });
  search(step);
  if (!observers_.trace) return;
  const int pieces = pieces_of(step.end - step.start);
  inside_.resize(step.before.size());
  for (int k = 1; k < pieces; ++k) {
    const double time = step.start + (step.end - step.start) * k / pieces;
    step.at(time, inside_);
    sample(start_ + time, inside_);
  }
  sample(start_ + step.end, step.after);
}

template <int D>
void BodiesObserver<D>::finish(double time, ConstState x) {
  due_.take_all(time, Reading<D>{system_, mode_, x});
}

template <int D>
void BodiesObserver<D>::sample(double time, ConstState x) {
  if (trace_.time.size() == most_rows) drop_straightest(trace_);
  const auto& field = system_.field(mode_, x);
  const auto contacts = std::ssize(system_.setting().contact);
  // Never earlier than the one before, by rounding.
  trace_.time.push_back(trace_.time.empty() ? time : std::max(time, trace_.time.back()));
  trace_.body.push_back(bodies_at(bodies_, system_.setting(), x));
  auto& gap = trace_.gap.emplace_back();
  auto& force = trace_.force.emplace_back(contacts, 0.0);
  auto& friction = trace_.friction.emplace_back(contacts, Vector3{});
  auto& slip = trace_.slip.emplace_back(contacts, Vector3{});
  for (Index c = 0; c < contacts; ++c) gap.push_back(field.approach(c).gap);
  for (std::size_t k = 0; k < mode_.closed.size(); ++k) {
    const Index c = mode_.closed[k].contact;
    force[c] = field.contact(k).normal;
    friction[c] = vector3(field.contact(k).friction);
    slip[c] = vector3(field.contact(k).motion.slip);
  }
}

template std::vector<BodyEnd> bodies_at(const model::Bodies&, const model::BodiesSetting<2>&, ConstState);
template std::vector<BodyEnd> bodies_at(const model::Bodies&, const model::BodiesSetting<3>&, ConstState);
template class BodiesObserver<2>;
template class BodiesObserver<3>;

}  // namespace mariotte::impact
