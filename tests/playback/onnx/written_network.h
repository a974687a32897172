// SPDX-License-Identifier: BSD-3-Clause
// Writes ONNX files for tests, by the wire format of protobuf.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "playback/onnx/network_internal.h"

namespace gaitwright::written {

/// A field of a message: a number, or bytes.
std::string WholeField(int number, std::int64_t value);
std::string BytesField(int number, const std::string& bytes);
std::string FloatField(int number, float value);

/// Attributes of a node.
std::string FloatOf(const std::string& name, float value);
std::string WholeOf(const std::string& name, std::int64_t value);
std::string WholesOf(const std::string& name, const std::vector<std::int64_t>& values);
std::string TensorOf(const std::string& name, const std::string& tensor);

/// Constants.
std::string Floats(const std::string& name, const std::vector<std::int64_t>& dims, const std::vector<float>& numbers);
std::string Wholes(const std::string& name, const std::vector<std::int64_t>& numbers);

std::string Node(const std::string& op, const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                 const std::vector<std::string>& attributes = {});

/// A file with input "obs" of size 1 x `inputs` and output "action".
struct File {
  int inputs = 1;
  std::vector<std::string> nodes, constants;
  std::vector<std::pair<std::string, std::string>> notes = {};
  std::int64_t batch = 1;  ///< -1: symbolic

  std::string Text() const;
};

/// A network of dense layers with an activation between them, as PyTorch exports them (Gemm with transB).
struct Layer {
  Eigen::MatrixXf weights;  ///< outputs x inputs
  Eigen::VectorXf bias;
};
std::string DenseNetwork(const std::vector<Layer>& layers, const std::string& activation);

/// The network of a file. @throws std::logic_error with the message of a refusal.
Network NetworkOf(const std::string& file);

/// The output for an input.
Eigen::VectorXf Evaluated(const Network& network, const Eigen::VectorXf& input);

}  // namespace gaitwright::written
