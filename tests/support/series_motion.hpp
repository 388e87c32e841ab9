// The motion of a chain between two changes of its contacts as a power series in time, written from the
// equations of motion alone: what the oracle of the graze campaign stands on.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mariotte/model/chain/chain.hpp"

namespace mariotte::test {

inline constexpr int series_order = 18;
using Series = std::array<double, series_order + 1>;

/// A contact law as numbers, with the sizes its quantities are measured by.
struct Spring {
  double stiffness = 0;
  double damping = 0;
  bool root = false;  ///< f = √δ (k δ + c δ̇) instead of k δ + c δ̇
  double length = 0;  ///< indentation when struck at the reference speed: (m* v²/k)^{1/(n+1)}
  double load = 0;    ///< k length + c v
  /// Indentation below which the force is left out, because √δ has no series at 0: of an undamped contact it
  /// changes velocities by 1e-15 of the whole, of a damped one by 1e-14.
  double faint = 0;
};

/// Largest incident speed: what accuracy is relative to.
inline double incident_speed(const model::Chain& chain) {
  double speed = 0;
  for (const double v : chain.velocity) speed = std::max(speed, std::abs(v));
  return speed;
}

inline Spring make_spring(const model::Chain& chain, std::size_t j) {
  const auto& law = chain.law[j];
  const double v = incident_speed(chain), mass = 1 / (1 / chain.mass[j] + 1 / chain.mass[j + 1]);
  Spring spring{.stiffness = contact::stiffness(law),
                .damping = contact::damping(law),
                .root = contact::exponent(law) != 1};
  spring.length = std::pow(mass * v * v / spring.stiffness, spring.root ? 0.4 : 0.5);
  spring.load = spring.stiffness * spring.length + spring.damping * v;
  spring.faint = !spring.root ? 0 : (spring.damping > 0 ? 1e-9 : 1e-6) * spring.length;
  return spring;
}

/// Indentations δ_j (negative: a gap) and velocities of a chain, and their Taylor coefficients.
struct SeriesMotion {
  std::vector<double> inverse_mass, gravity;
  std::vector<Spring> spring;
  double speed;
  std::vector<double> indentation, velocity;
  std::vector<bool> pushes;  ///< contacts whose force acts
  std::vector<Series> delta, rate, load, v, width, force;

  explicit SeriesMotion(const model::Chain& chain)
      : speed(incident_speed(chain)), velocity(chain.velocity), pushes(chain.law.size(), false) {
    for (const double m : chain.mass) {
      inverse_mass.push_back(1 / m);
      gravity.push_back(std::isinf(m) ? 0 : chain.gravity);
    }
    for (std::size_t j = 0; j < chain.law.size(); ++j) {
      spring.push_back(make_spring(chain, j));
      indentation.push_back(-chain.gap[j]);
    }
    for (auto* list : {&delta, &rate, &load, &width, &force}) list->resize(spring.size());
    v.resize(velocity.size());
  }

  /// Coefficients of the motion from here on.
  void expand() {
    for (std::size_t i = 0; i < v.size(); ++i) v[i][0] = velocity[i];
    for (std::size_t j = 0; j < spring.size(); ++j) delta[j][0] = indentation[j];
    for (int k = 0; k <= series_order; ++k) {
      for (std::size_t j = 0; j < spring.size(); ++j) {
        rate[j][k] = v[j][k] - v[j + 1][k];
        load[j][k] = spring[j].stiffness * delta[j][k] + spring[j].damping * rate[j][k];
        force[j][k] = pushes[j] ? force_coefficient(j, k) : 0;
      }
      if (k == series_order) break;
      for (std::size_t j = 0; j < spring.size(); ++j) delta[j][k + 1] = rate[j][k] / (k + 1);
      for (std::size_t i = 0; i < v.size(); ++i) {
        const double push = (i > 0 ? force[i - 1][k] : 0) - (i < spring.size() ? force[i][k] : 0);
        v[i][k + 1] = (push * inverse_mass[i] - (k == 0 ? gravity[i] : 0)) / (k + 1);
      }
    }
  }

  /// s = √δ from s² = δ, and f = s (k δ + c δ̇).
  double force_coefficient(std::size_t j, int k) {
    if (!spring[j].root) return load[j][k];
    auto& s = width[j];
    if (k == 0) {
      s[0] = std::sqrt(delta[j][0]);
    } else {
      double sum = k % 2 == 0 ? -s[k / 2] * s[k / 2] : 0;
      for (int i = 1; 2 * i < k; ++i) sum -= 2 * s[i] * s[k - i];
      s[k] = (delta[j][k] + sum) / (2 * s[0]);
    }
    double f = 0;
    for (int i = 0; i <= k; ++i) f += s[i] * load[j][k - i];
    return f;
  }

  /// Longest time for which the last terms change no velocity by more than rounding.
  double reach() const {
    double longest = infinity;
    for (const auto& series : rate)
      for (int k = series_order - 2; k <= series_order; ++k)
        if (series[k] != 0)
          longest = std::min(longest, std::pow(1e-16 * speed / std::abs(series[k]), 1.0 / k));
    return longest;
  }

  static double value(const Series& series, double time) {
    double sum = 0;
    for (int k = series_order; k >= 0; --k) sum = sum * time + series[k];
    return sum;
  }
  static double slope(const Series& series, double time) {
    double sum = 0;
    for (int k = series_order; k >= 1; --k) sum = sum * time + k * series[k];
    return sum;
  }

  void advance(double time) {
    for (std::size_t i = 0; i < v.size(); ++i) velocity[i] = value(v[i], time);
    for (std::size_t j = 0; j < spring.size(); ++j) indentation[j] = value(delta[j], time);
  }
};

}  // namespace mariotte::test
