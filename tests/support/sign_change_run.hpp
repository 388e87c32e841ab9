// What a user of CVODE writes for a chain in an afternoon: the cut-off forces in one right-hand side, the
// gaps and loads as root functions, a restart at every root. Roots are found by the change of a sign over a
// step.
#pragma once
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "support/series_motion.hpp"

namespace mariotte::test {

/// State: n velocities, n−1 gaps. Root functions: n−1 gaps, n−1 loads k δ + c δ̇ (1 for undamped contacts).
class SignChangeRun {
 public:
  explicit SignChangeRun(const model::Chain& chain)
      : chain_(chain), balls_(chain.mass.size()), touching_(balls_ - 1), loaded_(balls_ - 1) {
    for (std::size_t j = 0; j + 1 < balls_; ++j) {
      spring_.push_back(make_spring(chain, j));
      touching_[j] = chain.gap[j] == 0 && chain.velocity[j] > chain.velocity[j + 1];
      loaded_[j] = touching_[j] || spring_[j].damping == 0;
      periods_.push_back(touching_[j]);
    }
  }

  /// Stretches of carrying force per contact until `end`; empty if CVODE gives up.
  std::vector<std::size_t> periods(double accuracy, double end) {
    const sundials::Context context;
    const auto size = static_cast<sunindextype>(2 * balls_ - 1);
    N_Vector x = N_VNew_Serial(size, context), tolerance = N_VClone(x);
    double *at = N_VGetArrayPointer(x), *absolute = N_VGetArrayPointer(tolerance);
    for (std::size_t i = 0; i < balls_; ++i) {
      at[i] = chain_.velocity[i];
      absolute[i] = 0.01 * accuracy;
      if (i + 1 == balls_) break;
      at[balls_ + i] = chain_.gap[i];
      absolute[balls_ + i] = 0.01 * accuracy * spring_[i].length;
    }
    void* cvode = CVodeCreate(CV_ADAMS, context);
    CVodeInit(cvode, derivative, 0, x);
    CVodeSetUserData(cvode, this);
    CVodeSVtolerances(cvode, 0.01 * accuracy, tolerance);
    CVodeSetMaxNumSteps(cvode, 1'000'000);
#if SUNDIALS_VERSION_MAJOR < 7
    CVodeSetErrFile(cvode, nullptr);
#else
    SUNContext_ClearErrHandlers(context);
#endif
    CVodeSetNoInactiveRootWarn(cvode);
    SUNNonlinearSolver iteration = SUNNonlinSol_FixedPoint(x, 0, context);
    CVodeSetNonlinearSolver(cvode, iteration);
    CVodeRootInit(cvode, static_cast<int>(2 * spring_.size()), roots);
    const bool done = follow(cvode, x, end);
    CVodeFree(&cvode);
    SUNNonlinSolFree(iteration);
    N_VDestroy(tolerance);
    N_VDestroy(x);
    return done ? periods_ : std::vector<std::size_t>{};
  }

 private:
  bool follow(void* cvode, N_Vector x, double end) {
    std::vector<int> found(2 * spring_.size());
    for (double time = 0; time < end;) {
      const int code = CVode(cvode, end, x, &time, CV_NORMAL);
      if (code < 0) return false;
      if (code != CV_ROOT_RETURN) continue;
      CVodeGetRootInfo(cvode, found.data());
      for (std::size_t j = 0; j < spring_.size(); ++j) {
        const bool before = touching_[j] && loaded_[j];
        if (found[j] != 0) touching_[j] = found[j] < 0;
        if (found[spring_.size() + j] != 0) loaded_[j] = found[spring_.size() + j] > 0;
        periods_[j] += touching_[j] && loaded_[j] && !before;
      }
      CVodeReInit(cvode, time, x);
    }
    return true;
  }

  double load(const double* x, std::size_t j) const {
    return spring_[j].damping == 0
               ? 1
               : spring_[j].damping * (x[j] - x[j + 1]) - spring_[j].stiffness * x[balls_ + j];
  }
  double force(const double* x, std::size_t j) const {
    const double depth = -x[balls_ + j], width = spring_[j].root ? std::sqrt(std::max(0.0, depth)) : 1;
    const double load = spring_[j].stiffness * depth + spring_[j].damping * (x[j] - x[j + 1]);
    return depth > 0 && load > 0 ? width * load : 0;
  }

  static int derivative(sunrealtype, N_Vector state, N_Vector slope, void* self) {
    const auto& run = *static_cast<SignChangeRun*>(self);
    const double* x = N_VGetArrayPointer(state);
    double *dx = N_VGetArrayPointer(slope), push = 0;
    for (std::size_t i = 0; i < run.balls_; ++i) {
      const bool last = i == run.spring_.size(), wall = std::isinf(run.chain_.mass[i]);
      const double force = last ? 0 : run.force(x, i);
      dx[i] = wall ? 0 : (push - force) / run.chain_.mass[i] - run.chain_.gravity;
      if (!last) dx[run.balls_ + i] = x[i + 1] - x[i];
      push = force;
    }
    return 0;
  }
  static int roots(sunrealtype, N_Vector state, sunrealtype* values, void* self) {
    const auto& run = *static_cast<SignChangeRun*>(self);
    const double* x = N_VGetArrayPointer(state);
    for (std::size_t j = 0; j < run.spring_.size(); ++j) {
      values[j] = x[run.balls_ + j];
      values[run.spring_.size() + j] = run.load(x, j);
    }
    return 0;
  }

  const model::Chain& chain_;
  std::size_t balls_;
  std::vector<Spring> spring_;
  std::vector<bool> touching_, loaded_;
  std::vector<std::size_t> periods_;
};

}  // namespace mariotte::test
