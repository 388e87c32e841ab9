// Contact laws of the naive simulator: formulas on the contact radius or the indentation, with a memory. They
// share nothing with the laws of the library but their names and numbers.
#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <string_view>

#include "mariotte/contact/law.hpp"
#include "support/naive_curve.hpp"

namespace mariotte::test {

/// What a contact remembers.
struct NaiveMemory {
  double peak = 0;        ///< largest indentation so far
  bool attached = false;  ///< it has touched since it last let go
};

class NaiveLaw {
 public:
  explicit NaiveLaw(const contact::Law& law) : name_(name(law)), pulls_(contact::pulls(law)) {
    std::map<std::string_view, double*> place = {{"stiffness", &k_},
                                                 {"exponent", &n_},
                                                 {"damping", &c_},
                                                 {"loading_stiffness", &loading_},
                                                 {"unloading_stiffness", &unloading_},
                                                 {"effective_modulus", &e_},
                                                 {"effective_radius", &r_},
                                                 {"yield_pressure", &p_},
                                                 {"work_of_adhesion", &w_},
                                                 {"damping_hertz", &hertz_damping_},
                                                 {"damping_adhesion", &ring_damping_}};
    if (const auto* curve = contact::curve(law)) {
      curve_ = NaiveCurve(*curve);
      return;
    }
    for (const auto& [key, value] : contact::parameters(law)) *place.at(key) = value;
    if (w_ > 0) s_ = std::sqrt(2 * std::numbers::pi * w_ / e_);
    if (name_ == "thornton") yield_radius_ = std::numbers::pi * p_ * r_ / (2 * e_);
    if (name_ == "thornton-ning") yield_radius_ = find_yield();
  }

  double force(const NaiveMemory& past, double depth, double rate) const {
    if (curve_.is_given()) return curve_.force(depth);
    if (k_ > 0) return pulls_ ? spring(depth, rate) : std::max(0.0, spring(depth, rate));
    if (name_ == "walton-braun") return walton_braun(std::max(past.peak, depth), depth);
    if (name_ == "thornton") return thornton(std::max(past.peak, depth), depth);
    if (name_ == "dmt") return depth > 0 ? dmt(depth, rate) : 0;
    if (name_ == "brach-dunn") return depth > 0 ? brach_dunn(depth, rate) : 0;
    return adheres(past, depth) ? adhesive(past, depth, rate) : 0;
  }
  /// It closes where its curve begins to act on the way in, and lets go where that ends on the way out.
  bool adheres(const NaiveMemory& past, double depth) const {
    if (!(s_ > 0)) return false;
    const auto c = curve(past.peak);
    return depth > c.dent || (past.attached && depth > last_depth(c));
  }
  /// Depth at which a contact of this reduced mass is stopped, in order of size.
  double natural_depth(double inverse_mass, double speed) const {
    const double energy = speed * speed / (2 * inverse_mass);
    if (curve_.is_given()) return curve_.depth_of(energy);
    if (k_ > 0) {
      return std::pow((n_ + 1) * energy / k_, 1 / (n_ + 1));
    }
    if (name_ == "walton-braun") return std::sqrt(2 * energy / loading_);
    return std::pow(2.5 * energy / hertz(r_), 0.4);
  }

 private:
  double hertz(double radius) const { return 4.0 / 3 * e_ * std::sqrt(radius); }

  double spring(double depth, double rate) const {
    if (!(depth > 0)) return 0;
    const double elastic = k_ * std::pow(depth, n_);
    if (name_ == "hunt-crossley") return elastic * (1 + c_ * rate);
    if (name_ == "tsuji") return elastic + c_ * std::pow(depth, 0.25) * rate;
    return elastic + (c_ == 0 ? 0 : c_ * std::pow(depth, n_ - 1) * rate);
  }
  double walton_braun(double peak, double depth) const {
    return std::max(0.0, std::min(loading_ * depth, unloading_ * depth - (unloading_ - loading_) * peak));
  }
  double thornton(double peak, double depth) const {
    if (!(depth > 0)) return 0;
    const double limit = yield_radius_ * yield_radius_ / r_;
    if (peak <= limit) return hertz(r_) * std::pow(depth, 1.5);
    const double f = hertz(r_) * std::pow(limit, 1.5) + std::numbers::pi * p_ * r_ * (peak - limit);
    const double elastic = hertz(r_) * std::pow(peak, 1.5), left = depth - peak * (1 - f / elastic);
    return left > 0 ? hertz(r_ * elastic / f) * std::pow(left, 1.5) : 0;
  }
  double dmt(double depth, double rate) const {
    return hertz(r_) * std::pow(depth, 1.5) - 2 * std::numbers::pi * w_ * r_ + c_ * std::sqrt(depth) * rate;
  }
  double brach_dunn(double depth, double rate) const {
    const double line = std::cbrt(6 * e_ * r_ * w_ * w_ / std::numbers::pi);
    return hertz(r_) * std::pow(depth, 1.5) * (1 + hertz_damping_ * rate) -
           2 * std::numbers::pi * line * std::sqrt(r_ * depth) * (1 - ring_damping_ * rate);
  }

  /// Radius R and dent of the curve that a contact follows after its deepest point, by the radius there.
  struct Curve {
    double radius, dent;
  };
  double load(double a, double radius) const {
    return e_ * (4 * a * a * a / (3 * radius) - 2 * s_ * std::pow(a, 1.5));
  }
  double yielding(double a) const {
    const double y = yield_radius_;
    return std::numbers::pi * p_ * (a * a - y * y) + 4 * e_ * y * y * y / (3 * r_) -
           2 * e_ * s_ * y * std::sqrt(a);
  }
  Curve curve(double peak) const {
    if (name_ != "thornton-ning" || !(peak > 0)) return {r_, 0};
    const double a = contact_radius(peak, {r_, 0});
    if (a <= yield_radius_) return {r_, 0};
    const double flat = 4.0 / 3 * e_ * a * a * a / (yielding(a) + 2 * e_ * s_ * std::pow(a, 1.5));
    return {flat, a * a * (1 / r_ - 1 / flat)};
  }
  static double last_radius(double s, double radius) { return std::pow(s * radius / 4, 2.0 / 3); }
  double last_depth(const Curve& c) const {
    const double a = last_radius(s_, c.radius);
    return c.dent - 3 * a * a / c.radius;
  }
  /// a ≥ a_f with a²/R − s √a = δ − δ_p, by halving.
  double contact_radius(double depth, const Curve& c) const {
    double low = last_radius(s_, c.radius);
    const auto excess = [&](double a) { return a * a / c.radius - s_ * std::sqrt(a) - (depth - c.dent); };
    double high = std::max(2 * low, std::sqrt(c.radius * std::max(0.0, depth - c.dent)) + 4 * low);
    while (excess(high) < 0) high *= 2;
    for (int i = 0; i < 60 && high - low > 1e-16 * high; ++i) {
      const double middle = (low + high) / 2;
      (excess(middle) < 0 ? low : high) = middle;
    }
    return high;
  }
  double adhesive(const NaiveMemory& past, double depth, double rate) const {
    const auto fresh = Curve{r_, 0};
    if (name_ == "thornton-ning" && depth > past.peak)
      if (const double a = contact_radius(depth, fresh); a > yield_radius_) return yielding(a);
    const auto c = curve(past.peak);
    const double a = contact_radius(depth, c);
    return load(a, c.radius) + (name_ == "jkr" ? c_ * a * rate : 0);
  }
  double find_yield() const {
    const auto excess = [&](double a) {
      return 2 * e_ * a / (std::numbers::pi * r_) - std::sqrt(2 * w_ * e_ / (std::numbers::pi * a)) - p_;
    };
    double low = 0, high = r_;
    while (excess(high) < 0) high *= 2;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (middle == 0 || excess(middle) < 0 ? low : high) = middle;
    }
    return high;
  }

  std::string name_;
  NaiveCurve curve_;
  bool pulls_;
  double k_ = 0, n_ = 1.5, c_ = 0, loading_ = 0, unloading_ = 0, e_ = 0, r_ = 0, p_ = 0, w_ = 0;
  double s_ = 0, yield_radius_ = infinity, hertz_damping_ = 0, ring_damping_ = 0;
};

}  // namespace mariotte::test
