// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "kinematics/base/result.h"
#include "playback/onnx/compile_internal.h"

namespace gaitwright::onnx {
namespace {

/// Y = alpha A' B' + beta C
void Gemm(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"alpha", "beta", "transA", "transB"});
  const Value a = c.In(node, 0), b = c.In(node, 1);
  if (a.dims.size() != 2 || b.dims.size() != 2)
    throw InvalidArgument(
        fmt::format("its factors are of sizes {} and {}; matrices are needed", DimsText(a.dims), DimsText(b.dims)));
  Product::Places p{a.place, b.place};
  p.a_transposed = WholeAttribute(node, "transA", 0) != 0;
  p.b_transposed = WholeAttribute(node, "transB", 0) != 0;
  p.m = a.dims[p.a_transposed ? 1 : 0];
  p.k = a.dims[p.a_transposed ? 0 : 1];
  p.n = b.dims[p.b_transposed ? 0 : 1];
  if (b.dims[p.b_transposed ? 1 : 0] != p.k)
    throw InvalidArgument(fmt::format("its factors are of sizes {} and {}, which do not fit each other",
                                      DimsText(a.dims), DimsText(b.dims)));
  p.alpha = FloatAttribute(node, "alpha", 1.0F);
  c.Spend(p.m * p.k * p.n);
  const Value& out = c.Out(node, {p.m, p.n}, false);
  p.out = out.place;
  c.Do(out, std::make_shared<Product>(p));
  if (!c.Has(node, 2)) return;
  c.Do(out, std::make_shared<Added>(BroadcastPlaces(c.In(node, 2), out.dims), out.place,
                                    FloatAttribute(node, "beta", 1.0F)));
}

/// As numpy.matmul, for a second factor of one or two dimensions. The leading sizes of the first factor are rows.
void MatMul(Compiler& c, const Node& node) {
  AcceptAttributes(node, {});
  const Value a = c.In(node, 0), b = c.In(node, 1);
  if (a.dims.empty() || b.dims.empty() || b.dims.size() > 2)
    throw InvalidArgument(
        fmt::format("factors of sizes {} and {} are not supported", DimsText(a.dims), DimsText(b.dims)));
  Product::Places p{a.place, b.place};
  p.k = a.dims.back();
  p.m = p.k == 0 ? 0 : a.count / p.k;
  p.n = b.dims.size() == 2 ? b.dims[1] : 1;
  if (b.dims.front() != p.k)
    throw InvalidArgument(fmt::format("its factors are of sizes {} and {}, which do not fit each other",
                                      DimsText(a.dims), DimsText(b.dims)));
  Dims dims(a.dims.begin(), a.dims.end() - 1);
  if (b.dims.size() == 2) dims.push_back(p.n);
  c.Spend(p.m * p.k * p.n);
  const Value& out = c.Out(node, dims, false);
  if (out.count != p.m * p.n) throw InvalidArgument(fmt::format("size {} is not supported", DimsText(a.dims)));
  p.out = out.place;
  c.Do(out, std::make_shared<Product>(p));
}

}  // namespace

void AddProductOperators(std::map<std::string, Operator>& operators) {
  operators["Gemm"] = Gemm;
  operators["MatMul"] = MatMul;
}

}  // namespace gaitwright::onnx
