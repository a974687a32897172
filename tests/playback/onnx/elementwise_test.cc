// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/playback/onnx/written_network.h"

namespace gaitwright {
namespace {

using written::File;
using written::FloatOf;
using written::Node;

const Eigen::VectorXf kElements = (Eigen::VectorXf(6) << -100.0F, -1.3F, -0.2F, 0.0F, 0.7F, 90.0F).finished();

Eigen::VectorXf AppliedTo(const std::string& op, const std::vector<std::string>& attributes = {},
                          const std::vector<std::string>& more = {}, const std::vector<std::string>& constants = {}) {
  File file;
  file.inputs = static_cast<int>(kElements.size());
  std::vector<std::string> inputs = {"obs"};
  inputs.insert(inputs.end(), more.begin(), more.end());
  file.nodes = {Node(op, inputs, {"action"}, attributes)};
  file.constants = constants;
  return written::Evaluated(written::NetworkOf(file.Text()), kElements);
}

void ExpectEach(const Eigen::VectorXf& output, double (*function)(double), const char* what) {
  ASSERT_EQ(output.size(), kElements.size()) << what;
  for (Eigen::Index i = 0; i < kElements.size(); ++i) {
    const double expected = function(static_cast<double>(kElements[i]));
    EXPECT_NEAR(static_cast<double>(output[i]), expected, 1e-6 * (1.0 + std::abs(expected)))
        << what << " " << kElements[i];
  }
}

TEST(ElementwiseTest, ActivationsEqualTheirDefinitions) {
  ExpectEach(
      AppliedTo("Elu", {FloatOf("alpha", 0.5F)}), [](double x) { return x > 0 ? x : 0.5 * std::expm1(x); }, "Elu");
  ExpectEach(
      AppliedTo("Relu"), [](double x) { return std::max(x, 0.0); }, "Relu");
  ExpectEach(
      AppliedTo("LeakyRelu"), [](double x) { return x > 0 ? x : 0.01 * x; }, "LeakyRelu");
  ExpectEach(
      AppliedTo("Selu"), [](double x) { return 1.0507009873554805 * (x > 0 ? x : 1.6732632423543772 * std::expm1(x)); },
      "Selu");
  ExpectEach(
      AppliedTo("Celu", {FloatOf("alpha", 2.0F)}),
      [](double x) { return std::max(0.0, x) + std::min(0.0, 2.0 * std::expm1(x / 2.0)); }, "Celu");
  ExpectEach(
      AppliedTo("Softplus"), [](double x) { return x > 40.0 ? x : std::log1p(std::exp(x)); }, "Softplus");
  ExpectEach(
      AppliedTo("Softsign"), [](double x) { return x / (1.0 + std::abs(x)); }, "Softsign");
  ExpectEach(
      AppliedTo("Tanh"), [](double x) { return std::tanh(x); }, "Tanh");
  ExpectEach(
      AppliedTo("Sigmoid"), [](double x) { return 1.0 / (1.0 + std::exp(-x)); }, "Sigmoid");
  ExpectEach(
      AppliedTo("Erf"), [](double x) { return std::erf(x); }, "Erf");
  ExpectEach(
      AppliedTo("Abs"), [](double x) { return std::abs(x); }, "Abs");
  ExpectEach(
      AppliedTo("Neg"), [](double x) { return -x; }, "Neg");
  ExpectEach(
      AppliedTo("Floor"), [](double x) { return std::floor(x); }, "Floor");
  ExpectEach(
      AppliedTo("Sin"), [](double x) { return std::sin(x); }, "Sin");
  ExpectEach(
      AppliedTo("Cos"), [](double x) { return std::cos(x); }, "Cos");
}

TEST(ElementwiseTest, ClipsByAttributesAndByInputs) {
  const auto clip = [](double x) { return std::min(std::max(x, -1.0), 0.5); };
  ExpectEach(AppliedTo("Clip", {FloatOf("min", -1.0F), FloatOf("max", 0.5F)}), clip, "attributes");
  ExpectEach(AppliedTo("Clip", {}, {"low", "high"},
                       {written::Floats("low", {}, {-1.0F}), written::Floats("high", {}, {0.5F})}),
             clip, "inputs");
  ExpectEach(
      AppliedTo("Clip", {}, {"", "high"}, {written::Floats("high", {}, {0.5F})}),
      [](double x) { return std::min(x, 0.5); }, "one limit");
}

TEST(ElementwiseTest, CombinesWithBroadcast) {
  const std::vector<std::string> two = {written::Floats("c", {1}, {2.0F})};
  ExpectEach(
      AppliedTo("Add", {}, {"c"}, two), [](double x) { return x + 2.0; }, "Add");
  ExpectEach(
      AppliedTo("Sub", {}, {"c"}, two), [](double x) { return x - 2.0; }, "Sub");
  ExpectEach(
      AppliedTo("Mul", {}, {"c"}, two), [](double x) { return x * 2.0; }, "Mul");
  ExpectEach(
      AppliedTo("Div", {}, {"c"}, two), [](double x) { return x / 2.0; }, "Div");
  ExpectEach(
      AppliedTo("Max", {}, {"c"}, two), [](double x) { return std::max(x, 2.0); }, "Max");
  ExpectEach(
      AppliedTo("Min", {}, {"c"}, two), [](double x) { return std::min(x, 2.0); }, "Min");
  ExpectEach(
      AppliedTo("Pow", {}, {"c"}, two), [](double x) { return x * x; }, "Pow");
  const Eigen::VectorXf rows = AppliedTo("Mul", {}, {"m"}, {written::Floats("m", {2, 1}, {1.0F, 3.0F})});
  ASSERT_EQ(rows.size(), 12);
  EXPECT_EQ(rows.head(6), kElements);
  EXPECT_EQ(rows.tail(6), 3.0F * kElements);
}

TEST(ElementwiseTest, CastsToWholeNumbersByTruncation) {
  ExpectEach(
      AppliedTo("Cast", {written::WholeOf("to", 7)}), [](double x) { return std::trunc(x); }, "int64");
  ExpectEach(
      AppliedTo("Cast", {written::WholeOf("to", 9)}), [](double x) { return x != 0.0 ? 1.0 : 0.0; }, "bool");
  ExpectEach(
      AppliedTo("Cast", {written::WholeOf("to", 1)}), [](double x) { return x; }, "float");
}

}  // namespace
}  // namespace gaitwright
