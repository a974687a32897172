// SPDX-License-Identifier: BSD-3-Clause
// What grade prints.
#include "workflows/formats/result_shapes_internal.h"

namespace gaitwright {

using namespace shapes;

namespace {

DataShape PartMarkShape() {
  const DataShape check =
      Object({{"measure", Text()}, {"value", OrNull(Number())}, {"points", Number()}, {"of", Number()}});
  return Object({{"part", Text()},
                 {"points", Number()},
                 {"of", Number()},
                 {"checks", List(check)},
                 {"reasons", TextsShape(), "What was lost, and why."}});
}

}  // namespace

DataShape GradeResultShape() {
  const DataShape student = Object({{"student", Text()},
                                    {"points", Number()},
                                    {"of", Number()},
                                    {"page", Text(), "The name of the student's page."},
                                    {"parts", List(PartMarkShape())}});
  const DataShape marks = Object({{"title", Text()},
                                  {"seed", Whole()},
                                  {"confined", Truth(), "Whether code was kept from all that is not its own."},
                                  {"of", Number()},
                                  {"students", List(student)},
                                  {"files", FilesShape({"grades", "index"})}});
  return Either(marks, Object({{"files", MapOf(Text()), "Inputs to hand out, with --write-inputs."}}));
}

}  // namespace gaitwright
