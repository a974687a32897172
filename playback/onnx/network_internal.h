// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "playback/onnx/kernels_internal.h"

namespace gaitwright {

/// Memory of one evaluation; owned by the caller, so that threads can share a network.
struct NetworkScratch {
  std::vector<float> memory;
};

/// A feed-forward network from an ONNX file, with one input and one output of floats, evaluated for one observation at
/// a time. Immutable.
///
/// All sizes are known when the file is read; a symbolic size, such as that of a batch, is 1. Operations on constants
/// are evaluated then. An evaluation runs the others in order and allocates nothing.
///
/// Operators (docs/policies.md): Gemm, MatMul; Add, Sub, Mul, Div, Max, Min, Pow; Elu, Relu, LeakyRelu, Selu, Celu,
/// Softplus, Softsign, Tanh, Sigmoid, Clip, Erf, Exp, Log, Sqrt, Abs, Neg, Reciprocal, Floor, Sin, Cos; Concat, Split,
/// Slice, Gather, Transpose, Expand; Reshape, Flatten, Squeeze, Unsqueeze, Identity, Dropout, Cast, Constant, Shape.
class Network {
 public:
  /// @return a failure that names the node for an operator, attribute or size that is not supported; a failure for a
  /// file that is damaged or beyond the limits: those of ReadGraph, 16,000,000 floats in all, and 1e9 operations of an
  /// evaluation.
  /// @param source  name of the file in messages.
  static Result<Network> Read(const std::string& file, const std::string& source);

  int input_size() const { return static_cast<int>(input_.second); }
  int output_size() const { return static_cast<int>(output_.second); }
  /// Number of constants that the evaluation uses.
  std::int64_t parameters() const { return parameters_; }
  /// The operators of the file with their counts, such as "Elu x 3, Gemm x 4".
  const std::string& operators() const { return operators_; }
  /// Texts that the exporter added to the file, such as the names of joints, by key.
  const std::map<std::string, std::string>& notes() const { return notes_; }

  NetworkScratch MakeScratch() const { return {image_}; }

  /// @pre `input` and `output` have the network's sizes, `scratch` is from MakeScratch.
  void Evaluate(const Eigen::VectorXf& input, NetworkScratch& scratch, Eigen::VectorXf& output) const;

 private:
  using Place = std::pair<std::int64_t, std::int64_t>;  // first element and count

  Network() = default;

  std::vector<float> image_;  ///< the memory before an evaluation: constants, and zeros
  std::vector<std::shared_ptr<const onnx::Kernel>> kernels_;
  Place input_, output_;
  std::int64_t parameters_ = 0;
  std::string operators_;
  std::map<std::string, std::string> notes_;
};

}  // namespace gaitwright
