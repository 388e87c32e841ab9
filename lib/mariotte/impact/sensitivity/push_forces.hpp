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
  double ratio;  ///< n k/c
  bool is_damped;
  bool has_spring, has_damper;  ///< known apart, for slopes by the numbers of the law
  bool has_log;                 ///< the slope by the exponent has 2 ln σ times the force, too
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

/// Whether accelerations have slopes.
inline bool is_driven(const Start& start) {
  const auto& slopes = start.acceleration.values;
  return std::any_of(slopes.begin(), slopes.end(), [](double slope) { return slope != 0; });
}

/// Forces of all contacts of a step, and time, as series in its clock.
struct Forces {
  const PushSeries* series;
  std::vector<Force> contact;
  PushPolynomial time, half_square;  ///< t, and if anything is driven t²/2

  void expand(const PushSeries& whole, const Start& start) {
    series = &whole;
    contact.resize(start.contacts.size());
    if (whole.power == 0) expand_time(is_driven(start));
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

  void expand_time(bool has_square) {
    if (series->is_time) {
      time = {0, 1};
      half_square = {0, 0, 0.5};
      return;
    }
    integrate(series->pace, time);
    PushPolynomial room;
    if (has_square) integrate(paced(time, room), half_square);
  }

  void set_force(const Contact& c, const PushSeries::Contact& own, Force& f) const {
    PushPolynomial room;
    const auto& width = paced(own.root, room);
    f.is_damped = c.law.damping != 0;
    f.has_spring = !c.slope->law.empty();
    f.has_damper = f.has_spring && series->power == 0 && by_damper(c);
    f.has_log = false;
    f.has_spring ? set_parts(c.law, own, width, f) : set_whole(c.law, own, width, f);
    if (f.is_damped && has_exponent(c)) set_tilt(own, f);
    set_slopes(c.law, own, width, f);
  }

  void set_whole(const contact::PowerLaw& law, const PushSeries::Contact& own, const PushPolynomial& width,
                 Force& f) const {
    PushPolynomial load;
    if (f.is_damped)
      combine(law.stiffness, own.depth, law.damping, own.rate, load);
    else
      scale(law.stiffness, own.depth, load);
    multiply(width, load, last(), f.all);
  }

  void set_parts(const contact::PowerLaw& law, const PushSeries::Contact& own, const PushPolynomial& width,
                 Force& f) const {
    multiply(width, own.depth, last(), f.spring);
    if (f.has_damper) multiply(width, own.rate, last(), f.damper);
    if (f.is_damped)
      combine(law.stiffness, f.spring, law.damping, f.damper, f.all);
    else
      scale(law.stiffness, f.spring, f.all);
  }

  /// By depth and rate. Of a damped Hertz contact, δ^{1/2} (k δ + c δ̇), the former has the part c d√δ/dt.
  void set_slopes(const contact::PowerLaw& law, const PushSeries::Contact& own, const PushPolynomial& width,
                  Force& f) const {
    const double stiffness = law.exponent * law.stiffness;
    scale(stiffness, width, f.by_depth);
    if (!f.is_damped) return;
    scale(law.damping, width, f.by_rate);
    f.ratio = stiffness / law.damping;
    if (series->is_time) f.by_rate[series->order] = law.damping * last_of_root(law, own);
    PushPolynomial growth;
    if (law.exponent != 1 && !series->is_time)
      combine(stiffness, width, law.damping, root_growth(law, own, growth), f.by_depth);
  }

  /// d√δ/dσ. The contact whose root is the clock's pace has half of its rate.
  const PushPolynomial& root_growth(const contact::PowerLaw& law, const PushSeries::Contact& own,
                                    PushPolynomial& room) const {
    if (own.owns_clock) {
      scale(0.5, own.rate, room);
      return room;
    }
    for (int i = 1; i <= last(); ++i) room[i - 1] = i * own.root[i];
    room[last()] = series->order * last_of_root(law, own);
    return room;
  }

  /// One order beyond those that are known.
  double last_of_root(const contact::PowerLaw& law, const PushSeries::Contact& own) const {
    return law.exponent == 1 ? 0 : next_of_root(own.depth, series->order, own.root);
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

  void integrate_clock(Force& f) const {
    PushPolynomial room;
    integrate(f.all, f.impulse);
    integrate(paced(f.impulse, room), f.travel);
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
