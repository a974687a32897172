// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "playback/onnx/network_internal.h"
#include "playback/trials/distribution.h"
#include "tests/playback/onnx/written_network.h"

namespace gaitwright {
namespace {

using written::Layer;

Eigen::MatrixXf RandomMatrix(NamedRandom& random, int rows, int columns) {
  Eigen::MatrixXf m(rows, columns);
  for (float& x : m.reshaped()) x = static_cast<float>(random.Uniform() - 0.5);
  return m;
}

std::vector<Layer> RandomLayers(NamedRandom& random, const std::vector<int>& sizes) {
  std::vector<Layer> layers;
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i)
    layers.push_back({RandomMatrix(random, sizes[i + 1], sizes[i]), RandomMatrix(random, sizes[i + 1], 1)});
  return layers;
}

/// The network in double precision, by its definition.
Eigen::VectorXd DenseByDefinition(const std::vector<Layer>& layers, const Eigen::VectorXf& input,
                                  double (*activation)(double)) {
  Eigen::VectorXd x = input.cast<double>();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    x = layers[i].weights.cast<double>() * x + layers[i].bias.cast<double>();
    if (i + 1 < layers.size()) x = x.unaryExpr(activation);
  }
  return x;
}

double EluOf(double x) { return x > 0.0 ? x : std::expm1(x); }
double ReluOf(double x) { return std::max(x, 0.0); }
double TanhOf(double x) { return std::tanh(x); }

TEST(NetworkTest, DenseNetworksEqualTheirDefinition) {
  NamedRandom random(1, "networks");
  const std::pair<const char*, double (*)(double)> activations[] = {{"Elu", EluOf}, {"Relu", ReluOf}, {"Tanh", TanhOf}};
  for (const auto& [name, function] : activations) {
    const std::vector<Layer> layers = RandomLayers(random, {45, 128, 64, 12});
    const Network network = written::NetworkOf(written::DenseNetwork(layers, name));
    ASSERT_EQ(network.input_size(), 45);
    ASSERT_EQ(network.output_size(), 12);
    const Eigen::VectorXf input = 4.0F * RandomMatrix(random, 45, 1);
    const Eigen::VectorXd expected = DenseByDefinition(layers, input, function);
    ASSERT_GT(expected.norm(), 0.1) << name;
    EXPECT_LT((written::Evaluated(network, input).cast<double>() - expected).norm(), 1e-4) << name;
  }
}

TEST(NetworkTest, TellsItsOperatorsParametersAndNotes) {
  NamedRandom random(2, "networks");
  const std::vector<Layer> layers = RandomLayers(random, {3, 4, 2});
  const Network network = written::NetworkOf(written::DenseNetwork(layers, "Elu"));
  EXPECT_EQ(network.operators(), "Elu x 1, Gemm x 2");
  EXPECT_EQ(network.parameters(), 3 * 4 + 4 + 4 * 2 + 2);
  written::File file;
  file.nodes = {written::Node("Identity", {"obs"}, {"action"})};
  file.notes = {{"joint_names", "a,b"}};
  EXPECT_EQ(written::NetworkOf(file.Text()).notes().at("joint_names"), "a,b");
}

TEST(NetworkTest, EvaluatesTheSameTwiceWithOneScratch) {
  NamedRandom random(3, "networks");
  const Network network = written::NetworkOf(written::DenseNetwork(RandomLayers(random, {5, 6, 2}), "Elu"));
  NetworkScratch scratch = network.MakeScratch();
  const Eigen::VectorXf a = RandomMatrix(random, 5, 1), b = RandomMatrix(random, 5, 1);
  Eigen::VectorXf first(2), other(2), again(2);
  network.Evaluate(a, scratch, first);
  network.Evaluate(b, scratch, other);
  network.Evaluate(a, scratch, again);
  EXPECT_EQ(first, again);
  EXPECT_NE(first, other);
}

TEST(NetworkTest, ReadsASymbolicBatchAsOne) {
  written::File file;
  file.inputs = 3;
  file.batch = -1;
  file.nodes = {written::Node("Relu", {"obs"}, {"action"})};
  EXPECT_EQ(written::Evaluated(written::NetworkOf(file.Text()), Eigen::Vector3f(-1.0F, 0.5F, 2.0F)),
            Eigen::Vector3f(0.0F, 0.5F, 2.0F));
}

std::string MessageFor(const std::string& file) {
  const Result<Network> network = Network::Read(file, "n.onnx");
  return network ? "" : network.failure().message;
}

TEST(NetworkTest, NamesTheNodeThatIsNotSupported) {
  written::File file;
  file.nodes = {written::Node("Gem", {"obs"}, {"action"})};
  EXPECT_EQ(MessageFor(file.Text()),
            "network 'n.onnx': node 'the_Gem' (Gem): operator 'Gem' is not supported; the nearest is 'Gemm'");
  file.nodes = {written::Node("Relu", {"obs"}, {"action"}, {written::FloatOf("odd", 1.0F)})};
  EXPECT_EQ(MessageFor(file.Text()), "network 'n.onnx': node 'the_Relu' (Relu): attribute 'odd' is not supported");
}

TEST(NetworkTest, RefusesFilesThatAreNoNetworks) {
  EXPECT_EQ(MessageFor(""), "network 'n.onnx': it contains no graph, so it is not an ONNX file");
  EXPECT_NE(MessageFor("not a network"), "");
  written::File file;
  file.nodes = {written::Node("Relu", {"obs"}, {"other"})};
  EXPECT_EQ(MessageFor(file.Text()), "network 'n.onnx': no node gives the network's output 'action'");
  const std::string text = file.Text();
  EXPECT_NE(MessageFor(text.substr(0, text.size() / 2)), "");
}

TEST(NetworkTest, RefusesABatchOfSeveralObservations) {
  written::File file;
  file.inputs = 3;
  file.batch = 2;
  file.nodes = {written::Node("Relu", {"obs"}, {"action"})};
  EXPECT_NE(MessageFor(file.Text()).find("one observation is evaluated at a time"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
