// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "kinematics/base/result.h"
#include "kinematics/base/text.h"
#include "playback/onnx/graph_internal.h"
#include "playback/onnx/half_internal.h"
#include "playback/onnx/wire_internal.h"

namespace gaitwright::onnx {
namespace {

constexpr std::size_t kMostNodes = 100000, kMostConstants = 10000, kMostDims = 64, kLongestName = 1000;
constexpr std::int64_t kMostElements = 16000000;

// TensorProto.DataType
enum ElementType : std::int64_t {
  kFloat = 1,
  kUint8 = 2,
  kInt8 = 3,
  kInt32 = 6,
  kInt64 = 7,
  kBool = 9,
  kFloat16 = 10,
  kDouble = 11
};

std::string NameOf(const WireField& field) {
  std::string name(BytesOf(field));
  if (name.size() > kLongestName || !IsPlainText(name))
    throw InvalidArgument(
        fmt::format("field {} is not a name in plain text of up to {} bytes", field.number, kLongestName));
  return name;
}

/// The elements of a tensor as the file stores them: raw bytes, or one of the typed lists.
struct Elements {
  std::int64_t type = 0;
  std::string_view raw;
  bool has_raw = false;
  std::vector<float> floats;
  std::vector<std::int64_t> wholes;
};

int SizeOf(std::int64_t type) {
  switch (type) {
    case kUint8:
    case kInt8:
    case kBool:
      return 1;
    case kFloat16:
      return 2;
    case kFloat:
    case kInt32:
      return 4;
    case kInt64:
    case kDouble:
      return 8;
    default:
      return 0;
  }
}

float FromRaw(std::int64_t type, const char* bytes) {
  switch (type) {
    case kFloat:
      return FloatFrom(bytes);
    case kDouble:
      return static_cast<float>(DoubleFrom(bytes));
    case kFloat16:
      return FloatFromHalf(static_cast<std::uint16_t>(LittleEndian(bytes, 2)));
    case kInt8:
      return static_cast<float>(static_cast<std::int8_t>(LittleEndian(bytes, 1)));
    case kInt32:
      return static_cast<float>(static_cast<std::int32_t>(LittleEndian(bytes, 4)));
    case kInt64:
      return static_cast<float>(static_cast<std::int64_t>(LittleEndian(bytes, 8)));
    default:
      return static_cast<float>(LittleEndian(bytes, 1));
  }
}

std::vector<float> NumbersOf(const Elements& e) {
  std::vector<float> numbers;
  if (e.has_raw) {
    const auto size = static_cast<std::size_t>(SizeOf(e.type));
    if (e.raw.size() % size != 0) throw InvalidArgument(fmt::format("{} bytes are not whole elements", e.raw.size()));
    for (std::size_t i = 0; i < e.raw.size(); i += size) numbers.push_back(FromRaw(e.type, e.raw.data() + i));
    return numbers;
  }
  if (!e.floats.empty()) return e.floats;
  for (const std::int64_t whole : e.wholes) {
    numbers.push_back(e.type == kFloat16 ? FloatFromHalf(static_cast<std::uint16_t>(whole))
                                         : static_cast<float>(whole));
  }
  return numbers;
}

Tensor ReadTensor(std::string_view message) {
  Tensor tensor;
  Elements elements;
  bool outside = false;
  for (const WireField& field : FieldsOf(message)) {
    if (field.number == 1) AddWholes(field, tensor.dims);
    if (field.number == 2) elements.type = field.Whole();
    if (field.number == 4) AddFloats(field, elements.floats);
    if (field.number == 5 || field.number == 7) AddWholes(field, elements.wholes);
    if (field.number == 8) tensor.name = NameOf(field);
    if (field.number == 9) elements.raw = BytesOf(field);
    if (field.number == 9) elements.has_raw = true;
    if (field.number == 10) AddDoubles(field, elements.floats);
    if (field.number == 14) outside = field.Whole() != 0;
  }
  const auto refuse = [&](const std::string& why) {
    throw InvalidArgument(fmt::format("constant '{}' {}", tensor.name, why));
  };
  if (outside) refuse("is in another file; export the network with all weights in one file");
  if (SizeOf(elements.type) == 0)
    refuse(fmt::format("has elements of type {}; accepted: float, double, float16, int8, uint8, int32, int64, bool",
                       elements.type));
  if (tensor.dims.size() > kMostDims) refuse(fmt::format("has {} dimensions", tensor.dims.size()));
  tensor.whole = elements.type != kFloat && elements.type != kDouble && elements.type != kFloat16;
  tensor.numbers = NumbersOf(elements);
  const std::int64_t count = CountOf(tensor.dims, kMostElements);
  if (count != static_cast<std::int64_t>(tensor.numbers.size()))
    refuse(fmt::format("has {} elements; its size {} needs {}", tensor.numbers.size(), DimsText(tensor.dims), count));
  return tensor;
}

void AddAttribute(std::string_view message, Node& node) {
  Attribute attribute;
  std::string name;
  for (const WireField& field : FieldsOf(message)) {
    if (field.number == 1) name = NameOf(field);
    if (field.number == 2) attribute.number = field.Float();
    if (field.number == 3) attribute.whole = field.Whole();
    if (field.number == 4) attribute.text = BytesOf(field);
    if (field.number == 5) attribute.tensor = ReadTensor(BytesOf(field));
    if (field.number == 6 || field.number == 11)
      throw InvalidArgument("a node contains a graph of its own (control flow), which is not supported");
    if (field.number == 7) AddFloats(field, attribute.numbers);
    if (field.number == 8) AddWholes(field, attribute.wholes);
  }
  node.attributes.insert_or_assign(name, std::move(attribute));
}

Node ReadNode(std::string_view message) {
  Node node;
  std::string domain;
  const std::vector<WireField> fields = FieldsOf(message);
  for (const WireField& field : fields) {
    if (field.number == 1) node.inputs.push_back(NameOf(field));
    if (field.number == 2) node.outputs.push_back(NameOf(field));
    if (field.number == 3) node.name = NameOf(field);
    if (field.number == 4) node.op = NameOf(field);
    if (field.number == 7) domain = NameOf(field);
  }
  if (!domain.empty() && domain != "ai.onnx") node.op = domain + "." + node.op;
  if (node.name.empty() && !node.outputs.empty()) node.name = node.outputs.front();
  try {
    for (const WireField& field : fields) {
      if (field.number == 5) AddAttribute(BytesOf(field), node);
    }
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(fmt::format("{}: {}", node.Text(), error.what()));
  }
  return node;
}

/// TensorShapeProto
Dims ReadShape(std::string_view message) {
  Dims dims;
  for (const WireField& field : FieldsOf(message)) {
    if (field.number != 1) continue;
    dims.push_back(-1);
    for (const WireField& size : FieldsOf(BytesOf(field))) {
      if (size.number == 1) dims.back() = size.Whole();
    }
    if (dims.size() > kMostDims) throw InvalidArgument(fmt::format("a shape has more than {} dimensions", kMostDims));
  }
  return dims;
}

/// ValueInfoProto
Port ReadPort(std::string_view message) {
  Port port;
  for (const WireField& field : FieldsOf(message)) {
    if (field.number == 1) port.name = NameOf(field);
    if (field.number != 2) continue;
    for (const WireField& type : FieldsOf(BytesOf(field))) {
      if (type.number != 1) continue;  // TypeProto.tensor_type
      for (const WireField& part : FieldsOf(BytesOf(type))) {
        if (part.number == 1) port.is_float = part.Whole() == kFloat;
        if (part.number == 2) port.dims = ReadShape(BytesOf(part));
      }
    }
  }
  return port;
}

void CheckMost(const char* what, std::size_t count, std::size_t most) {
  if (count > most) throw InvalidArgument(fmt::format("there are more than {} {}", most, what));
}

void ReadGraphMessage(std::string_view message, Graph& graph) {
  for (const WireField& field : FieldsOf(message)) {
    if (field.number == 1) graph.nodes.push_back(ReadNode(BytesOf(field)));
    if (field.number == 5) graph.constants.push_back(ReadTensor(BytesOf(field)));
    if (field.number == 11) graph.inputs.push_back(ReadPort(BytesOf(field)));
    if (field.number == 12) graph.outputs.push_back(ReadPort(BytesOf(field)));
    CheckMost("nodes", graph.nodes.size(), kMostNodes);
    CheckMost("constants", graph.constants.size(), kMostConstants);
    CheckMost("inputs and outputs", graph.inputs.size() + graph.outputs.size(), kMostConstants);
  }
  std::set<std::string> constants;
  for (const Tensor& tensor : graph.constants) constants.insert(tensor.name);
  std::erase_if(graph.inputs, [&](const Port& port) { return constants.contains(port.name); });
}

/// OperatorSetIdProto and StringStringEntryProto: two fields.
std::pair<std::string, WireField> PairOf(std::string_view message) {
  std::pair<std::string, WireField> pair;
  for (const WireField& field : FieldsOf(message)) {
    if (field.number == 1) pair.first = BytesOf(field);
    if (field.number == 2) pair.second = field;
  }
  return pair;
}

}  // namespace

std::int64_t CountOf(const Dims& dims, std::int64_t most) {
  std::int64_t count = 1;
  for (const std::int64_t size : dims) {
    if (size < 0) throw InvalidArgument(fmt::format("the size {} has a negative part", DimsText(dims)));
    const std::int64_t counted = std::max<std::int64_t>(size, 1);  // bounds the other sizes of an empty value too
    if (counted > most || count > most / counted)
      throw InvalidArgument(fmt::format("the size {} exceeds {} elements", DimsText(dims), most));
    count *= counted;
  }
  return std::find(dims.begin(), dims.end(), 0) == dims.end() ? count : 0;
}

std::string DimsText(const Dims& dims) { return dims.empty() ? "a scalar" : fmt::format("{}", fmt::join(dims, " x ")); }

std::string Node::Text() const { return fmt::format("node '{}' ({})", name, op); }

Graph ReadGraph(std::string_view file) {
  Graph graph;
  bool found = false;
  for (const WireField& field : FieldsOf(file)) {
    if (field.number == 7) {
      ReadGraphMessage(BytesOf(field), graph);
      found = true;
    } else if (field.number == 8) {
      const auto [domain, version] = PairOf(BytesOf(field));
      if (domain.empty() || domain == "ai.onnx") graph.opset = version.Whole();
    } else if (field.number == 14 && graph.notes.size() < kMostConstants) {
      const auto [key, value] = PairOf(BytesOf(field));
      graph.notes.insert_or_assign(key, std::string(value.bytes));
    }
  }
  if (!found) throw InvalidArgument("it contains no graph, so it is not an ONNX file");
  return graph;
}

}  // namespace gaitwright::onnx
