// Ownership of SUNDIALS objects. Private to flow/cvode and flow/linear_solver.
#pragma once
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <memory>

namespace mariotte::flow::sundials {

struct Free {
  void operator()(_generic_N_Vector* v) const { N_VDestroy(v); }
  void operator()(_generic_SUNMatrix* m) const { SUNMatDestroy(m); }
  void operator()(_generic_SUNLinearSolver* s) const { SUNLinSolFree(s); }
  void operator()(_generic_SUNNonlinearSolver* s) const { SUNNonlinSolFree(s); }
  void operator()(_SUNContext* c) const { SUNContext_Free(&c); }
  void operator()(void* memory) const { CVodeFree(&memory); }
};

using Vector = std::unique_ptr<_generic_N_Vector, Free>;
using Matrix = std::unique_ptr<_generic_SUNMatrix, Free>;
using LinearSolver = std::unique_ptr<_generic_SUNLinearSolver, Free>;
using NonlinearSolver = std::unique_ptr<_generic_SUNNonlinearSolver, Free>;
using Context = std::unique_ptr<_SUNContext, Free>;
using Cvode = std::unique_ptr<void, Free>;

}  // namespace mariotte::flow::sundials
