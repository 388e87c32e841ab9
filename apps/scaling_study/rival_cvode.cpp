// CVODE by Adams with fixed-point iteration, as a user writes it.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <sundials/sundials_context.hpp>

#include "mariotte/core/error.hpp"
#include "measuring/timing.hpp"
#include "method.hpp"
#include "whole_row.hpp"

namespace mariotte::scaling_study {
namespace {

/// CVODE bounds a root mean square, which a few moving balls among n dilute: the tolerance makes up for it.
double tolerance(std::size_t balls) {
  return 1e-9 / std::sqrt(static_cast<double>(balls) / 10);
}

int derivative(sunrealtype, N_Vector x, N_Vector dx, void* row) {
  (*static_cast<const WholeRow*>(row))(NV_DATA_S(x), NV_DATA_S(dx));
  return 0;
}

}  // namespace

Measurement measure_cvode(std::size_t balls) {
  WholeRow row{balls};
  const sundials::Context context;
  const auto x = N_VNew_Serial(static_cast<sunindextype>(row.size()), context);
  row.start(NV_DATA_S(x));
  void* cvode = CVodeCreate(CV_ADAMS, context);
  const auto iteration = SUNNonlinSol_FixedPoint(x, 0, context);
  const double allowed = tolerance(balls), start = measuring::cpu_seconds();
  double time = 0;
  long steps = 0;
  bool fine = CVodeInit(cvode, derivative, 0, x) == CV_SUCCESS;
  fine = fine && CVodeSetUserData(cvode, &row) == CV_SUCCESS;
  fine = fine && CVodeSetMaxNumSteps(cvode, 1'000'000'000) == CV_SUCCESS;
  fine = fine && CVodeSetMaxStep(cvode, measuring::longest_step) == CV_SUCCESS;
  fine = fine && CVodeSetNonlinearSolver(cvode, iteration) == CV_SUCCESS;
  fine = fine && CVodeSStolerances(cvode, allowed, allowed) == CV_SUCCESS;
  fine = fine && CVode(cvode, row.end(), x, &time, CV_NORMAL) == CV_SUCCESS;
  const double seconds = measuring::cpu_seconds() - start;
  fine = fine && CVodeGetNumSteps(cvode, &steps) == CV_SUCCESS;
  if (!fine) throw Error("CVODE has failed");  // in a process of its own: the system frees its memory
  return {.seconds = seconds,
          .error = error_of(row.velocity(NV_DATA_S(x))),
          .steps = steps,
          .widest = static_cast<Index>(row.contacts())};
}

}  // namespace mariotte::scaling_study
