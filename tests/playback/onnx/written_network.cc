// SPDX-License-Identifier: BSD-3-Clause
#include "tests/playback/onnx/written_network.h"

#include <fmt/format.h>

#include <bit>

namespace gaitwright::written {
namespace {

std::string VarintBytes(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(0x80 | (value & 0x7f));
  return bytes + static_cast<char>(value);
}

std::string TagBytes(int number, unsigned kind) {
  return VarintBytes((static_cast<std::uint64_t>(number) << 3) | kind);
}

std::string RawFloats(const std::vector<float>& numbers) {
  std::string raw;
  for (const float number : numbers) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    for (unsigned i = 0; i < 4; ++i) raw += static_cast<char>((bits >> (8 * i)) & 0xff);
  }
  return raw;
}

std::string PortBytes(const std::string& name, const std::vector<std::int64_t>& dims) {
  std::string shape;
  for (const std::int64_t size : dims) shape += BytesField(1, size < 0 ? BytesField(2, "batch") : WholeField(1, size));
  const std::string tensor = WholeField(1, 1) + BytesField(2, shape);
  return BytesField(1, name) + BytesField(2, BytesField(1, tensor));
}

}  // namespace

std::string WholeField(int number, std::int64_t value) {
  return TagBytes(number, 0) + VarintBytes(static_cast<std::uint64_t>(value));
}

std::string BytesField(int number, const std::string& bytes) {
  return TagBytes(number, 2) + VarintBytes(bytes.size()) + bytes;
}

std::string FloatField(int number, float value) { return TagBytes(number, 5) + RawFloats({value}); }

std::string FloatOf(const std::string& name, float value) { return BytesField(1, name) + FloatField(2, value); }

std::string WholeOf(const std::string& name, std::int64_t value) { return BytesField(1, name) + WholeField(3, value); }

std::string WholesOf(const std::string& name, const std::vector<std::int64_t>& values) {
  std::string text = BytesField(1, name);
  for (const std::int64_t value : values) text += WholeField(8, value);
  return text;
}

std::string TensorOf(const std::string& name, const std::string& tensor) {
  return BytesField(1, name) + BytesField(5, tensor);
}

std::string Floats(const std::string& name, const std::vector<std::int64_t>& dims, const std::vector<float>& numbers) {
  std::string text;
  for (const std::int64_t size : dims) text += WholeField(1, size);
  return text + WholeField(2, 1) + BytesField(8, name) + BytesField(9, RawFloats(numbers));
}

std::string Wholes(const std::string& name, const std::vector<std::int64_t>& numbers) {
  std::string packed;
  for (const std::int64_t number : numbers) packed += VarintBytes(static_cast<std::uint64_t>(number));
  return WholeField(1, static_cast<std::int64_t>(numbers.size())) + WholeField(2, 7) + BytesField(7, packed) +
         BytesField(8, name);
}

std::string Node(const std::string& op, const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                 const std::vector<std::string>& attributes) {
  std::string text;
  for (const std::string& input : inputs) text += BytesField(1, input);
  for (const std::string& output : outputs) text += BytesField(2, output);
  text += BytesField(3, "the_" + op) + BytesField(4, op);
  for (const std::string& attribute : attributes) text += BytesField(5, attribute);
  return text;
}

std::string File::Text() const {
  std::string graph;
  for (const std::string& node : nodes) graph += BytesField(1, node);
  graph += BytesField(2, "a graph");
  for (const std::string& constant : constants) graph += BytesField(5, constant);
  graph += BytesField(11, PortBytes("obs", {batch, inputs})) + BytesField(12, PortBytes("action", {}));
  std::string text = WholeField(1, 8) + BytesField(7, graph) + BytesField(8, BytesField(1, "") + WholeField(2, 17));
  for (const auto& [key, value] : notes) text += BytesField(14, BytesField(1, key) + BytesField(2, value));
  return text;
}

std::string DenseNetwork(const std::vector<Layer>& layers, const std::string& activation) {
  File file;
  file.inputs = static_cast<int>(layers.front().weights.cols());
  std::string last = "obs";
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const Layer& layer = layers[i];
    const std::string w = fmt::format("{}.weight", i), b = fmt::format("{}.bias", i);
    const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = layer.weights;
    file.constants.push_back(Floats(w, {rows.rows(), rows.cols()}, {rows.data(), rows.data() + rows.size()}));
    file.constants.push_back(
        Floats(b, {layer.bias.size()}, {layer.bias.data(), layer.bias.data() + layer.bias.size()}));
    const bool is_last = i + 1 == layers.size();
    const std::string out = is_last ? "action" : fmt::format("layer{}", i);
    file.nodes.push_back(Node("Gemm", {last, w, b}, {out}, {WholeOf("transB", 1)}));
    last = out;
    if (is_last) break;
    last = fmt::format("active{}", i);
    file.nodes.push_back(Node(activation, {out}, {last}));
  }
  return file.Text();
}

Network NetworkOf(const std::string& file) { return Network::Read(file, "written").value(); }

Eigen::VectorXf Evaluated(const Network& network, const Eigen::VectorXf& input) {
  NetworkScratch scratch = network.MakeScratch();
  Eigen::VectorXf output(network.output_size());
  network.Evaluate(input, scratch, output);
  return output;
}

}  // namespace gaitwright::written
