#include "mariotte/flow/modal.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "mariotte/flow/simultaneous.hpp"
#include "mariotte/flow/wave.hpp"

namespace mariotte::flow {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Contact = LinearPhase::Contact;

/// The modes of a phase, and how the contacts ride on them.
struct Vibration {
  std::vector<Mode> modes;
  MatrixXd shape;              ///< U, closed contacts by modes
  VectorXd start, start_rate;  ///< Uᵀ √K δ, Uᵀ √K δ̇
  VectorXd root;               ///< √k of the closed contacts

  Index count() const { return static_cast<Index>(modes.size()); }
  double impulse(Index spring, double time) const;
};

/// ∫ f dt = √k Σ U [a sin(ωt)/ω + b (1 − cos ωt)/ω²].
double Vibration::impulse(Index spring, double time) const {
  double sum = 0;
  for (Index i = 0; i < count(); ++i) {
    const double w = modes[i].frequency, half = std::sin(0.5 * w * time);
    sum += shape(spring, i) * (start[i] * std::sin(w * time) + 2 * start_rate[i] * half * half / w) / w;
  }
  return root[spring] * sum;
}

Vibration make_vibration(const LinearPhase& phase, ConstState x) {
  const Index springs = static_cast<Index>(phase.closed.size()),
              bodies = static_cast<Index>(phase.body.size());
  Vibration v;
  v.root.resize(springs);
  MatrixXd coupling = MatrixXd::Zero(bodies, springs);  // Cᵀ
  VectorXd z(springs), rate(springs);
  for (Index j = 0; j < springs; ++j) {
    const auto& c = phase.contacts[phase.closed[j]];
    const auto &left = phase.body[c.left], &right = phase.body[c.right];
    v.root[j] = std::sqrt(c.stiffness);
    coupling(c.left, j) = -v.root[j] * std::sqrt(left.inverse_mass);
    coupling(c.right, j) = v.root[j] * std::sqrt(right.inverse_mass);
    z[j] = -v.root[j] * x[c.gap];
    rate[j] = v.root[j] * (x[left.velocity] - x[right.velocity]);
  }
  const Eigen::JacobiSVD<MatrixXd> svd(coupling, Eigen::ComputeThinU | Eigen::ComputeThinV);
  v.shape = svd.matrixV();
  v.start = v.shape.transpose() * z;
  v.start_rate = v.shape.transpose() * rate;
  for (Index i = 0; i < springs; ++i) {
    const double w = svd.singularValues()[i], sine = v.start_rate[i] / w;
    v.modes.push_back({std::hypot(v.start[i], sine), w, std::atan2(v.start[i], sine)});
  }
  return v;
}

/// δ_j = Σ U σ / √k with σ the modes.
Wave indentation(const Vibration& v, Index spring) {
  Wave wave;
  for (Index i = 0; i < v.count(); ++i) wave.weight.push_back(v.shape(spring, i) / v.root[spring]);
  return wave;
}

/// Adds factor · ∫∫ f dt dt of one spring: √k Σ U (a − σ + b t)/ω².
void add_push(Wave& wave, const Vibration& v, Index spring, double factor) {
  for (Index i = 0; i < v.count(); ++i) {
    const double w = v.modes[i].frequency, share = factor * v.root[spring] * v.shape(spring, i) / (w * w);
    wave.constant += share * v.start[i];
    wave.slope += share * v.start_rate[i];
    wave.weight[i] -= share;
  }
}

/// An open gap: straight, but for the pushes on its two bodies.
Wave open_gap(const LinearPhase& phase, const Vibration& v, const Contact& gap, ConstState x) {
  const auto &left = phase.body[gap.left], &right = phase.body[gap.right];
  Wave wave{x[gap.gap] + gap.level, x[right.velocity] - x[left.velocity],
            std::vector<double>(v.modes.size(), 0.0)};
  for (Index j = 0; j < static_cast<Index>(phase.closed.size()); ++j) {
    const auto& spring = phase.contacts[phase.closed[j]];
    if (spring.right == gap.right) add_push(wave, v, j, right.inverse_mass);
    if (spring.left == gap.right) add_push(wave, v, j, -right.inverse_mass);
    if (spring.right == gap.left) add_push(wave, v, j, -left.inverse_mass);
    if (spring.left == gap.left) add_push(wave, v, j, left.inverse_mass);
  }
  return wave;
}

class ModalStep final : public Step {
 public:
  ModalStep(const LinearPhase& phase, const Vibration& vibration, const std::vector<Wave>& waves,
            ConstState origin)
      : phase_(phase), vibration_(vibration), waves_(waves), origin_(origin) {}

  void at(double time, State x) const override {
    std::copy(origin_.begin(), origin_.end(), x.begin());
    for (std::size_t j = 0; j < phase_.contacts.size(); ++j) {
      const auto& c = phase_.contacts[j];
      const double value = waves_[j].at(vibration_.modes, time);
      x[c.gap] = c.stiffness > 0 ? -value : value - c.level;
    }
    for (Index j = 0; j < static_cast<Index>(phase_.closed.size()); ++j) {
      const auto& c = phase_.contacts[phase_.closed[j]];
      const auto &left = phase_.body[c.left], &right = phase_.body[c.right];
      const double p = vibration_.impulse(j, time);
      x[left.velocity] -= p * left.inverse_mass;
      x[right.velocity] += p * right.inverse_mass;
      if (c.impulse >= 0) x[c.impulse] += p;
    }
  }

 private:
  const LinearPhase& phase_;
  const Vibration& vibration_;
  const std::vector<Wave>& waves_;
  ConstState origin_;
};

}  // namespace

struct Modal::Memory {
  LinearPhase phase;
  Vibration vibration;
  std::vector<Wave> waves;  ///< δ of closed contacts, g of open ones: positive until their guard fires
  std::vector<double> start, before, after;
  Simultaneous simultaneous;

  void begin(const Problem& problem, ConstState x) {
    phase = *problem.linear();
    vibration = make_vibration(phase, x);
    start.assign(x.begin(), x.end());
    waves.clear();
    Index spring = 0;
    for (const auto& contact : phase.contacts)
      waves.push_back(contact.stiffness > 0 ? indentation(vibration, spring++)
                                            : open_gap(phase, vibration, contact, x));
  }

  /// A contact touched at rest is watched from where its indentation has left the noise.
  double watched_from(std::size_t contact) const {
    const double noise = phase.contacts[contact].noise;
    double time = noise > 0 ? 1e-3 / vibration.modes.front().frequency : 0;
    while (!(waves[contact].at(vibration.modes, time) > noise) && noise > 0 &&
           time < 1e3 / vibration.modes.back().frequency)
      time *= 1.1;
    return time;
  }

  /// Tell the problem of each indentation that has left the noise on the way.
  void accept_loads(Problem& problem, const ModalStep& step, double duration) {
    after.resize(start.size());
    for (std::size_t j = 0; j < waves.size(); ++j) {
      if (phase.contacts[j].noise == 0) continue;
      const double time = watched_from(j);
      if (time >= duration) continue;
      step.at(time, after);
      problem.accept(after);
    }
  }

  /// First fall of any wave before `limit`; the horizon grows by half-periods of the slowest mode.
  std::optional<double> first_event(double limit, Index& guard) const {
    std::optional<double> first;
    const double half_period = 3.2 / vibration.modes.back().frequency;
    double from = 0;
    for (int i = 0; i < 1'000'000 && !first && from < limit; ++i) {
      const double to = std::min(limit, from + half_period);
      for (std::size_t j = 0; j < waves.size(); ++j) {
        const double begin = i == 0 ? watched_from(j) : from, end = first.value_or(to);
        if (begin >= end) continue;
        const auto time = first_fall(waves[j], vibration.modes, begin, end);
        if (!time || (first && *time >= *first)) continue;
        first = time;
        guard = phase.contacts[j].guard;
      }
      from = to;
    }
    return first;
  }

  /// Pieces short enough to show the peaks of every mode, up to a bound.
  void show(ModalStep& step, double duration, Watcher& watcher) {
    const double pieces = std::clamp(std::ceil(duration * vibration.modes.front().frequency), 1.0, 4096.0);
    before = start;
    after.resize(start.size());
    for (double i = 1; i <= pieces; ++i) {
      step.start = step.end;
      step.end = i < pieces ? duration * i / pieces : duration;
      step.at(step.end, after);
      step.before = before;
      step.after = after;
      watcher.watch(step);
      before.swap(after);
    }
  }
};

Modal::Modal() : memory_(std::make_unique<Memory>()) {}
Modal::~Modal() = default;

Arrival Modal::follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) {
  auto& m = *memory_;
  m.begin(problem, x);
  Index guard = -1;
  const auto event = m.first_event(request.limit, guard);
  if (!event && !std::isfinite(request.limit))
    return {.outcome = Outcome::failed,
            .message = "no guard fired within a million half-periods of the slowest mode"};
  const double duration = event.value_or(request.limit);

  ModalStep step(m.phase, m.vibration, m.waves, m.start);
  if (request.watcher) m.show(step, duration, *request.watcher);
  m.accept_loads(problem, step, duration);
  step.at(duration, x);
  if (event) {
    fired.push_back(guard);
    m.simultaneous.collect(problem, x, simultaneity_window(problem, request.accuracy), fired);
  }
  return {
      .outcome = event ? Outcome::guard : Outcome::limit, .duration = duration, .steps = 1, .message = {}};
}

}  // namespace mariotte::flow
