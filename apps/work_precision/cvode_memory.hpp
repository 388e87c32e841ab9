// CVODE as the rivals use it: memory is taken once and used for every impact.
#pragma once
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <memory>
#include <string>

#include "mariotte/core/error.hpp"
#include "rival.hpp"

namespace mariotte::work_precision {

inline constexpr long most_cvode_steps = 10'000'000;

inline void check(int code, const char* what) {
  if (code < 0) throw Error(std::string("CVODE: ") + what + " failed with code " + std::to_string(code));
}

struct Free {
  void operator()(_generic_N_Vector* v) const { N_VDestroy(v); }
  void operator()(_generic_SUNMatrix* m) const { SUNMatDestroy(m); }
  void operator()(_generic_SUNLinearSolver* s) const { SUNLinSolFree(s); }
  void operator()(_generic_SUNNonlinearSolver* s) const { SUNNonlinSolFree(s); }
  void operator()(void* memory) const { CVodeFree(&memory); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

/// What all methods share: memory and tolerances.
template <class F>
class CvodeMemory {
 public:
  explicit CvodeMemory(double tolerance) : tolerance_(tolerance) {
    state.reset(N_VNew_Serial(F::size, context));
    allowed_.reset(N_VNew_Serial(F::size, context));
    N_VConst(0, state.get());
  }
  void create(int method, CVRhsFn derivative, void* self) {
    cvode.reset(CVodeCreate(method, context));
    check(keep_quiet(), "error handler");
    check(CVodeInit(cvode.get(), derivative, 0, state.get()), "start");
    check(CVodeSetUserData(cvode.get(), self), "user data");
    check(CVodeSetMaxNumSteps(cvode.get(), most_cvode_steps), "step limit");
    check(CVodeSetMaxStep(cvode.get(), measuring::longest_step), "longest step");
    if (method == CV_ADAMS) {
      fixed_point_.reset(SUNNonlinSol_FixedPoint(state.get(), 0, context));
      check(CVodeSetNonlinearSolver(cvode.get(), fixed_point_.get()), "fixed-point iteration");
    } else {
      matrix_.reset(SUNDenseMatrix(F::size, F::size, context));
      linear_.reset(SUNLinSol_Dense(state.get(), matrix_.get(), context));
      check(CVodeSetLinearSolver(cvode.get(), linear_.get(), matrix_.get()), "linear solver");
    }
  }
  void start(const F& field, const Case& one) {
    field.start(one, data());
    double* allowed = N_VGetArrayPointer(allowed_.get());
    const auto magnitudes = field.magnitudes();
    for (std::size_t i = 0; i < F::size; ++i) allowed[i] = tolerance_ * magnitudes[i];
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

  sundials::Context context;
  Owned<_generic_N_Vector> state;
  Owned<void> cvode;

 private:
  int keep_quiet() {
#if SUNDIALS_VERSION_MAJOR < 7
    return CVodeSetErrHandlerFn(
        cvode.get(), [](int, const char*, const char*, char*, void*) {}, nullptr);
#else
    return SUNContext_ClearErrHandlers(context);
#endif
  }

  double tolerance_;
  Owned<_generic_N_Vector> allowed_;
  Owned<_generic_SUNNonlinearSolver> fixed_point_;
  Owned<_generic_SUNMatrix> matrix_;
  Owned<_generic_SUNLinearSolver> linear_;
};

}  // namespace mariotte::work_precision
