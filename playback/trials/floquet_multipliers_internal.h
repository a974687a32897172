// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Deviations from a periodic motion at the same moment of successive cycles; vectors of one size.
using CycleDeviations = std::vector<VectorX>;

/// Floquet multipliers of a periodic motion: the eigenvalues of the linear map from the deviation in one cycle to that
/// in the next, e_(k+1) = A e_k. The motion is stable if all magnitudes are below 1.
struct FloquetMultipliers {
  std::vector<std::complex<double>> values = {};  ///< the largest magnitude first; empty without deviations
  /// Root mean square error of the map for deviations that were left out of its estimate, as a share of these
  /// deviations one cycle later.
  double unexplained = 0.0;

  /// Largest magnitude. @pre there are values
  double largest() const { return std::abs(values.front()); }
};

/// Estimates the multipliers from measured deviations by least squares in the subspace of the deviations (dynamic mode
/// decomposition). Deviations that have shrunk to a tenth of the first are not used, and directions with less than a
/// twentieth of the largest singular value are left out.
///
/// Hurmuzlu and Basdogan, J. Biomech. Eng. 116(1) 1994, doi:10.1115/1.2895701, for multipliers of measured gaits;
/// Schmid, J. Fluid Mech. 656 2010, doi:10.1017/S0022112010001217, for the decomposition.
/// @param sequences  each of at least two deviations, of different disturbances. @throws InvalidArgument for vectors of
/// different sizes.
FloquetMultipliers EstimateMultipliers(const std::vector<CycleDeviations>& sequences);

}  // namespace gaitwright
