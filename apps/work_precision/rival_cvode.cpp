// Rivals on SUNDIALS as a user writes them. Chains: CVODE with the forces cut off at zero, integrated to a
// fixed time just past the last separation; and CVODE with roots, re-initialised whenever a contact opens or
// closes. Bodies: CVODE with a root at separation.
#include "body_field.hpp"
#include "cvode_memory.hpp"
#include "field.hpp"

namespace mariotte::work_precision {
namespace {

constexpr Index most_restarts = 10'000;
constexpr long most_body_steps = 1'000'000;  // friction that chatters takes any number

/// No events: one call to a fixed time.
template <class F>
class WithoutEvents {
 public:
  WithoutEvents(int method, const Setting& setting) : memory_(setting.value) {
    memory_.create(method, derivative, this);
  }
  void solve(const Case& one, Answer& answer) {
    field_ = F(one, {});
    memory_.start(field_, one);
    double time = 0;
    check(CVode(memory_.cvode.get(), F::overtime * one.end, memory_.state.get(), &time, CV_NORMAL), "a step");
    memory_.count(answer);
    F::finish(memory_.data(), answer);
  }

 private:
  static int derivative(sunrealtype, N_Vector x, N_Vector dx, void* self) {
    static_cast<WithoutEvents*>(self)->field_(NV_DATA_S(x), NV_DATA_S(dx));
    return 0;
  }
  CvodeMemory<F> memory_;
  F field_;
};

template <class F>
struct Adams : WithoutEvents<F> {
  explicit Adams(const Setting& setting) : WithoutEvents<F>(CV_ADAMS, setting) {}
};
template <class F>
struct Bdf : WithoutEvents<F> {
  explicit Bdf(const Setting& setting) : WithoutEvents<F>(CV_BDF, setting) {}
};

/// A root per gap and, with damping, one per load k δ + c δ̇; between roots each contact has its smooth force
/// or none. Balls start a hair apart, for a gap of zero that rounding pushes to and fro raises false roots.
template <class F>
class AdamsWithRoots {
 public:
  explicit AdamsWithRoots(const Setting& setting) : memory_(setting.value), hair_(1e-3 * setting.value) {
    memory_.create(CV_ADAMS, derivative, this);
    check(CVodeRootInit(memory_.cvode.get(), roots, guards), "roots");
    check(CVodeSetNoInactiveRootWarn(memory_.cvode.get()), "quiet roots");
  }
  void solve(const Case& one, Answer& answer) {
    field_ = F(one, {});
    closed_.fill(false);
    apart_ = one;
    auto& gap = std::get<model::Chain>(apart_.model).gap;
    for (std::size_t j = 0; j < F::contacts; ++j) gap[j] += hair_ * field_.depth(j);
    memory_.start(field_, apart_);
    const double end = F::overtime * one.end;
    for (double time = 0; time < end;) {
      const int code = CVode(memory_.cvode.get(), end, memory_.state.get(), &time, CV_NORMAL);
      check(code, "a step");
      memory_.count(answer);
      if (code == CV_ROOT_RETURN) restart(time, answer);
      if (answer.events == most_restarts) throw Error("CVODE: roots without end");
    }
    F::finish(memory_.data(), answer);
  }

 private:
  static constexpr int roots = (F::damped ? 2 : 1) * F::contacts;

  void restart(double time, Answer& answer) {
    std::array<int, roots> crossed;
    check(CVodeGetRootInfo(memory_.cvode.get(), crossed.data()), "root information");
    for (std::size_t j = 0; j < F::contacts; ++j) {
      if (crossed[j]) closed_[j] = crossed[j] < 0;
      if constexpr (F::damped)
        if (const int load = crossed[F::contacts + j]) closed_[j] = load > 0 && memory_.data()[j] < 0;
    }
    ++answer.events;
    check(CVodeReInit(memory_.cvode.get(), time, memory_.state.get()), "restart");
  }
  static int derivative(sunrealtype, N_Vector x, N_Vector dx, void* self) {
    const auto& rival = *static_cast<AdamsWithRoots*>(self);
    rival.field_.derivative(NV_DATA_S(x), NV_DATA_S(dx),
                            [&](std::size_t j, double force) { return rival.closed_[j] ? force : 0.0; });
    return 0;
  }
  static int guards(sunrealtype, N_Vector x, sunrealtype* values, void* self) {
    const auto& rival = *static_cast<AdamsWithRoots*>(self);
    const double *gap = NV_DATA_S(x), *velocity = gap + F::contacts;
    for (std::size_t j = 0; j < F::contacts; ++j) {
      values[j] = gap[j];
      if constexpr (F::damped)
        values[F::contacts + j] =
            -rival.field_.stiffness[j] * gap[j] + rival.field_.damping * (velocity[j] - velocity[j + 1]);
    }
    return 0;
  }

  CvodeMemory<F> memory_;
  F field_;
  double hair_;  // relative to the depth scale
  Case apart_;
  std::array<bool, F::contacts> closed_{};
};

/// A root at separation ends the run; no other event is looked for.
template <class F>
class ToSeparation {
 public:
  ToSeparation(int method, const Setting& setting) : setting_(setting), memory_(setting.value) {
    memory_.create(method, derivative, this);
    check(CVodeSetMaxNumSteps(memory_.cvode.get(), most_body_steps), "step limit");
    check(CVodeRootInit(memory_.cvode.get(), 1, gap), "root");
    int rising = 1;
    check(CVodeSetRootDirection(memory_.cvode.get(), &rising), "direction");
    check(CVodeSetNoInactiveRootWarn(memory_.cvode.get()), "quiet root");
  }
  void solve(const Case& one, Answer& answer) {
    field_ = F(one, setting_);
    memory_.start(field_, one);
    double time = 0;
    const int code = CVode(memory_.cvode.get(), 2 * one.end, memory_.state.get(), &time, CV_NORMAL);
    check(code, "a step");
    if (code != CV_ROOT_RETURN) throw Error("CVODE: no separation");
    answer.events = 1;
    memory_.count(answer);
    field_.finish(memory_.data(), answer);
  }

 private:
  static int derivative(sunrealtype, N_Vector x, N_Vector dx, void* self) {
    static_cast<ToSeparation*>(self)->field_(NV_DATA_S(x), NV_DATA_S(dx));
    return 0;
  }
  static int gap(sunrealtype, N_Vector x, sunrealtype* value, void*) {
    *value = NV_Ith_S(x, 0);
    return 0;
  }

  Setting setting_;
  CvodeMemory<F> memory_;
  F field_;
};

template <class F>
struct AdamsToSeparation : ToSeparation<F> {
  explicit AdamsToSeparation(const Setting& setting) : ToSeparation<F>(CV_ADAMS, setting) {}
};
template <class F>
struct BdfToSeparation : ToSeparation<F> {
  explicit BdfToSeparation(const Setting& setting) : ToSeparation<F>(CV_BDF, setting) {}
};

/// Undamped contacts are not stiff, and BDF never pays for them.
Solve bdf_if_damped(const Problem& problem, double tolerance) {
  const bool damped = !problem.has_body() && contact::damping(chain_of(problem.cases.front()).law[0]) > 0;
  return damped ? chain_rival<Bdf>(problem, tolerance) : Solve();
}

}  // namespace

std::vector<Method> cvode_rivals() {
  std::vector<Method> list = {
      {.name = "sundials-adams", .family = Family::sundials, .prepare = chain_rival<Adams>},
      {.name = "sundials-bdf", .family = Family::sundials, .prepare = bdf_if_damped}};
  append(list,
         rivals<AdamsToSeparation>("sundials-adams-roots", Family::sundials, chain_rival<AdamsWithRoots>));
  append(list, rivals<BdfToSeparation>("sundials-bdf-roots", Family::sundials));
  return list;
}

}  // namespace mariotte::work_precision
