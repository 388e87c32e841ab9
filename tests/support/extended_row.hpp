// Undamped rows of linear and Hertz contacts in extended precision, without the library: power series in the
// clock dt = Π √δ dσ of the Hertz contacts that are closed, in which onset and separation are regular.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "mariotte/model/chain/chain.hpp"

namespace mariotte::test {

/// Velocities at the end, and how often contacts have closed.
struct ExtendedEnd {
  std::vector<long double> velocity;
  Index periods = 0;
};

class ExtendedRow {
  using Real = long double;
  static constexpr int order = 26;
  using Series = std::array<Real, order + 1>;

 public:
  explicit ExtendedRow(const model::Chain& chain)
      : speed_(chain.velocity.size()), gap_(chain.law.size()), closed_(chain.law.size()) {
    mass_.assign(chain.mass.begin(), chain.mass.end());
    for (const auto& law : chain.law) {
      stiffness_.push_back(std::get<contact::PowerLaw>(law).stiffness);
      hertz_.push_back(std::get<contact::PowerLaw>(law).exponent == 1.5);
    }
    for (std::size_t i = 0; i < mass_.size(); ++i) speed_[i][0] = chain.velocity[i];
    for (std::size_t j = 0; j < hertz_.size(); ++j) gap_[j][0] = chain.gap[j];
  }

  /// Follows contacts that do not touch at the start until all have parted.
  ExtendedEnd run() {
    ExtendedEnd end;
    while (!over()) {
      expand();
      std::size_t fired = hertz_.size();
      const Real step = first_event(length(), fired);
      for (auto& series : speed_) series[0] = value(series, step);
      for (auto& series : gap_) series[0] = value(series, step);
      if (fired == hertz_.size()) continue;
      gap_[fired][0] = 0;
      closed_[fired] = !closed_[fired];
      end.periods += closed_[fired];
    }
    for (const auto& series : speed_) end.velocity.push_back(series[0]);
    return end;
  }

 private:
  static Real product(const Series& a, const Series& b, int k) {
    Real sum = 0;
    for (int j = 0; j <= k; ++j) sum += a[j] * b[k - j];
    return sum;
  }
  static Real value(const Series& a, Real t) {
    Real sum = 0;
    for (int k = order; k >= 0; --k) sum = sum * t + a[k];
    return sum;
  }
  bool roots(std::size_t j) const { return closed_[j] && hertz_[j]; }
  Real approach(std::size_t j, int k) const { return speed_[j][k] - speed_[j + 1][k]; }

  bool over() const {
    for (std::size_t j = 0; j < hertz_.size(); ++j)
      if (closed_[j] || approach(j, 0) > 0) return false;
    return true;
  }

  /// `gap_` is √δ of a closed Hertz contact, and the gap of any other.
  void expand() {
    const std::size_t contacts = hertz_.size();
    std::vector<Series> before(contacts + 1), behind(contacts + 1), others(contacts), force(contacts),
        square(contacts), slowness(contacts), pull(mass_.size());
    for (int k = 0; k < order; ++k) {
      before[0][k] = behind[contacts][k] = k == 0;
      for (std::size_t j = 0; j < contacts; ++j)
        before[j + 1][k] = roots(j) ? product(before[j], gap_[j], k) : before[j][k];
      for (std::size_t j = contacts; j-- > 0;)
        behind[j][k] = roots(j) ? product(behind[j + 1], gap_[j], k) : behind[j + 1][k];
      for (std::size_t j = 0; j < contacts; ++j) {
        others[j][k] = product(before[j], behind[j + 1], k);
        square[j][k] = product(gap_[j], gap_[j], k);
        slowness[j][k] = approach(j, k);
        if (closed_[j])
          force[j][k] = stiffness_[j] * (hertz_[j] ? product(square[j], gap_[j], k) : -gap_[j][k]);
      }
      for (std::size_t i = 0; i < mass_.size(); ++i) {
        pull[i][k] = ((i > 0 ? force[i - 1][k] : 0) - (i < contacts ? force[i][k] : 0)) / mass_[i];
        speed_[i][k + 1] = product(pull[i], before[contacts], k) / (k + 1);
      }
      for (std::size_t j = 0; j < contacts; ++j)
        gap_[j][k + 1] =
            (roots(j) ? product(slowness[j], others[j], k) / 2 : -product(slowness[j], before[contacts], k)) /
            (k + 1);
    }
  }

  /// What the last coefficients allow; a flight goes beyond its first meeting.
  Real length() const {
    Real step = infinity;
    for (int k = order - 3; k <= order; ++k) {
      Real most = 0;
      for (const auto& series : speed_) most = std::max(most, std::abs(series[k]));
      for (std::size_t j = 0; j < hertz_.size(); ++j)
        if (closed_[j])
          most = std::max(most, std::abs(gap_[j][k]) / std::max(Real(1e-6), std::abs(gap_[j][0])));
      if (most > 0) step = std::min(step, std::pow(Real(1e-21) / most, Real(1) / k));
    }
    if (step < infinity) return step;
    for (std::size_t j = 0; j < hertz_.size(); ++j)
      if (approach(j, 0) > 0) step = std::min(step, gap_[j][0] / approach(j, 0));
    return Real(1.001) * step;
  }

  /// A guard falls through zero: √δ or −gap of what is closed, the gap of what is open.
  Real guard(std::size_t j, Real t) const {
    return closed_[j] && !hertz_[j] ? -value(gap_[j], t) : value(gap_[j], t);
  }
  Real first_event(Real step, std::size_t& fired) const {
    constexpr int looks = 24;
    for (std::size_t j = 0; j < hertz_.size(); ++j)
      for (int look = 1; look <= looks; ++look) {
        Real low = step * (look - 1) / looks, high = step * look / looks;
        if (low == 0) low = Real(1e-12) * high;  // what has just closed or opened starts at zero
        if (guard(j, low) < 0 || guard(j, high) >= 0) continue;
        for (int halving = 0; halving < 70; ++halving) {
          const Real middle = (low + high) / 2;
          (guard(j, middle) < 0 ? high : low) = middle;
        }
        step = high, fired = j;
        break;
      }
    return step;
  }

  std::vector<Real> mass_, stiffness_;
  std::vector<bool> hertz_;
  std::vector<Series> speed_, gap_;
  std::vector<bool> closed_;
};

}  // namespace mariotte::test
