// SPDX-License-Identifier: BSD-3-Clause
// Output of grade.
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
                 {"reasons", TextsShape(), "Lost points and the reasons."}});
}

}  // namespace

DataShape GradeResultShape() {
  const DataShape student = Object({{"student", Text()},
                                    {"points", Number()},
                                    {"of", Number()},
                                    {"page", Text(), "File name of the student's page."},
                                    {"parts", List(PartMarkShape())}});
  const DataShape marks = Object({{"title", Text()},
                                  {"seed", Whole()},
                                  {"confined", Truth(), "True if code ran confined."},
                                  {"of", Number()},
                                  {"students", List(student)},
                                  {"files", FilesShape({"grades", "index"})}});
  return Either(marks, Object({{"files", MapOf(Text()), "Inputs to hand out to students, with --write-inputs."}}));
}

}  // namespace gaitwright
