// Exceptions of C++ as those of mariotte/_errors.py.
#include "errors.hpp"

#include "bindings.hpp"
#include "mariotte/core/quantity.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/study/fit/fit.hpp"
#include "mariotte/study/sweep/columns.hpp"

namespace mariotte::python {
namespace {

namespace py = pybind11;

template <class... More>
py::object make(const char* type, const Error& error, const More&... more) {
  const auto classes = py::module_::import("mariotte._errors");
  return classes.attr(type)(error.what(), std::string(error.fault.code), more...);
}

py::object make(const scene::SceneError& error) {
  auto made = make("SceneError", error, error.key, error.place);
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
  raise(make("file_error", error, error.number, error.path));
} catch (const report::FileError& error) {
  raise(make("file_error", error, error.number, error.path));
} catch (const study::FitError& error) {
  raise(make("FitError", error));
} catch (const WrongOption& error) {
  raise(make("InvalidParameter", error, error.key, error.place));
} catch (const InvalidParameter& error) {
  raise(make("InvalidParameter", error));
} catch (const study::ColumnError& error) {
  raise(make("InvalidParameter", error, "columns"));
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
