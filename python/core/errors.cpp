// Exceptions of C++ as those of mariotte/_errors.py.
#include "bindings.hpp"
#include "mariotte/core/quantity.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/study/fit/fit.hpp"
#include "mariotte/study/sweep/columns.hpp"

namespace mariotte::python {
namespace {

namespace py = pybind11;

py::object make(const char* type, const Error& error) {
  const auto classes = py::module_::import("mariotte._errors");
  return classes.attr(type)(error.what(), std::string(error.fault.code));
}

py::object make(const scene::SceneError& error) {
  auto made = make("SceneError", error);
  made.attr("place") = error.place;
  made.attr("key") = error.key;
  py::list more;
  for (const auto& one : error.more) more.append(make(one));
  made.attr("more") = more;
  return made;
}

void raise(const py::object& error) {
  PyErr_SetObject(py::type::handle_of(error).ptr(), error.ptr());
}

void translate(std::exception_ptr thrown) try {
  std::rethrow_exception(thrown);
} catch (const scene::SceneError& error) {
  raise(make(error));
} catch (const scene::FileError& error) {
  raise(make("FileError", error));
} catch (const report::FileError& error) {
  raise(make("FileError", error));
} catch (const study::FitError& error) {
  raise(make("FitError", error));
} catch (const InvalidParameter& error) {
  raise(make("InvalidParameter", error));
} catch (const study::ColumnError& error) {
  raise(make("InvalidParameter", error));
} catch (const QuantityError& error) {
  raise(make("InvalidParameter", error));
} catch (const Error& error) {
  raise(make("Error", error));
}

}  // namespace

void add_errors(py::module_&) {
  py::register_exception_translator(&translate);
}

}  // namespace mariotte::python
