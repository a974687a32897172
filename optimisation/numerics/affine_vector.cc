// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/affine_vector.h"

#include <algorithm>

namespace gaitwright {

Vector3 AffineVector::At(const VectorX& x) const {
  Vector3 value = constant;
  for (const Part& part : parts) value += part.coefficient * x.segment<3>(part.start);
  return value;
}

AffineVector& AffineVector::Add(double factor, const AffineVector& other) {
  constant += factor * other.constant;
  for (const Part& part : other.parts) {
    const auto at = std::lower_bound(parts.begin(), parts.end(), part.start,
                                     [](const Part& p, int start) { return p.start < start; });
    if (at != parts.end() && at->start == part.start) {
      at->coefficient += factor * part.coefficient;
    } else {
      parts.insert(at, {part.start, factor * part.coefficient});
    }
  }
  return *this;
}

int SeenUnknowns::See(int first, int count) {
  const auto at = std::find(variables_.begin(), variables_.end(), first);
  if (at != variables_.end()) return static_cast<int>(at - variables_.begin());
  const int local = static_cast<int>(variables_.size());
  for (int i = 0; i < count; ++i) variables_.push_back(first + i);
  return local;
}

AffineVector SeenUnknowns::See(const AffineVector& vector) {
  AffineVector own{vector.constant};
  for (const AffineVector::Part& part : vector.parts) own.parts.push_back({See(part.start, 3), part.coefficient});
  std::sort(own.parts.begin(), own.parts.end(),
            [](const AffineVector::Part& a, const AffineVector::Part& b) { return a.start < b.start; });
  return own;
}

VectorFunction AffineRows(const AffineVector& vector, const MatrixX& directions, const VectorX& offsets,
                          SeenUnknowns& seen) {
  return [own = seen.See(vector), directions, offsets](const VectorX& x, VectorX& value, MatrixX* J) {
    value = directions * own.At(x) - offsets;
    if (J != nullptr) own.AddTo(directions, *J, 0);
  };
}

}  // namespace gaitwright
