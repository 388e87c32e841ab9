// A simulator that knows nothing of modes, phases, events or flows: gaps and velocities of any contacts,
// forces cut off at zero, from start to end. Good to about 1e-7.
#pragma once
#include <cmath>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/core/contact_direction.hpp"
#include "support/naive_steps.hpp"

namespace mariotte::test {

/// Contacts of any system, ġ = G v and v̇ = a + M⁻¹Gᵀ f, as plain numbers.
struct NaiveContacts {
  std::vector<ContactDirection> direction;  ///< rows of G
  std::vector<ContactDirection> response;   ///< columns of M⁻¹Gᵀ
  std::vector<contact::Law> law;
  std::vector<double> gap, velocity;
  std::vector<double> acceleration;  ///< by outside forces, per velocity
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

/// max(0, k δⁿ + c δⁿ⁻¹ δ̇).
inline double naive_force(const contact::Law& law, double depth, double rate) {
  if (!(depth > 0)) return 0;
  const auto& [k, c, n] = std::get<contact::PowerLaw>(law);
  const double load = k * depth + c * rate;
  return load > 0 ? std::pow(depth, n - 1) * load : 0;
}

/// Depth that the contact alone reaches when struck at a speed: k δⁿ⁺¹/(n+1) = m* v²/2, 1/m* = G M⁻¹ Gᵀ.
inline double natural_depth(const contact::Law& law, double inverse_mass, double speed) {
  const auto& [k, c, n] = std::get<contact::PowerLaw>(law);
  return std::pow((n + 1) * speed * (speed / k) / (2 * inverse_mass), 1 / (n + 1));
}

/// The system in units of natural depths and of `speed`: gaps first, then velocities.
class NaiveField {
 public:
  using State = std::vector<double>;

  NaiveField(const NaiveContacts& contacts, const NaiveSettings& settings)
      : contacts_(contacts), settings_(settings) {
    for (std::size_t j = 0; j < contacts.law.size(); ++j) {
      const double mobility = dot(contacts.direction[j], contacts.response[j]);
      depth_.push_back(mobility > 0 ? natural_depth(contacts.law[j], mobility, settings.speed)
                                    : std::max(settings.speed, std::abs(contacts.gap[j])));
    }
  }

  State start() const {
    State y;
    for (std::size_t j = 0; j < depth_.size(); ++j) y.push_back(contacts_.gap[j] / depth_[j]);
    for (const double v : contacts_.velocity) y.push_back(v / settings_.speed);
    return y;
  }

  void operator()(const State& y, State& dy, double) const {
    const auto m = depth_.size();
    const ConstState velocity(y.data() + m, y.size() - m);
    for (std::size_t i = 0; i < velocity.size(); ++i) dy[m + i] = contacts_.acceleration[i] / settings_.speed;
    for (std::size_t j = 0; j < m; ++j) {
      const double rate = settings_.speed * gap_rate(contacts_.direction[j], velocity);
      dy[j] = rate / depth_[j];
      const double force = naive_force(contacts_.law[j], -y[j] * depth_[j], -rate);
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
    for (std::size_t i = depth_.size(); i < y.size(); ++i) velocity.push_back(y[i] * settings_.speed);
  }

 private:
  const NaiveContacts& contacts_;
  NaiveSettings settings_;
  std::vector<double> depth_;
};

/// From the start to `settings.end`.
inline NaiveRun run_naive(const NaiveContacts& contacts, const NaiveSettings& settings) {
  const NaiveField field(contacts, settings);
  auto y = field.start();
  NaiveRun run;
  run.complete = follow_naively(field, y, settings.end, settings.effort, run.steps);
  field.finish(y, run.velocity);
  return run;
}

}  // namespace mariotte::test
