// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/result.h"
#include "playback/onnx/compile_internal.h"

namespace gaitwright::onnx {
namespace {

void WithParameters(Compiler& c, const Node& node, OneFunction function, float a, float b = 0.0F) {
  const Value in = c.In(node, 0);
  const Value& out = c.Out(node, in.dims, in.whole);
  c.Do(out, std::make_shared<Elementwise>(function, Elementwise::Places{in.place, out.place, out.count}, a, b));
}

/// An operator of one element without parameters, by its function.
template <auto Function>
void One(Compiler& c, const Node& node) {
  AcceptAttributes(node, {});
  WithParameters(c, node, Function, 0.0F);
}

void Elu(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"alpha"});
  const auto elu = [](float x, float a, float) { return x > 0.0F ? x : a * std::expm1(x); };
  WithParameters(c, node, elu, FloatAttribute(node, "alpha", 1.0F));
}

void Celu(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"alpha"});
  const float alpha = FloatAttribute(node, "alpha", 1.0F);
  if (alpha == 0.0F) throw InvalidArgument("attribute 'alpha' is 0");
  const auto celu = [](float x, float a, float) { return x > 0.0F ? x : a * std::expm1(x / a); };
  WithParameters(c, node, celu, alpha);
}

void LeakyRelu(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"alpha"});
  const auto leaky = [](float x, float a, float) { return x >= 0.0F ? x : a * x; };
  WithParameters(c, node, leaky, FloatAttribute(node, "alpha", 0.01F));
}

void Selu(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"alpha", "gamma"});
  const auto selu = [](float x, float a, float gamma) { return gamma * (x > 0.0F ? x : a * std::expm1(x)); };
  WithParameters(c, node, selu, FloatAttribute(node, "alpha", 1.67326319F), FloatAttribute(node, "gamma", 1.05070102F));
}

/// Limits are attributes up to set 10 of operators, and inputs later.
void Clip(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"min", "max"});
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float low = c.Has(node, 1) ? c.NumberOf(node, 1) : FloatAttribute(node, "min", -kInfinity);
  const float high = c.Has(node, 2) ? c.NumberOf(node, 2) : FloatAttribute(node, "max", kInfinity);
  const auto clip = [](float x, float a, float b) { return std::min(std::max(x, a), b); };
  WithParameters(c, node, clip, low, high);
}

float Same(float x, float, float) { return x; }

void Identity(Compiler& c, const Node& node) { One<Same>(c, node); }

/// In an evaluation, nothing is dropped.
void Dropout(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"ratio", "seed", "is_test", "consumed_inputs"});
  WithParameters(c, node, Same, 0.0F);
}

void Cast(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"to", "saturate"});
  const std::int64_t to = WholeAttribute(node, "to", 0);
  const bool to_float = to == 1 || to == 10 || to == 11, to_truth = to == 9;
  const bool to_whole = to == 2 || to == 3 || to == 6 || to == 7;
  if (!to_float && !to_truth && !to_whole) throw InvalidArgument(fmt::format("a cast to type {} is not supported", to));
  const Value in = c.In(node, 0);
  const Value& out = c.Out(node, in.dims, !to_float);
  const OneFunction truth = [](float x, float, float) { return x != 0.0F ? 1.0F : 0.0F; };
  const OneFunction whole = [](float x, float, float) { return std::trunc(x); };
  const OneFunction function = to_float ? Same : to_truth ? truth : whole;
  c.Do(out, std::make_shared<Elementwise>(function, Elementwise::Places{in.place, out.place, out.count}));
}

void Combine(Compiler& c, const Node& node, TwoFunction function) {
  AcceptAttributes(node, {});
  if (node.inputs.size() != 2)
    throw InvalidArgument(fmt::format("it has {} inputs; exactly two are supported", node.inputs.size()));
  const Value x = c.In(node, 0), y = c.In(node, 1);
  const Value& out = c.Out(node, BroadcastDims(x.dims, y.dims), x.whole && y.whole);
  c.Do(out,
       std::make_shared<Pairwise>(function, BroadcastPlaces(x, out.dims), BroadcastPlaces(y, out.dims), out.place));
}

template <auto Function>
void Two(Compiler& c, const Node& node) {
  Combine(c, node, Function);
}

/// Whole numbers are divided with truncation.
void Div(Compiler& c, const Node& node) {
  const bool whole = c.In(node, 0).whole && c.In(node, 1).whole;
  const TwoFunction floats = [](float x, float y) { return x / y; };
  const TwoFunction wholes = [](float x, float y) { return std::trunc(x / y); };
  Combine(c, node, whole ? wholes : floats);
}

float SigmoidOf(float x, float, float) { return 1.0F / (1.0F + std::exp(-x)); }
/// ln(1 + e^x), without an overflow for large x.
float SoftplusOf(float x, float, float) { return std::max(x, 0.0F) + std::log1p(std::exp(-std::abs(x))); }

}  // namespace

void AddElementwiseOperators(std::map<std::string, Operator>& operators) {
  operators["Elu"] = Elu;
  operators["Celu"] = Celu;
  operators["LeakyRelu"] = LeakyRelu;
  operators["Selu"] = Selu;
  operators["Clip"] = Clip;
  operators["Identity"] = Identity;
  operators["Dropout"] = Dropout;
  operators["Cast"] = Cast;
  operators["Div"] = Div;
  operators["Relu"] = One<[](float x, float, float) { return std::max(x, 0.0F); }>;
  operators["Tanh"] = One<[](float x, float, float) { return std::tanh(x); }>;
  operators["Sigmoid"] = One<SigmoidOf>;
  operators["Softplus"] = One<SoftplusOf>;
  operators["Softsign"] = One<[](float x, float, float) { return x / (1.0F + std::abs(x)); }>;
  operators["Erf"] = One<[](float x, float, float) { return std::erf(x); }>;
  operators["Exp"] = One<[](float x, float, float) { return std::exp(x); }>;
  operators["Log"] = One<[](float x, float, float) { return std::log(x); }>;
  operators["Sqrt"] = One<[](float x, float, float) { return std::sqrt(x); }>;
  operators["Abs"] = One<[](float x, float, float) { return std::abs(x); }>;
  operators["Neg"] = One<[](float x, float, float) { return -x; }>;
  operators["Reciprocal"] = One<[](float x, float, float) { return 1.0F / x; }>;
  operators["Floor"] = One<[](float x, float, float) { return std::floor(x); }>;
  operators["Sin"] = One<[](float x, float, float) { return std::sin(x); }>;
  operators["Cos"] = One<[](float x, float, float) { return std::cos(x); }>;
  operators["Add"] = Two<[](float x, float y) { return x + y; }>;
  operators["Sub"] = Two<[](float x, float y) { return x - y; }>;
  operators["Mul"] = Two<[](float x, float y) { return x * y; }>;
  operators["Max"] = Two<[](float x, float y) { return std::max(x, y); }>;
  operators["Min"] = Two<[](float x, float y) { return std::min(x, y); }>;
  operators["Pow"] = Two<[](float x, float y) { return std::pow(x, y); }>;
}

}  // namespace gaitwright::onnx
