// A simulator that knows nothing of modes, phases, events or flows: gaps and velocities of any contacts,
// forces cut off at zero unless they adhere, from start to end. Good to about 1e-7.
#pragma once
#include <cmath>
#include <functional>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/core/contact_direction.hpp"
#include "support/naive_law.hpp"
#include "support/naive_steps.hpp"

namespace mariotte::test {

/// Contacts of any system, ġ = G v and v̇ = a + M⁻¹Gᵀ f, as plain numbers.
struct NaiveContacts {
  std::vector<ContactDirection> direction;  ///< rows of G
  std::vector<ContactDirection> response;   ///< columns of M⁻¹Gᵀ
  std::vector<contact::Law> law;
  std::vector<double> gap, velocity;
  std::vector<double> acceleration;                       ///< by outside forces, per velocity
  std::function<double(std::size_t, double)> given = {};  ///< of a velocity at a time, besides
};

/// What is asked for.
struct NaiveSettings {
  double end;    ///< time [s]
  double speed;  ///< what bodies reach relative to each other [m/s]
  Effort effort = {};
};

/// Where a naive run got to; `complete` is false if it would have needed too many steps.
struct NaiveRun {
  std::vector<double> velocity;
  Index steps = 0;
  bool complete = false;
};

/// A velocity that all share and no gap depends on: that of the first, in a row. Rounding of it would be in
/// every rate.
inline double common_velocity(const NaiveContacts& contacts) {
  for (const auto& direction : contacts.direction) {
    double rate = 0;
    for (const auto& term : direction) rate += term.coefficient;
    if (rate != 0) return 0;
  }
  return contacts.velocity.front();
}

/// The system in units of natural depths and of `speed`: gaps first, then velocities less the common one,
/// then the largest indentations so far, which grow where a contact is as deep as never before.
class NaiveField {
 public:
  using State = std::vector<double>;

  NaiveField(const NaiveContacts& contacts, const NaiveSettings& settings)
      : contacts_(contacts), settings_(settings) {
    for (std::size_t j = 0; j < contacts.law.size(); ++j) {
      const double mobility = dot(contacts.direction[j], contacts.response[j]);
      law_.emplace_back(contacts.law[j]);
      depth_.push_back(mobility > 0 ? law_[j].natural_depth(mobility, settings.speed)
                                    : std::max(settings.speed, std::abs(contacts.gap[j])));
    }
    attached_.resize(law_.size());
    accept(start());
  }

  /// Whether a contact is attached changes between steps only.
  void accept(const State& y) {
    for (std::size_t j = 0; j < law_.size(); ++j)
      attached_[j] = law_[j].adheres(past(y, j), -y[j] * depth_[j]);
  }

  State start() const {
    State y;
    for (std::size_t j = 0; j < depth_.size(); ++j) y.push_back(contacts_.gap[j] / depth_[j]);
    for (const double v : contacts_.velocity) y.push_back((v - common_) / settings_.speed);
    for (std::size_t j = 0; j < depth_.size(); ++j) y.push_back(std::max(0.0, -y[j]));
    return y;
  }

  void operator()(const State& y, State& dy, double time) const {
    const auto m = depth_.size();
    const ConstState velocity(y.data() + m, velocities());
    for (std::size_t i = 0; i < velocity.size(); ++i) {
      const double given = contacts_.given ? contacts_.given(i, time) : 0;
      dy[m + i] = (contacts_.acceleration[i] + given) / settings_.speed;
    }
    for (std::size_t j = 0; j < m; ++j) {
      const double rate = settings_.speed * gap_rate(contacts_.direction[j], velocity);
      dy[j] = rate / depth_[j];
      dy[peak(j)] = rate < 0 && -y[j] > y[peak(j)] - 1e-12 ? -dy[j] : 0;
      const double force = law_[j].force(past(y, j), -y[j] * depth_[j], -rate);
      if (force == 0) continue;
      for (const auto& [i, coefficient] : contacts_.response[j])
        dy[m + static_cast<std::size_t>(i)] += coefficient * force / settings_.speed;
    }
  }

  /// No contact is passed over: near contacts a share of their natural time, and far from them of the time
  /// that bodies four times as fast as they should be would need to meet.
  double longest_step(const State& y) const {
    double longest = settings_.end;
    for (std::size_t j = 0; j < depth_.size(); ++j) {
      const double natural = depth_[j] / settings_.speed;
      longest = std::min(longest, natural * (settings_.effort.share + std::max(0.0, y[j]) / 4));
    }
    return longest;
  }

  void finish(const State& y, std::vector<double>& velocity) const {
    for (std::size_t i = 0; i < velocities(); ++i)
      velocity.push_back(common_ + y[depth_.size() + i] * settings_.speed);
  }

 private:
  std::size_t velocities() const { return contacts_.velocity.size(); }
  std::size_t peak(std::size_t j) const { return depth_.size() + velocities() + j; }
  NaiveMemory past(const State& y, std::size_t j) const {
    return {.peak = y[peak(j)] * depth_[j], .attached = attached_[j]};
  }

  const NaiveContacts& contacts_;
  NaiveSettings settings_;
  double common_ = common_velocity(contacts_);
  std::vector<double> depth_;
  std::vector<NaiveLaw> law_;
  std::vector<bool> attached_;
};

/// From the start to `settings.end`.
inline NaiveRun run_naive(const NaiveContacts& contacts, const NaiveSettings& settings) {
  NaiveField field(contacts, settings);
  auto y = field.start();
  NaiveRun run;
  run.complete = follow_naively(field, y, settings.end, settings.effort, run.steps);
  field.finish(y, run.velocity);
  return run;
}

}  // namespace mariotte::test
