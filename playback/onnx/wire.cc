// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <bit>

#include "kinematics/base/result.h"
#include "playback/onnx/wire_internal.h"

namespace gaitwright::onnx {
namespace {

constexpr std::size_t kMostFields = 1000000;  // of one message

/// Reads the bytes of a message in order.
class WireReader {
 public:
  explicit WireReader(std::string_view bytes) : rest_(bytes) {}

  bool done() const { return rest_.empty(); }

  std::uint64_t Varint() {
    constexpr int kLongest = 10;  // [byte] for 64 bits
    std::uint64_t value = 0;
    for (int i = 0; i < kLongest; ++i) {
      const auto byte = static_cast<unsigned char>(Take(1).front());
      value |= static_cast<std::uint64_t>(byte & 0x7fU) << (7 * i);
      if ((byte & 0x80U) == 0) return value;
    }
    throw InvalidArgument("a number has more than 10 bytes");
  }

  std::string_view Take(std::uint64_t count) {
    if (count > rest_.size())
      throw InvalidArgument(fmt::format("the file ends within a message: {} bytes are missing", count - rest_.size()));
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

 private:
  std::string_view rest_;
};

WireField NextField(WireReader& reader) {
  const std::uint64_t tag = reader.Varint();
  WireField field;
  field.number = static_cast<int>((tag >> 3) & 0x1fffffffU);
  if (field.number == 0) throw InvalidArgument("a field has number 0");
  switch (tag & 7U) {
    case 0:
      field.value = reader.Varint();
      return field;
    case 1:
      field.kind = WireField::Kind::kFixed64;
      field.value = LittleEndian(reader.Take(8).data(), 8);
      return field;
    case 2:
      field.kind = WireField::Kind::kBytes;
      field.bytes = reader.Take(reader.Varint());
      return field;
    case 5:
      field.kind = WireField::Kind::kFixed32;
      field.value = LittleEndian(reader.Take(4).data(), 4);
      return field;
    default:
      throw InvalidArgument(fmt::format("field {} has wire type {}; accepted: 0, 1, 2, 5", field.number, tag & 7U));
  }
}

[[noreturn]] void RefuseKind(const WireField& field, const char* needed) {
  throw InvalidArgument(fmt::format("field {} is not {}", field.number, needed));
}

}  // namespace

std::uint64_t LittleEndian(const char* bytes, int count) {
  std::uint64_t value = 0;
  for (int i = 0; i < count; ++i) value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  return value;
}

float FloatFrom(const char* bytes) { return std::bit_cast<float>(static_cast<std::uint32_t>(LittleEndian(bytes, 4))); }

double DoubleFrom(const char* bytes) { return std::bit_cast<double>(LittleEndian(bytes, 8)); }

float WireField::Float() const { return std::bit_cast<float>(static_cast<std::uint32_t>(value)); }

std::vector<WireField> FieldsOf(std::string_view message) {
  std::vector<WireField> fields;
  for (WireReader reader(message); !reader.done();) {
    fields.push_back(NextField(reader));
    if (fields.size() > kMostFields)
      throw InvalidArgument(fmt::format("a message has more than {} fields", kMostFields));
  }
  return fields;
}

void AddWholes(const WireField& field, std::vector<std::int64_t>& list) {
  if (field.kind == WireField::Kind::kVarint) return list.push_back(field.Whole());
  if (field.kind != WireField::Kind::kBytes) RefuseKind(field, "a list of whole numbers");
  for (WireReader reader(field.bytes); !reader.done();) list.push_back(static_cast<std::int64_t>(reader.Varint()));
}

void AddFloats(const WireField& field, std::vector<float>& list) {
  if (field.kind == WireField::Kind::kFixed32) return list.push_back(field.Float());
  if (field.kind != WireField::Kind::kBytes || field.bytes.size() % 4 != 0) RefuseKind(field, "a list of floats");
  for (std::size_t i = 0; i < field.bytes.size(); i += 4) list.push_back(FloatFrom(field.bytes.data() + i));
}

void AddDoubles(const WireField& field, std::vector<float>& list) {
  if (field.kind == WireField::Kind::kFixed64)
    return list.push_back(static_cast<float>(std::bit_cast<double>(field.value)));
  if (field.kind != WireField::Kind::kBytes || field.bytes.size() % 8 != 0) RefuseKind(field, "a list of doubles");
  for (std::size_t i = 0; i < field.bytes.size(); i += 8)
    list.push_back(static_cast<float>(DoubleFrom(field.bytes.data() + i)));
}

std::string_view BytesOf(const WireField& field) {
  if (field.kind != WireField::Kind::kBytes) RefuseKind(field, "a text or a message");
  return field.bytes;
}

}  // namespace gaitwright::onnx
