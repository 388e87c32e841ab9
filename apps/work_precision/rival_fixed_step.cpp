// Rivals with a fixed step: the Runge–Kutta–Gill method of order 4 and velocity Verlet.
#include "body_field.hpp"
#include "field.hpp"

namespace mariotte::work_precision {
namespace {

/// Gill's four stages with his single register of accumulated increments
/// [Gill 1951, Proc. Cambridge Phil. Soc. 47, 96–108].
template <class F>
void gill_step(const F& field, double h, typename F::State& x, typename F::State& q,
               typename F::State& slope) {
  constexpr double r = 0.70710678118654752440;
  constexpr double a[] = {0.5, 1 - r, 1 + r, 1.0 / 6};
  constexpr double b[] = {2, 1, 1, 2};
  constexpr double c[] = {0.5, 1 - r, 1 + r, 0.5};
  for (int stage = 0; stage < 4; ++stage) {
    field(x.data(), slope.data());
    for (std::size_t i = 0; i < F::size; ++i) {
      const double growth = a[stage] * (h * slope[i] - b[stage] * q[i]);
      x[i] += growth;
      q[i] += 3 * growth - c[stage] * h * slope[i];
    }
  }
}

template <class F>
class Gill {
 public:
  explicit Gill(const Setting& setting) : setting_(setting) {}
  void solve(const Case& one, Answer& answer) {
    const F field(one, setting_);
    typename F::State x, q{}, slope;
    field.start(one, x.data());
    const double time = F::overtime * one.end;
    answer.steps = static_cast<Index>(std::ceil(setting_.value * time));
    const double h = time / static_cast<double>(answer.steps);
    for (Index i = 0; i < answer.steps; ++i) gill_step(field, h, x, q, slope);
    answer.rhs = 4 * answer.steps;
    field.finish(x.data(), answer);
  }

 private:
  Setting setting_;
};

template <class F>
class Verlet {
 public:
  explicit Verlet(const Setting& setting) : rate_(setting.value) {}
  void solve(const Case& one, Answer& answer) {
    typename F::State x;
    F::start(one, x.data());
    const double time = F::overtime * one.end;
    answer.steps = static_cast<Index>(std::ceil(rate_ * time));
    measuring::verlet(F(one, {}), time, answer.steps, x.data(), x.data() + F::contacts,
                      std::array<double, F::balls>());
    answer.rhs = answer.steps + 1;
    F::finish(x.data(), answer);
  }

 private:
  double rate_;  // steps per unit of time
};

}  // namespace

std::vector<Method> fixed_step_rivals() {
  auto list = rivals<Gill>("rk-gill", Family::fixed_step, chain_rival<Gill>);
  list.push_back({.name = "verlet", .family = Family::fixed_step, .prepare = chain_rival<Verlet>});
  return list;
}

}  // namespace mariotte::work_precision
