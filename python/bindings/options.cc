// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/options.h"

#include <fmt/format.h>

namespace gaitwright::python {
namespace {

namespace py = pybind11;

std::string TextOf(const std::string& key, const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::hasattr(value, "dtype") && py::str(value.attr("dtype")).cast<std::string>() == "bool")
    return py::bool_(py::reinterpret_borrow<py::object>(value)).cast<bool>() ? "true" : "false";
  if (PyNumber_Check(value.ptr()) != 0)
    return fmt::format("{}", py::float_(py::reinterpret_borrow<py::object>(value)).cast<double>());
  throw InvalidArgument(fmt::format("option '{}' is {}; accepted: a number, a truth value or a text", key,
                                    py::repr(value).cast<std::string>()));
}

}  // namespace

OptionTexts TextsFrom(const py::dict& options) {
  OptionTexts texts;
  for (const auto& [key, value] : options) {
    const std::string name = py::str(key).cast<std::string>();
    texts.emplace_back(name, TextOf(name, value));
  }
  return texts;
}

void SetOptions(OptionFields fields, const py::dict& options) {
  for (const auto& [key, text] : TextsFrom(options)) SetOption(fields, key, text);
}

PlayRequest PlayRequestOf(const py::dict& options) {
  PlayRequest request;
  const py::dict others = options.attr("copy")();
  if (options.contains("sensors")) {
    request.sensing.sensors = SensorsOfKind(TextOf("sensors", options["sensors"]));
    others.attr("pop")("sensors");
  }
  SetOptions(request.Fields(), others);
  return request;
}

}  // namespace gaitwright::python
