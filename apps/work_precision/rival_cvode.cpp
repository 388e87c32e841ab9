// Rivals on SUNDIALS as a user writes them: CVODE with the forces cut off at zero, integrated to a fixed time
// just past the last separation; and CVODE with roots, re-initialised whenever a contact opens or closes.
// Memory is taken once and used for every impact.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "field.hpp"

namespace mariotte::work_precision {
namespace {

constexpr long most_steps = 10'000'000;
constexpr Index most_restarts = 10'000;

void check(int code, const char* what) {
  if (code < 0) throw Error(std::string("CVODE: ") + what + " failed with code " + std::to_string(code));
}

struct Free {
  void operator()(_SUNContext* c) const { SUNContext_Free(&c); }
  void operator()(_generic_N_Vector* v) const { N_VDestroy(v); }
  void operator()(_generic_SUNMatrix* m) const { SUNMatDestroy(m); }
  void operator()(_generic_SUNLinearSolver* s) const { SUNLinSolFree(s); }
  void operator()(_generic_SUNNonlinearSolver* s) const { SUNNonlinSolFree(s); }
  void operator()(void* memory) const { CVodeFree(&memory); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

/// Size of a gap during an impact at unit speed of unit masses: what its absolute tolerance is relative to.
template <class F>
double depth_scale(const F& field, std::size_t contact) {
  constexpr bool linear = std::is_same_v<F, Field<F::balls, LinearForce>>;
  return std::pow(field.stiffness[contact], linear ? -0.5 : -0.4);
}

/// What both methods share: memory, tolerances and the field that CVODE's callbacks read.
template <class F>
class Memory {
 public:
  explicit Memory(double tolerance) : tolerance_(tolerance) {
    SUNContext raw = nullptr;
    check(SUNContext_Create(nullptr, &raw), "context");
    context.reset(raw);
    state.reset(N_VNew_Serial(F::size, raw));
    allowed_.reset(N_VNew_Serial(F::size, raw));
    N_VConst(0, state.get());
  }
  void create(int method, CVRhsFn derivative, void* self) {
    cvode.reset(CVodeCreate(method, context.get()));
    check(CVodeSetErrHandlerFn(
              cvode.get(), [](int, const char*, const char*, char*, void*) {}, nullptr),
          "error handler");
    check(CVodeInit(cvode.get(), derivative, 0, state.get()), "start");
    check(CVodeSetUserData(cvode.get(), self), "user data");
    check(CVodeSetMaxNumSteps(cvode.get(), most_steps), "step limit");
    check(CVodeSetMaxStep(cvode.get(), longest_step), "longest step");
    if (method == CV_ADAMS) {
      fixed_point_.reset(SUNNonlinSol_FixedPoint(state.get(), 0, context.get()));
      check(CVodeSetNonlinearSolver(cvode.get(), fixed_point_.get()), "fixed-point iteration");
    } else {
      matrix_.reset(SUNDenseMatrix(F::size, F::size, context.get()));
      linear_.reset(SUNLinSol_Dense(state.get(), matrix_.get(), context.get()));
      check(CVodeSetLinearSolver(cvode.get(), linear_.get(), matrix_.get()), "linear solver");
    }
  }
  void start(const Case& one) {
    F::start(one.chain, data());
    double* allowed = N_VGetArrayPointer(allowed_.get());
    const F field(one.chain);
    for (std::size_t j = 0; j < F::contacts; ++j) allowed[j] = tolerance_ * depth_scale(field, j);
    std::fill(allowed + F::contacts, allowed + F::size, tolerance_);
    check(CVodeReInit(cvode.get(), 0, state.get()), "restart");
    check(CVodeSVtolerances(cvode.get(), tolerance_, allowed_.get()), "tolerances");
  }
  double* data() const { return N_VGetArrayPointer(state.get()); }
  /// Work since the last restart.
  void count(Answer& answer) const {
    long steps = 0, rhs = 0, dense = 0;
    check(CVodeGetNumSteps(cvode.get(), &steps), "count of steps");
    check(CVodeGetNumRhsEvals(cvode.get(), &rhs), "count of evaluations");
    if (linear_) check(CVodeGetNumLinRhsEvals(cvode.get(), &dense), "count of evaluations");
    answer.steps += steps;
    answer.rhs += rhs + dense;
  }

  Owned<_SUNContext> context;
  Owned<_generic_N_Vector> state;
  Owned<void> cvode;

 private:
  double tolerance_;
  Owned<_generic_N_Vector> allowed_;
  Owned<_generic_SUNNonlinearSolver> fixed_point_;
  Owned<_generic_SUNMatrix> matrix_;
  Owned<_generic_SUNLinearSolver> linear_;
};

/// No events: one call to a fixed time.
template <class F>
class WithoutEvents {
 public:
  WithoutEvents(int method, double tolerance) : memory_(tolerance) {
    memory_.create(method, derivative, this);
  }
  void solve(const Case& one, Answer& answer) {
    field_ = F(one.chain);
    memory_.start(one);
    double time = 0;
    check(CVode(memory_.cvode.get(), overtime * one.end, memory_.state.get(), &time, CV_NORMAL), "a step");
    memory_.count(answer);
    F::finish(memory_.data(), answer);
  }

 private:
  static int derivative(realtype, N_Vector x, N_Vector dx, void* self) {
    static_cast<WithoutEvents*>(self)->field_(NV_DATA_S(x), NV_DATA_S(dx));
    return 0;
  }
  Memory<F> memory_;
  F field_;
};

template <class F>
struct Adams : WithoutEvents<F> {
  explicit Adams(double tolerance) : WithoutEvents<F>(CV_ADAMS, tolerance) {}
};
template <class F>
struct Bdf : WithoutEvents<F> {
  explicit Bdf(double tolerance) : WithoutEvents<F>(CV_BDF, tolerance) {}
};

/// A root per gap and, with damping, one per load k δ + c δ̇; between roots each contact has its smooth force
/// or none. Balls start a hair apart, for a gap of zero that rounding pushes to and fro raises false roots.
template <class F>
class AdamsWithRoots {
 public:
  explicit AdamsWithRoots(double tolerance) : memory_(tolerance), hair_(1e-3 * tolerance) {
    memory_.create(CV_ADAMS, derivative, this);
    check(CVodeRootInit(memory_.cvode.get(), roots, guards), "roots");
    check(CVodeSetNoInactiveRootWarn(memory_.cvode.get()), "quiet roots");
  }
  void solve(const Case& one, Answer& answer) {
    field_ = F(one.chain);
    closed_.fill(false);
    apart_ = one;
    for (std::size_t j = 0; j < F::contacts; ++j) apart_.chain.gap[j] += hair_ * depth_scale(field_, j);
    memory_.start(apart_);
    const double end = overtime * one.end;
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
  static int derivative(realtype, N_Vector x, N_Vector dx, void* self) {
    const auto& rival = *static_cast<AdamsWithRoots*>(self);
    rival.field_.derivative(NV_DATA_S(x), NV_DATA_S(dx),
                            [&](std::size_t j, double force) { return rival.closed_[j] ? force : 0.0; });
    return 0;
  }
  static int guards(realtype, N_Vector x, realtype* values, void* self) {
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

  Memory<F> memory_;
  F field_;
  double hair_;  // relative to the depth scale
  Case apart_;
  std::array<bool, F::contacts> closed_{};
};

/// Undamped contacts are not stiff, and BDF never pays for them.
Solve bdf_if_damped(const Problem& problem, double tolerance) {
  const bool damped = contact::damping(problem.cases.front().chain.law[0]) > 0;
  return damped ? rival<Bdf>(problem, tolerance) : Solve();
}

}  // namespace

std::vector<Method> cvode_rivals() {
  return {{.name = "sundials-adams", .family = Family::sundials, .prepare = rival<Adams>},
          {.name = "sundials-adams-roots", .family = Family::sundials, .prepare = rival<AdamsWithRoots>},
          {.name = "sundials-bdf", .family = Family::sundials, .prepare = bdf_if_damped}};
}

}  // namespace mariotte::work_precision
