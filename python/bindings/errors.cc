// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/errors.h"

#include <pybind11/stl.h>

#include "python/bindings/bindings.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

/// Raises the package's own exception, which has the failure's words, code, stage and hints.
void Raise(const Failure& failure) {
  const py::module_ errors = py::module_::import("gaitwright.errors");
  const char* name = failure.kind == FailureKind::kInfeasible ? "InfeasibleError" : "BadInputError";
  const py::object type = errors.attr(name);
  const py::object error = type(failure.message, failure.code, failure.stage, failure.hints);
  PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

void BindErrors(py::module_&) {
  // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 takes a function of just this type
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const FailureError& error) {
      Raise(error.failure());
    } catch (const InvalidArgument& error) {
      Raise({FailureKind::kBadInput, "invalid_argument", "", error.what(), {}});
    }
  });
}

}  // namespace gaitwright::python
