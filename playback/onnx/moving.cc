// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "kinematics/base/result.h"
#include "playback/onnx/compile_internal.h"

namespace gaitwright::onnx {
namespace {

std::vector<std::int64_t> PlacesOf(const Value& value) {
  std::vector<std::int64_t> places(static_cast<std::size_t>(value.count));
  std::iota(places.begin(), places.end(), value.place);
  return places;
}

/// A value seen as outer x size x inner about an axis.
struct Blocks {
  std::int64_t outer = 1, size = 1, inner = 1;

  Blocks(const Dims& dims, std::size_t axis) : size(dims[axis]) {
    for (std::size_t i = 0; i < dims.size(); ++i) (i < axis ? outer : inner) *= i == axis ? 1 : dims[i];
  }
};

/// Places of the elements at the given indices along an axis.
std::vector<std::int64_t> Picked(const Value& in, std::size_t axis, const std::vector<std::int64_t>& indices) {
  const Blocks blocks(in.dims, axis);
  std::vector<std::int64_t> places;
  for (std::int64_t o = 0; o < blocks.outer; ++o) {
    for (const std::int64_t index : indices) {
      for (std::int64_t i = 0; i < blocks.inner; ++i)
        places.push_back(in.place + (o * blocks.size + index) * blocks.inner + i);
    }
  }
  return places;
}

/// Copies the input with another size.
void Reshaped(Compiler& c, const Node& node, const Dims& dims) {
  constexpr std::int64_t kMost = 16000000;
  const Value in = c.In(node, 0);
  if (CountOf(dims, kMost) != in.count)
    throw InvalidArgument(fmt::format("size {} cannot become {}", DimsText(in.dims), DimsText(dims)));
  const Value& out = c.Out(node, dims, in.whole);
  c.Do(out, std::make_shared<Gathered>(PlacesOf(in), out.place));
}

void Reshape(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"allowzero"});
  const Value in = c.In(node, 0);
  Dims dims = c.WholesOf(node, 1);
  std::int64_t known = 1;
  int open = 0;
  for (std::size_t i = 0; i < dims.size(); ++i) {
    if (dims[i] == 0 && WholeAttribute(node, "allowzero", 0) == 0) {
      if (i >= in.dims.size()) throw InvalidArgument("a size of 0 copies a dimension that the input does not have");
      dims[i] = in.dims[i];
    }
    if (dims[i] == -1) ++open;
    if (dims[i] > in.count || dims[i] < -1) throw InvalidArgument(fmt::format("a size of {} is impossible", dims[i]));
    if (dims[i] != -1) known = std::min<std::int64_t>(known * dims[i], std::int64_t{1} << 31);
  }
  if (open > 1) throw InvalidArgument("more than one size is -1");
  if (open == 1) std::replace(dims.begin(), dims.end(), std::int64_t{-1}, known == 0 ? 0 : in.count / known);
  Reshaped(c, node, dims);
}

void Flatten(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"axis"});
  const Dims dims = c.In(node, 0).dims;
  const std::int64_t axis = WholeAttribute(node, "axis", 1);
  const std::size_t at = axis == static_cast<std::int64_t>(dims.size()) ? dims.size() : AxisOf(axis, dims.size());
  std::int64_t rows = 1, columns = 1;
  for (std::size_t i = 0; i < dims.size(); ++i) (i < at ? rows : columns) *= dims[i];
  Reshaped(c, node, {rows, columns});
}

/// Axes are an attribute up to set 12 of operators, and an input later.
std::vector<std::int64_t> AxesOf(const Compiler& c, const Node& node) {
  AcceptAttributes(node, {"axes"});
  if (c.Has(node, 1)) return c.WholesOf(node, 1);
  const auto found = node.attributes.find("axes");
  return found == node.attributes.end() ? std::vector<std::int64_t>() : found->second.wholes;
}

void Squeeze(Compiler& c, const Node& node) {
  const Dims from = c.In(node, 0).dims;
  std::vector<char> drop(from.size(), 0);
  const std::vector<std::int64_t> axes = AxesOf(c, node);
  for (const std::int64_t axis : axes) drop[AxisOf(axis, from.size())] = 1;
  Dims dims;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (drop[i] != 0 && from[i] != 1) throw InvalidArgument(fmt::format("axis {} has size {}, not 1", i, from[i]));
    if (drop[i] == 0 && !(axes.empty() && from[i] == 1)) dims.push_back(from[i]);
  }
  Reshaped(c, node, dims);
}

void Unsqueeze(Compiler& c, const Node& node) {
  const Dims from = c.In(node, 0).dims;
  const std::vector<std::int64_t> axes = AxesOf(c, node);
  const std::size_t rank = from.size() + axes.size();
  std::vector<char> added(rank, 0);
  for (const std::int64_t axis : axes) added[AxisOf(axis, rank)] = 1;
  if (std::count(added.begin(), added.end(), 1) != static_cast<std::ptrdiff_t>(axes.size()))
    throw InvalidArgument("an axis is given twice");
  Dims dims;
  auto next = from.begin();
  for (std::size_t i = 0; i < rank; ++i) dims.push_back(added[i] != 0 ? 1 : *next++);
  Reshaped(c, node, dims);
}

void Concat(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"axis"});
  const Value first = c.In(node, 0);
  const std::size_t axis = AxisOf(WholeAttribute(node, "axis", 0), first.dims.size());
  Dims dims = first.dims;
  dims[axis] = 0;
  bool whole = true;
  for (std::size_t i = 0; i < node.inputs.size(); ++i) {
    Dims part = c.In(node, i).dims;
    whole = whole && c.In(node, i).whole;
    if (part.size() != dims.size())
      throw InvalidArgument(fmt::format("sizes {} and {} cannot be joined", DimsText(first.dims), DimsText(part)));
    dims[axis] += std::exchange(part[axis], first.dims[axis]);
    if (part != first.dims)
      throw InvalidArgument(fmt::format("size {} does not fit the other parts", DimsText(c.In(node, i).dims)));
  }
  const Value& out = c.Out(node, dims, whole);
  const std::int64_t outer = Blocks(dims, axis).outer;
  c.Spend(outer * static_cast<std::int64_t>(node.inputs.size()));
  std::vector<std::int64_t> places;
  for (std::int64_t o = 0; o < outer; ++o) {
    for (std::size_t i = 0; i < node.inputs.size(); ++i) {
      const Value& in = c.In(node, i);
      const Blocks blocks(in.dims, axis);
      for (std::int64_t k = 0; k < blocks.size * blocks.inner; ++k)
        places.push_back(in.place + o * blocks.size * blocks.inner + k);
    }
  }
  c.Do(out, std::make_shared<Gathered>(std::move(places), out.place));
}

void Split(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"axis", "split", "num_outputs"});
  const Value in = c.In(node, 0);
  const std::size_t axis = AxisOf(WholeAttribute(node, "axis", 0), in.dims.size());
  const auto parts = static_cast<std::int64_t>(node.outputs.size());
  std::vector<std::int64_t> sizes;
  if (c.Has(node, 1)) sizes = c.WholesOf(node, 1);
  if (const auto found = node.attributes.find("split"); found != node.attributes.end()) sizes = found->second.wholes;
  if (sizes.empty() && parts > 0) {
    sizes.assign(node.outputs.size(), (in.dims[axis] + parts - 1) / parts);
    sizes.back() = in.dims[axis] - sizes.front() * (parts - 1);
  }
  if (sizes.size() != node.outputs.size()) throw InvalidArgument("its number of sizes is not that of its outputs");
  std::int64_t at = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] < 0 || sizes[i] > in.dims[axis] - at)
      throw InvalidArgument(fmt::format("its parts do not fit {}", DimsText(in.dims)));
    std::vector<std::int64_t> indices(static_cast<std::size_t>(sizes[i]));
    std::iota(indices.begin(), indices.end(), at);
    at += sizes[i];
    Dims dims = in.dims;
    dims[axis] = sizes[i];
    const Value& out = c.Out(node, dims, in.whole, i);
    c.Do(out, std::make_shared<Gathered>(Picked(in, axis, indices), out.place));
  }
}

/// Indices from `start` to `end` along an axis of a size, as in Python.
std::vector<std::int64_t> RangeOf(std::int64_t start, std::int64_t end, std::int64_t step, std::int64_t size) {
  if (step == 0) throw InvalidArgument("a step of a slice is 0");
  const auto within = [&](std::int64_t at) { return std::clamp(at < 0 ? at + size : at, std::int64_t{-1}, size); };
  std::vector<std::int64_t> indices;
  const std::int64_t last = within(end);
  if (step > 0) {
    for (std::int64_t i = std::max<std::int64_t>(within(start), 0); i < last; i += std::min(step, size))
      indices.push_back(i);
  } else {
    const std::int64_t before = end < -size ? -1 : last;
    for (std::int64_t i = std::min(within(start), size - 1); i > before; i += std::max(step, -size))
      indices.push_back(i);
  }
  return indices;
}

/// Limits are attributes up to set 9 of operators, and inputs later.
void Slice(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"starts", "ends", "axes"});
  const auto given = [&](std::size_t index, const char* name) {
    if (c.Has(node, index)) return c.WholesOf(node, index);
    const auto found = node.attributes.find(name);
    return found == node.attributes.end() ? std::vector<std::int64_t>() : found->second.wholes;
  };
  const std::vector<std::int64_t> starts = given(1, "starts"), ends = given(2, "ends"), steps = given(4, "steps");
  std::vector<std::int64_t> axes = given(3, "axes");
  if (axes.empty()) {
    axes.resize(starts.size());
    std::iota(axes.begin(), axes.end(), 0);
  }
  if (starts.size() != ends.size() || starts.size() != axes.size() || (!steps.empty() && steps.size() != axes.size()))
    throw InvalidArgument("its starts, ends, axes and steps have different numbers");
  const Value in = c.In(node, 0);
  Value view = in;
  std::vector<std::int64_t> places = PlacesOf(in);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::size_t axis = AxisOf(axes[i], view.dims.size());
    const auto indices = RangeOf(starts[i], ends[i], steps.empty() ? 1 : steps[i], view.dims[axis]);
    view.place = 0;  // indices into `places`
    std::vector<std::int64_t> next;
    for (const std::int64_t at : Picked(view, axis, indices)) next.push_back(places[static_cast<std::size_t>(at)]);
    places = std::move(next);
    view.dims[axis] = static_cast<std::int64_t>(indices.size());
  }
  const Value& out = c.Out(node, view.dims, in.whole);
  c.Do(out, std::make_shared<Gathered>(std::move(places), out.place));
}

void Gather(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"axis"});
  const Value in = c.In(node, 0);
  const std::size_t axis = AxisOf(WholeAttribute(node, "axis", 0), in.dims.size());
  std::vector<std::int64_t> indices = c.WholesOf(node, 1);
  for (std::int64_t& index : indices) {
    if (index < -in.dims[axis] || index >= in.dims[axis])
      throw InvalidArgument(fmt::format("index {} is outside of size {}", index, in.dims[axis]));
    if (index < 0) index += in.dims[axis];
  }
  Dims dims(in.dims.begin(), in.dims.begin() + static_cast<std::ptrdiff_t>(axis));
  const Dims& middle = c.In(node, 1).dims;
  dims.insert(dims.end(), middle.begin(), middle.end());
  dims.insert(dims.end(), in.dims.begin() + static_cast<std::ptrdiff_t>(axis) + 1, in.dims.end());
  const Value& out = c.Out(node, dims, in.whole);
  c.Do(out, std::make_shared<Gathered>(Picked(in, axis, indices), out.place));
}

void Transpose(Compiler& c, const Node& node) {
  AcceptAttributes(node, {"perm"});
  const Value in = c.In(node, 0);
  const std::size_t rank = in.dims.size();
  std::vector<std::int64_t> order(rank);
  std::iota(order.rbegin(), order.rend(), 0);
  if (const auto found = node.attributes.find("perm"); found != node.attributes.end()) order = found->second.wholes;
  std::vector<std::int64_t> sorted = order, strides(rank, 1), all(rank);
  std::sort(sorted.begin(), sorted.end());
  std::iota(all.begin(), all.end(), 0);
  if (sorted != all) throw InvalidArgument(fmt::format("'perm' is not an order of {} axes", rank));
  for (std::size_t i = rank; i-- > 1;) strides[i - 1] = strides[i] * in.dims[i];
  Dims dims;
  for (const std::int64_t axis : order) dims.push_back(in.dims[static_cast<std::size_t>(axis)]);
  const Value& out = c.Out(node, dims, in.whole);
  std::vector<std::int64_t> places(static_cast<std::size_t>(in.count), in.place);
  for (std::int64_t i = 0; i < in.count; ++i) {
    std::int64_t rest = i;
    for (std::size_t k = rank; k-- > 0;) {
      places[static_cast<std::size_t>(i)] += rest % dims[k] * strides[static_cast<std::size_t>(order[k])];
      rest /= dims[k];
    }
  }
  c.Do(out, std::make_shared<Gathered>(std::move(places), out.place));
}

void Expand(Compiler& c, const Node& node) {
  AcceptAttributes(node, {});
  const Value in = c.In(node, 0);
  const Value& out = c.Out(node, BroadcastDims(in.dims, c.WholesOf(node, 1)), in.whole);
  c.Do(out, std::make_shared<Gathered>(BroadcastPlaces(in, out.dims), out.place));
}

void SetConstant(Compiler& c, const Node& node, const Tensor& tensor) {
  const Value& out = c.Out(node, tensor.dims, tensor.whole);
  std::copy(tensor.numbers.begin(), tensor.numbers.end(), c.memory.begin() + out.place);
}

void Constant(Compiler& c, const Node& node) {
  if (!node.inputs.empty()) throw InvalidArgument("a constant has no inputs");
  for (const auto& [name, attribute] : node.attributes) {
    const std::vector<float> wholes(attribute.wholes.begin(), attribute.wholes.end());
    if (name == "value" && attribute.tensor) return SetConstant(c, node, *attribute.tensor);
    if (name == "value_float") return SetConstant(c, node, {"", {}, false, {attribute.number}});
    if (name == "value_int") return SetConstant(c, node, {"", {}, true, {static_cast<float>(attribute.whole)}});
    if (name == "value_ints")
      return SetConstant(c, node, {"", {static_cast<std::int64_t>(wholes.size())}, true, wholes});
    if (name == "value_floats")
      return SetConstant(c, node,
                         {"", {static_cast<std::int64_t>(attribute.numbers.size())}, false, attribute.numbers});
  }
  throw InvalidArgument("it has no value of a supported type");
}

/// The sizes are known, so the result is constant.
void Shape(Compiler& c, const Node& node) {
  AcceptAttributes(node, {});
  const Dims dims = c.In(node, 0).dims;
  Value& out = c.Out(node, {static_cast<std::int64_t>(dims.size())}, true);
  out.constant = true;
  for (std::size_t i = 0; i < dims.size(); ++i)
    c.memory[static_cast<std::size_t>(out.place) + i] = static_cast<float>(dims[i]);
}

}  // namespace

void AddMovingOperators(std::map<std::string, Operator>& operators) {
  operators["Reshape"] = Reshape;
  operators["Flatten"] = Flatten;
  operators["Squeeze"] = Squeeze;
  operators["Unsqueeze"] = Unsqueeze;
  operators["Concat"] = Concat;
  operators["Split"] = Split;
  operators["Slice"] = Slice;
  operators["Gather"] = Gather;
  operators["Transpose"] = Transpose;
  operators["Expand"] = Expand;
  operators["Constant"] = Constant;
  operators["Shape"] = Shape;
}

}  // namespace gaitwright::onnx
