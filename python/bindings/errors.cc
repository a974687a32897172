// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/errors.h"

#include <pybind11/stl.h>

#include "python/bindings/bindings.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

py::list HintsOf(const Failure& failure) {
  py::list hints;
  for (const Suggestion& suggestion : failure.suggestions) hints.append(suggestion.text);
  return hints;
}

py::list SuggestionsOf(const Failure& failure) {
  py::list suggestions;
  for (const Suggestion& suggestion : failure.suggestions) {
    if (suggestion.what.empty()) continue;
    py::dict one;
    one["what"] = suggestion.what;
    one["value"] = py::cast(suggestion.value);
    one["certainty"] = CertaintyName(suggestion.certainty);
    suggestions.append(one);
  }
  return suggestions;
}

py::object ViolationOf(const Failure& failure) {
  if (!failure.violation) return py::none();
  const Violation& v = *failure.violation;
  py::dict violation;
  violation["law"] = LawName(v.law);
  violation["at_s"] = v.at_s;
  violation["where"] = v.where;
  violation["value"] = v.value;
  violation["limit"] = v.limit;
  violation["unit"] = v.unit;
  return violation;
}

/// Raises the package's exception with all data of the failure.
void Raise(const Failure& failure) {
  const py::module_ errors = py::module_::import("gaitwright.errors");
  const char* name = failure.kind == FailureKind::kInfeasible ? "InfeasibleError" : "BadInputError";
  const py::object type = errors.attr(name);
  const py::object error = type(failure.message, FailureCodeName(failure.code), failure.stage, HintsOf(failure),
                                SuggestionsOf(failure), ViolationOf(failure));
  PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

void BindErrors(py::module_&) {
  // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 requires exactly this type of function
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const FailureError& error) {
      Raise(error.failure());
    } catch (const InvalidArgument& error) {
      Raise({FailureKind::kBadInput, FailureCode::kInvalidArgument, "", error.what(), {}});
    }
  });
}

}  // namespace gaitwright::python
