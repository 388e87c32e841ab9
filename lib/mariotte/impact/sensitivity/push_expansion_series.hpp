// Slopes as series, for one instruction set: included by one source file for each, which names the namespace.
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/flow/taylor/taylor_registers.hpp"
#include "mariotte/impact/sensitivity/push_expansion.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

using flow::PushPolynomial;
using flow::PushSeries;
namespace registers = flow::taylor::MARIOTTE_INSTRUCTION_SET;
using Contact = PushExpansion::Contact;
using Start = PushExpansion::Start;

/// One number for each of several parameters, in N registers.
template <int N>
struct Lanes : registers::LaneVector<N> {
  using Base = registers::LaneVector<N>;
  using Base::Base;
  static constexpr Index count = N * registers::width;

  Lanes(const Base& a) : Base(a) {}
  double& operator[](Index i) { return reinterpret_cast<double*>(this->part)[i]; }
  double operator[](Index i) const { return reinterpret_cast<const double*>(this->part)[i]; }
  MARIOTTE_SERIES_INLINE Lanes& operator+=(const Base& a) { return *this = *this + a; }
  MARIOTTE_SERIES_INLINE Lanes& operator*=(double a) { return *this = a * *this; }
};
template <int N>
MARIOTTE_SERIES_INLINE Lanes<N> magnitude(const Lanes<N>& a) {
  return registers::each<N>([&](int i) { return registers::magnitude(a.part[i]); });
}
template <int N>
MARIOTTE_SERIES_INLINE Lanes<N> largest(const Lanes<N>& a, const Lanes<N>& b) {
  return registers::each<N>([&](int i) { return registers::largest(a.part[i], b.part[i]); });
}

/// Coefficients 0 to `order` of a product.
inline PushPolynomial product(const PushPolynomial& a, const PushPolynomial& b, int order) {
  PushPolynomial result;
  for (int i = 0; i <= order; ++i) {
    double sum = 0;
    for (int k = 0; k <= i; ++k) sum += a[i - k] * b[k];
    result[i] = sum;
  }
  return result;
}

inline PushPolynomial quotient(const PushPolynomial& a, const PushPolynomial& b, int order) {
  PushPolynomial result;
  for (int i = 0; i <= order; ++i) {
    double sum = a[i];
    for (int k = 0; k < i; ++k) sum -= b[i - k] * result[k];
    result[i] = sum / b[0];
  }
  return result;
}

/// Σ a δ + b δ̇ of two series.
inline PushPolynomial sum(double a, const PushPolynomial& x, double b, const PushPolynomial& y, int order) {
  PushPolynomial result;
  for (int i = 0; i <= order; ++i) result[i] = a * x[i] + (b == 0 ? 0 : b * y[i]);
  return result;
}

/// Of a contact, times the pace of the clock: its force per k and per c, and the slopes of its force.
struct Coefficients {
  PushPolynomial spring, damper, force, by_depth, by_rate;
};

/// Which powers of t the series are made of: forces t^{e+κ} zⁱ, with z = t^power.
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

inline Coefficients coefficients_of(const Contact& c, const PushSeries& series,
                                    const PushSeries::Contact& own) {
  const int n = series.order - 1;
  const bool curved = c.law.exponent != 1, damped = c.law.damping != 0;
  const double k = c.law.stiffness;
  Coefficients f{};
  const auto paced = [&](const PushPolynomial& x) { return series.is_time ? x : product(series.pace, x, n); };
  const auto width = paced(own.root);
  f.spring = product(width, own.depth, n);
  if (series.power == 0 && by_damper(c)) f.damper = product(width, own.rate, n);
  f.force = sum(k, f.spring, c.law.damping, f.damper, n);
  if (damped) f.by_rate = sum(c.law.damping, width, 0, width, n);
  if (!curved) {
    f.by_depth = sum(k, width, 0, width, n);
  } else if (!damped) {
    f.by_depth = sum(1.5 * k, width, 0, width, n);
  } else {  // δ^{1/2} λ has the slope k δ^{1/2} + λ/(2 δ^{1/2})
    const auto load = sum(0.5 * k, own.depth, 0.5 * c.law.damping, own.rate, n);
    const auto bend = own.owns_clock ? load : quotient(paced(load), own.root, n);
    f.by_depth = sum(k, width, 1, bend, n);
  }
  return f;
}

/// The series of as many parameters as N registers hold. Keeps its memory from step to step.
template <int N>
class PackSeries {
 public:
  using Pack = Lanes<N>;

  /// Parameters from `first` on, up to `stop` at most: how far the series reaches.
  double expand(const PushSeries& whole, std::span<const Coefficients> of_contacts, const Start& start,
                Index first, double stop, const PushExpansion::Bound& bound, const PushExpansion::End& end) {
    series = &whole;
    coefficients = of_contacts;
    const Index columns = std::min<Index>(Pack::count, start.velocity.columns - first);
    if (series->power > 0) {
      expand_start(start, first, columns);
      if (excess(first, columns, bound) > 1) return 0;
    } else {
      expand_clock(start, first, columns);
      stop = reach(stop, first, columns, bound);
    }
    if (stop > 0) tell(first, columns, end);
    return stop;
  }

 private:
  const PushSeries* series = nullptr;
  std::span<const Coefficients> coefficients;
  std::vector<Pack> depth, rate, force;      ///< of contacts, by order
  std::vector<Pack> velocity, displacement;  ///< by order
  std::vector<Pack> end_velocity, end_displacement, end_impulse;
  Pack last;  ///< size of the last terms

  /// Last terms over what they may be.
  double excess(Index first, Index columns, const PushExpansion::Bound& bound) const {
    double most = 0;
    for (Index c = 0; c < columns; ++c) {
      double size = bound.natural[first + c];
      for (Index v = 0; v < velocities; ++v) size = std::max(size, std::abs(end_velocity[v][c]));
      const double own = last[c] / (bound.tolerance * size);
      most = own <= most ? most : own;  // what is not a number stays
    }
    return most;
  }

  double reach(double stop, Index first, Index columns, const PushExpansion::Bound& bound) {
    constexpr int attempts = 3;
    for (int n = 0; n < attempts; ++n) {
      evaluate_clock(stop);
      const double over = excess(first, columns, bound);
      if (over <= 1) return stop;
      stop *= 0.95 * std::pow(over, -1.0 / (order() - 1));
    }
    return 0;
  }

  void tell(Index first, Index columns, const PushExpansion::End& end) const {
    for (Index c = 0; c < columns; ++c) {
      for (Index v = 0; v < velocities; ++v) {
        end.velocity(v, first + c) = end_velocity[v][c];
        end.displacement(v, first + c) = end_displacement[v][c];
      }
      for (Index j = 0; j < contacts; ++j) end.impulse(j, first + c) = end_impulse[j][c];
    }
  }

  int order() const { return series->order; }
  Index contacts = 0, velocities = 0;

  /// Σ a_{i−k} x_k of a contact or a velocity; two sums, which need not wait for each other.
  static Pack convolution(const PushPolynomial& a, const Pack* x, Index count, int i) {
    Pack even = a[i] * x[0], odd(0.0);
    int k = 1;
    for (; k < i; k += 2) {
      odd = odd + a[i - k] * x[k * count];
      even = even + a[i - k - 1] * x[(k + 1) * count];
    }
    if (k == i) odd = odd + a[0] * x[k * count];
    return even + odd;
  }

  Pack& at(std::vector<Pack>& list, Index count, int i, Index j) const { return list[i * count + j]; }

  void resize(Index m, Index n) {
    contacts = m;
    velocities = n;
    const auto orders = static_cast<std::size_t>(order() + 3);
    for (auto* list : {&depth, &rate, &force}) list->assign(orders * m, Pack(0.0));
    for (auto* list : {&velocity, &displacement}) list->assign(orders * n, Pack(0.0));
  }

  /// Slopes of the force of contact j at order i, times the pace.
  Pack force_slope(const Contact& c, Index j, int i, Index first, Index columns, bool with_source) {
    const auto& own = coefficients[j];
    Pack sum = convolution(own.by_depth, &depth[j], contacts, i);
    if (c.law.damping != 0) sum += convolution(own.by_rate, &rate[j], contacts, i);
    if (!with_source) return sum;
    for (const auto& law : c.slope->law)
      if (law.column >= first && law.column < first + columns)
        sum[law.column - first] += law.power.stiffness * own.spring[i] + law.power.damping * own.damper[i];
    return sum;
  }

  /// What the force of order i of contact j gives to the coefficients `to` of velocities.
  void push(const Contact& c, const Start& start, Index j, int i, int to, Index first, Index columns,
            bool with_source) {
    for (const auto& [v, coefficient] : c.push)
      at(velocity, velocities, to, v) += coefficient * at(force, contacts, i, j);
    if (!with_source) return;
    for (const auto& term : c.slope->push)
      if (term.column >= first && term.column < first + columns)
        at(velocity, velocities, to, start.number[term.place])[term.column - first] +=
            term.slope * coefficients[j].force[i];
  }

  Pack gap_slope(const Contact& c, std::vector<Pack>& motion, int i) {
    Pack sum = Pack(0.0);
    for (const auto& [v, coefficient] : c.direction) sum += -coefficient * at(motion, velocities, i, v);
    return sum;
  }

  void begin_clock(const Start& start, Index first, Index columns) {
    resize(std::ssize(start.contacts), start.velocity.rows);
    for (Index v = 0; v < velocities; ++v)
      for (Index c = 0; c < columns; ++c) at(velocity, velocities, 0, v)[c] = start.velocity(v, first + c);
    for (Index j = 0; j < contacts; ++j) {
      for (Index c = 0; c < columns; ++c) at(depth, contacts, 0, j)[c] = start.contacts[j].depth[first + c];
      at(rate, contacts, 0, j) = gap_slope(start.contacts[j], velocity, 0);
    }
  }

  /// Coefficients i + 1 of a velocity, whose pushes stand there already, and of its displacement.
  void move(const Start& start, Index v, int i, Index first, Index columns) {
    const double share = 1.0 / (i + 1), pace = series->is_time ? i == 0 : series->pace[i];
    Pack& next = at(velocity, velocities, i + 1, v);
    for (Index c = 0; pace != 0 && c < columns; ++c) next[c] += pace * start.acceleration(v, first + c);
    next *= share;
    at(displacement, velocities, i + 1, v) =
        share * (series->is_time ? at(velocity, velocities, i, v)
                                 : convolution(series->pace, &velocity[v], velocities, i));
  }

  /// In a clock σ: velocities from order 0, displacements by V' = φ, X' = pace V.
  void expand_clock(const Start& start, Index first, Index columns) {
    begin_clock(start, first, columns);
    for (int i = 0; i < order(); ++i) {
      for (Index j = 0; j < contacts; ++j) {
        at(force, contacts, i, j) = force_slope(start.contacts[j], j, i, first, columns, true);
        push(start.contacts[j], start, j, i, i + 1, first, columns, true);
      }
      for (Index v = 0; v < velocities; ++v) move(start, v, i, first, columns);
      for (Index j = 0; j < contacts; ++j) {
        at(depth, contacts, i + 1, j) = gap_slope(start.contacts[j], displacement, i + 1);
        if (start.contacts[j].law.damping != 0)
          at(rate, contacts, i + 1, j) = gap_slope(start.contacts[j], velocity, i + 1);
      }
    }
  }

  void evaluate_clock(double s) {
    const int n = order();
    end_velocity.assign(velocities, Pack(0.0));
    end_displacement.assign(velocities, Pack(0.0));
    end_impulse.assign(contacts, Pack(0.0));
    last = Pack(0.0);
    const double highest = std::pow(s, n - 1);
    for (Index v = 0; v < velocities; ++v) {
      for (int i = n; i >= 0; --i) {
        end_velocity[v] = s * end_velocity[v] + at(velocity, velocities, i, v);
        end_displacement[v] = s * end_displacement[v] + at(displacement, velocities, i, v);
      }
      last = largest(last, Pack(highest * (s * magnitude(at(velocity, velocities, n, v)) +
                                           magnitude(at(velocity, velocities, n - 1, v)))));
    }
    for (Index j = 0; j < contacts; ++j)
      for (int i = n; i >= 1; --i)
        end_impulse[j] = s * (end_impulse[j] + (1.0 / i) * at(force, contacts, i - 1, j));
  }

  /// What velocities and displacements are without any push.
  void fly(const Start& start, double t, Index first, Index columns) {
    end_impulse.assign(std::ssize(start.contacts), Pack(0.0));
    end_velocity.assign(start.velocity.rows, Pack(0.0));
    end_displacement.assign(start.velocity.rows, Pack(0.0));
    for (Index v = 0; v < start.velocity.rows; ++v)
      for (Index c = 0; c < columns; ++c) {
        const double speed = start.velocity(v, first + c), gain = t * start.acceleration(v, first + c);
        end_velocity[v][c] = speed + gain;
        end_displacement[v][c] = t * (speed + 0.5 * gain);
      }
  }

  /// Where contacts start from δ = 0 depths are t^e Σ sᵢ zⁱ: with e = 0 what comes from their slopes, and
  /// with e = 1 what comes from those of their rates and from the forces. Both have forces t^{e + 1/2} zⁱ,
  /// which give depths t^{e + 5/2} zⁱ, t^{5/2} being one or two powers of z.
  void expand_start(const Start& start, Index first, Index columns) {
    fly(start, series->end, first, columns);
    last = Pack(0.0);
    for (const int e : {0, 1}) {
      const Powers powers{e + 0.5, series->power};
      begin_start(start, e, first, columns);
      for (int i = 0; i < order(); ++i) next_start(start, e, powers, i, first, columns);
      evaluate_start(e, powers);
    }
  }

  void begin_start(const Start& start, int e, Index first, Index columns) {
    resize(std::ssize(start.contacts), start.velocity.rows);
    for (Index j = 0; j < contacts; ++j)
      for (Index c = 0; c < columns; ++c) {
        double slope = e == 0 ? start.contacts[j].depth[first + c] : 0;
        if (e == 1)
          for (const auto& [v, coefficient] : start.contacts[j].direction)
            slope -= coefficient * start.velocity(v, first + c);
        at(depth, contacts, 0, j)[c] = slope;
      }
  }

  void next_start(const Start& start, int e, const Powers& powers, int i, Index first, Index columns) {
    const int shift = static_cast<int>(std::lround(2.5 / series->power));
    for (Index j = 0; j < contacts; ++j) {
      at(force, contacts, i, j) = force_slope(start.contacts[j], j, i, first, columns, e == 1);
      push(start.contacts[j], start, j, i, i, first, columns, e == 1);
    }
    for (Index v = 0; v < velocities; ++v) {
      at(velocity, velocities, i, v) *= powers.once(i);
      at(displacement, velocities, i, v) = powers.twice(i) * at(velocity, velocities, i, v);
    }
    for (Index j = 0; i + shift < order() && j < contacts; ++j)
      at(depth, contacts, i + shift, j) += gap_slope(start.contacts[j], displacement, i);
  }

  void evaluate_start(int e, const Powers& powers) {
    const double t = series->end, z = std::pow(t, series->power), unit = std::pow(t, e + 1.5);
    const double highest = unit * std::pow(z, order() - 2);
    for (Index v = 0; v < velocities; ++v) {
      Pack speed = Pack(0.0), way = Pack(0.0);
      for (int i = order() - 1; i >= 0; --i) {
        speed = z * speed + at(velocity, velocities, i, v);
        way = z * way + at(displacement, velocities, i, v);
      }
      end_velocity[v] += unit * speed;
      end_displacement[v] += unit * t * way;
      last = largest(last, Pack(highest * (z * magnitude(at(velocity, velocities, order() - 1, v)) +
                                           magnitude(at(velocity, velocities, order() - 2, v)))));
    }
    for (Index j = 0; j < contacts; ++j) {
      Pack given = Pack(0.0);
      for (int i = order() - 1; i >= 0; --i) given = z * given + powers.once(i) * at(force, contacts, i, j);
      end_impulse[j] += unit * given;
    }
  }
};

class Expansion final : public PushExpansion {
 public:
  double expand(const PushSeries& series, const Start& start, const Bound& bound, End end) override {
    coefficients_.clear();
    for (std::size_t j = 0; j < start.contacts.size(); ++j)
      coefficients_.push_back(coefficients_of(start.contacts[j], series, series.contact[j]));
    double stop = series.end;
    for (Index first = 0; first < start.velocity.columns;) {
      const auto carry = [&](auto& pack) {
        const double reached = pack.expand(series, coefficients_, start, first, stop, bound, end);
        first += std::decay_t<decltype(pack)>::Pack::count;
        return reached;
      };
      const Index left = start.velocity.columns - first;
      const bool is_first = first == 0;
      const double reached = left <= four ? carry(one_) : left <= 2 * four ? carry(two_) : carry(three_);
      if (reached == 0) return 0;
      if (reached < stop && !is_first) first = 0;  // those before must stop there, too
      stop = reached;
    }
    return stop;
  }

 private:
  static constexpr int four = 4, unit = four / registers::width;
  std::vector<Coefficients> coefficients_;
  PackSeries<unit> one_;
  PackSeries<2 * unit> two_;
  PackSeries<3 * unit> three_;
};

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
