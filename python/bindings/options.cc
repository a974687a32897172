// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/options.h"

#include <fmt/format.h>

namespace gaitwright::python {
namespace {

namespace py = pybind11;

std::string TextOf(const std::string& key, const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (PyNumber_Check(value.ptr()) != 0)
    return fmt::format("{}", py::float_(py::reinterpret_borrow<py::object>(value)).cast<double>());
  throw InvalidArgument(fmt::format("the option '{}' is {}; a number, a truth or a text is accepted", key,
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

}  // namespace gaitwright::python
