// Ownership of SUNDIALS objects, and what differs between its versions 6 and 7. Private to flow/cvode.
#pragma once
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <memory>
#include <string>
#include <sundials/sundials_context.hpp>

namespace mariotte::flow::sundials {

struct Free {
  void operator()(_generic_N_Vector* v) const { N_VDestroy(v); }
  void operator()(_generic_SUNMatrix* m) const { SUNMatDestroy(m); }
  void operator()(_generic_SUNLinearSolver* s) const { SUNLinSolFree(s); }
  void operator()(_generic_SUNNonlinearSolver* s) const { SUNNonlinSolFree(s); }
  void operator()(void* memory) const { CVodeFree(&memory); }
};

using Vector = std::unique_ptr<_generic_N_Vector, Free>;
using Matrix = std::unique_ptr<_generic_SUNMatrix, Free>;
using LinearSolver = std::unique_ptr<_generic_SUNLinearSolver, Free>;
using NonlinearSolver = std::unique_ptr<_generic_SUNNonlinearSolver, Free>;
using Context = ::sundials::Context;
using Cvode = std::unique_ptr<void, Free>;

/// Messages of `cvode` go to `text`, the last one stays there, and none is printed. Returns SUNDIALS' code.
#if SUNDIALS_VERSION_MAJOR < 7
inline int send_messages(SUNContext, void* cvode, std::string& text) {
  const auto keep = [](int, const char*, const char*, char* message, void* to) {
    *static_cast<std::string*>(to) = message;
  };
  return CVodeSetErrHandlerFn(cvode, keep, &text);
}
#else
inline int send_messages(SUNContext context, void*, std::string& text) {
  const auto keep = [](int, const char*, const char*, const char* message, SUNErrCode, void* to, SUNContext) {
    *static_cast<std::string*>(to) = message;
  };
  SUNContext_ClearErrHandlers(context);
  return SUNContext_PushErrHandler(context, keep, &text);
}
#endif

}  // namespace mariotte::flow::sundials
