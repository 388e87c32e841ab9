// The forces of a step's contacts, and how they move with indentations, rates and the numbers of laws, for
// one instruction set.
#pragma once
#include "mariotte/impact/sensitivity/push_expansion.hpp"
#include "mariotte/impact/sensitivity/push_polynomials.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

using Contact = PushExpansion::Contact;
using Start = PushExpansion::Start;

/// Of a contact, times the pace of the clock: its force per k and per c, and the slopes of its force. With
/// its impulse and the integral of that over time.
struct Force {
  PushPolynomial spring, damper, all, by_depth, by_rate, by_exponent;
  PushPolynomial impulse, travel;
  bool is_damped, has_damper;
  bool has_log;  ///< the slope by the exponent has 2 ln σ times the force, too
};

/// Where contacts start from δ = 0: forces t^{e+κ} zⁱ, with z = t^power.
struct Powers {
  double first, power;
  double once(int i) const { return 1 / (first + 1 + power * i); }
  double twice(int i) const { return 1 / (first + 2 + power * i); }
};

/// Whether slopes of its force have a part of the damper.
inline bool by_damper(const Contact& c) {
  return c.law.damping != 0 || std::any_of(c.slope->law.begin(), c.slope->law.end(),
                                           [](const LawSlope& law) { return law.power.damping != 0; });
}

inline bool has_exponent(const Contact& c) {
  return std::any_of(c.slope->law.begin(), c.slope->law.end(),
                     [](const LawSlope& law) { return law.power.exponent != 0; });
}

/// Forces of all contacts of a step, and time, as series in its clock.
struct Forces {
  const PushSeries* series;
  std::vector<Force> contact;
  PushPolynomial time, half_square;  ///< t and t²/2

  void expand(const PushSeries& whole, const Start& start) {
    series = &whole;
    contact.resize(start.contacts.size());
    if (whole.power == 0) expand_time();
    for (std::size_t j = 0; j < contact.size(); ++j) {
      set_force(start.contacts[j], whole.contact[j], contact[j]);
      whole.power == 0 ? integrate_clock(contact[j]) : integrate_start(contact[j]);
    }
  }

 private:
  int last() const { return series->order - 1; }
  /// x times the pace of the clock; `room` is for that.
  const PushPolynomial& paced(const PushPolynomial& x, PushPolynomial& room) const {
    if (series->is_time) return x;
    multiply(series->pace, x, last(), room);
    return room;
  }

  void expand_time() {
    if (series->is_time) {
      time = {0, 1};
      half_square = {0, 0, 0.5};
      return;
    }
    PushPolynomial room;
    integrate(series->pace, last(), time);
    integrate(paced(time, room), last(), half_square);
  }

  void set_force(const Contact& c, const PushSeries::Contact& own, Force& f) const {
    PushPolynomial room;
    const auto& width = paced(own.root, room);
    f.is_damped = c.law.damping != 0;
    f.has_damper = series->power == 0 && by_damper(c);
    f.has_log = false;
    multiply(width, own.depth, last(), f.spring);
    if (f.has_damper) multiply(width, own.rate, last(), f.damper);
    f.is_damped ? set_damped(c, own, width, f) : set_undamped(c.law, width, f);
  }

  void set_undamped(const contact::PowerLaw& law, const PushPolynomial& width, Force& f) const {
    scale(law.stiffness, f.spring, last(), f.all);
    scale(law.exponent * law.stiffness, width, last(), f.by_depth);
  }

  void set_damped(const Contact& c, const PushSeries::Contact& own, const PushPolynomial& width,
                  Force& f) const {
    const int n = last();
    const double k = c.law.stiffness;
    combine(k, f.spring, c.law.damping, f.damper, n, f.all);
    scale(c.law.damping, width, n, f.by_rate);
    if (has_exponent(c)) set_tilt(own, f);
    if (c.law.exponent == 1)
      scale(k, width, n, f.by_depth);
    else
      combine(k, width, 1, bend(c, own, f.by_depth), n, f.by_depth);
  }

  /// The force times ln δ. In the clock of a contact that closes that is ln (δ/σ²) and 2 ln σ.
  void set_tilt(const PushSeries::Contact& own, Force& f) const {
    f.has_log = own.depth[0] == 0;
    const int later = f.has_log ? 2 : 0;
    PushPolynomial depth{}, log{};
    std::copy_n(own.depth.begin() + later, series->order + 1 - later, depth.begin());
    logarithm(depth, series->order - later, log);
    multiply(f.all, log, last(), f.by_exponent);
  }

  /// δ^{1/2} λ has the slope k δ^{1/2} + λ/(2 δ^{1/2}).
  const PushPolynomial& bend(const Contact& c, const PushSeries::Contact& own, PushPolynomial& room) const {
    PushPolynomial load, product;
    combine(0.5 * c.law.stiffness, own.depth, 0.5 * c.law.damping, own.rate, last(), load);
    if (own.owns_clock)
      room = load;
    else
      divide(paced(load, product), own.root, last(), room);
    return room;
  }

  void integrate_clock(Force& f) const {
    PushPolynomial room;
    integrate(f.all, last(), f.impulse);
    integrate(paced(f.impulse, room), last(), f.travel);
  }

  /// Of forces t^{3/2} zⁱ.
  void integrate_start(Force& f) const {
    const Powers powers{1.5, series->power};
    for (int i = 0; i <= last(); ++i) {
      f.impulse[i] = powers.once(i) * f.all[i];
      f.travel[i] = powers.twice(i) * f.impulse[i];
    }
  }
};

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
