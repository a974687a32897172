// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string_view>

#include "kinematics/base/result.h"
#include "workflows/exchange/npy_array_internal.h"

namespace gaitwright {
namespace {

/// The dictionary of a `.npy`: {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }
struct NpyHead {
  std::string kind;
  bool fortran = false;
  std::vector<std::size_t> shape;
};

/// Reads the dictionary, which NumPy writes as a Python literal.
class HeadReader {
 public:
  explicit HeadReader(std::string_view text) : text_(text) {}

  NpyHead Run() {
    NpyHead head;
    bool has_kind = false, has_order = false, has_shape = false;
    Take('{');
    while (!Next('}')) {
      const std::string key = Quoted();
      Take(':');
      if (key == "descr") {
        if (Peek() != '\'' && Peek() != '"') throw InvalidArgument("its elements are records, which are not read");
        head.kind = Quoted();
        has_kind = true;
      } else if (key == "fortran_order") {
        head.fortran = Truth();
        has_order = true;
      } else if (key == "shape") {
        head.shape = Shape();
        has_shape = true;
      } else {
        Refuse();
      }
      if (!Next(',')) {
        Take('}');
        break;
      }
    }
    if (!has_kind || !has_order || !has_shape) Refuse();
    return head;
  }

 private:
  [[noreturn]] static void Refuse() { throw InvalidArgument("its head is not one that NumPy writes"); }

  char Peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool Next(char c) {
    if (Peek() != c) return false;
    ++at_;
    return true;
  }
  void Take(char c) {
    if (!Next(c)) Refuse();
  }
  std::string Quoted() {
    const char quote = Peek();
    if (quote != '\'' && quote != '"') Refuse();
    const std::size_t end = text_.find(quote, ++at_);
    if (end == std::string_view::npos) Refuse();
    std::string quoted(text_.substr(at_, end - at_));
    at_ = end + 1;
    return quoted;
  }
  bool Truth() {
    Peek();
    for (const bool value : {true, false}) {
      const std::string_view word = value ? "True" : "False";
      if (text_.substr(at_, word.size()) != word) continue;
      at_ += word.size();
      return value;
    }
    Refuse();
  }
  std::vector<std::size_t> Shape() {
    std::vector<std::size_t> shape;
    Take('(');
    while (!Next(')')) {
      Peek();
      std::size_t size = 0;
      const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), size);
      if (error != std::errc()) Refuse();
      at_ = static_cast<std::size_t>(end - text_.data());
      if (at_ < text_.size() && text_[at_] == 'L') ++at_;  // of Python 2
      shape.push_back(size);
      if (!Next(',')) {
        Take(')');
        break;
      }
    }
    return shape;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The unsigned integer of bytes, the first one the lowest unless `big`.
std::uint64_t WholeOf(const char* bytes, std::size_t size, bool big) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[big ? size - 1 - i : i])) << (8U * i);
  return value;
}

double NumberOf(char kind, const char* bytes, std::size_t size, bool big) {
  const std::uint64_t whole = WholeOf(bytes, size, big);
  if (kind == 'f') {
    return size == 8 ? std::bit_cast<double>(whole)
                     : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(whole)));
  }
  if (kind != 'i') return static_cast<double>(whole);
  const unsigned unused = 8U * static_cast<unsigned>(sizeof(whole) - size);
  return static_cast<double>(static_cast<std::int64_t>(whole << unused) >> unused);
}

void AppendUtf8(std::uint64_t point, std::string& text) {
  constexpr std::uint64_t kLast = 0x10ffff;
  if (point > kLast || (point >= 0xd800 && point < 0xe000)) throw InvalidArgument("a text in it is not valid Unicode");
  const auto add = [&](std::uint64_t byte) { text += static_cast<char>(byte); };
  if (point < 0x80) {
    add(point);
  } else if (point < 0x800) {
    add(0xc0 | point >> 6U), add(0x80 | (point & 0x3f));
  } else if (point < 0x10000) {
    add(0xe0 | point >> 12U), add(0x80 | (point >> 6U & 0x3f)), add(0x80 | (point & 0x3f));
  } else {
    add(0xf0 | point >> 18U), add(0x80 | (point >> 12U & 0x3f)), add(0x80 | (point >> 6U & 0x3f));
    add(0x80 | (point & 0x3f));
  }
}

/// A text of fixed width, without the zeros behind it.
std::string TextOf(char kind, const char* bytes, std::size_t size, bool big) {
  const std::size_t unit = kind == 'U' ? 4 : 1;
  std::string text;
  for (std::size_t i = 0; i + unit <= size; i += unit) {
    const std::uint64_t point = WholeOf(bytes + i, unit, big);
    if (point == 0) break;
    AppendUtf8(point, text);
  }
  return text;
}

/// Type of the elements: byte order, kind, and size in bytes.
struct ElementType {
  bool big = false;
  char kind = 'f';
  std::size_t size = 8;
};

ElementType TypeOf(const std::string& descr) {
  ElementType type;
  std::string_view rest = descr;
  if (!rest.empty() && std::string_view("<>|=").find(rest.front()) != std::string_view::npos) {
    type.big = rest.front() == '>';
    rest.remove_prefix(1);
  }
  if (!rest.empty() && rest.front() == 'O')
    throw InvalidArgument("it holds Python objects; save it without them (numpy.savez of arrays of numbers)");
  const auto refuse = [&] { throw InvalidArgument(fmt::format("elements of type '{}' are not read", descr)); };
  if (rest.size() < 2 || std::string_view("fiubUS").find(rest.front()) == std::string_view::npos) refuse();
  type.kind = rest.front();
  rest.remove_prefix(1);
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), type.size);
  if (error != std::errc() || end != rest.data() + rest.size()) refuse();
  const bool whole = type.size == 1 || type.size == 2 || type.size == 4 || type.size == 8;
  const bool is_text = type.kind == 'U' || type.kind == 'S';
  if (type.kind == 'f' && type.size != 4 && type.size != 8) refuse();
  if ((type.kind == 'i' || type.kind == 'u') && !whole) refuse();
  if (type.kind == 'b' && type.size != 1) refuse();
  constexpr std::size_t kLongestText = 10000;
  if (is_text && type.size > kLongestText) refuse();
  if (type.kind == 'U') type.size *= 4;
  return type;
}

/// Index of an element in Fortran order by its index in C order.
std::size_t FortranIndex(std::size_t index, const std::vector<std::size_t>& shape) {
  std::size_t place = 0, stride = 1;
  std::vector<std::size_t> at(shape.size());
  for (std::size_t axis = shape.size(); axis-- > 0;) {
    at[axis] = index % shape[axis];
    index /= shape[axis];
  }
  for (std::size_t axis = 0; axis < shape.size(); ++axis) {
    place += at[axis] * stride;
    stride *= shape[axis];
  }
  return place;
}

/// @return where the data begin.
std::size_t ReadHead(const std::string& bytes, NpyHead& head) {
  constexpr std::string_view kMagic = "\x93NUMPY";
  constexpr std::size_t kVersion = 6, kLength = 8;
  if (bytes.size() < kLength + 2 || bytes.compare(0, kMagic.size(), kMagic) != 0)
    throw InvalidArgument("it is not an array of NumPy");
  const int version = static_cast<unsigned char>(bytes[kVersion]);
  if (version < 1 || version > 3) throw InvalidArgument(fmt::format("its version is {}; 1 to 3 are read", version));
  const std::size_t size = version == 1 ? 2 : 4, begin = kLength + size;
  if (bytes.size() < begin) throw InvalidArgument("it is cut off");
  const std::uint64_t length = WholeOf(bytes.data() + kLength, size, false);
  if (length > bytes.size() - begin) throw InvalidArgument("it is cut off");
  head = HeadReader(std::string_view(bytes).substr(begin, length)).Run();
  return begin + length;
}

}  // namespace

std::size_t NpyArray::width() const {
  std::size_t width = 1;
  for (std::size_t axis = 1; axis < shape.size(); ++axis) width *= shape[axis];
  return width;
}

NpyArray ParseNpy(const std::string& bytes) {
  NpyHead head;
  const std::size_t begin = ReadHead(bytes, head);
  const ElementType type = TypeOf(head.kind);
  constexpr std::size_t kMostAxes = 8;
  if (head.shape.size() > kMostAxes) throw InvalidArgument("it has more than 8 axes");
  std::size_t count = 1;
  for (const std::size_t size : head.shape) {
    if (size != 0 && count > std::numeric_limits<std::size_t>::max() / size / std::max<std::size_t>(1, type.size))
      throw InvalidArgument("it is too large");
    count *= size;
  }
  if (count * type.size != bytes.size() - begin)
    throw InvalidArgument(
        fmt::format("it has {} bytes of data, but its shape needs {}", bytes.size() - begin, count * type.size));
  NpyArray array{head.shape, {}, {}, type.kind == 'U' || type.kind == 'S'};
  constexpr std::size_t kMostTexts = 100'000;
  if (array.has_texts && count > kMostTexts) throw InvalidArgument("it has too many texts");
  array.has_texts ? array.texts.reserve(count) : array.numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const char* const element = bytes.data() + begin + type.size * (head.fortran ? FortranIndex(i, head.shape) : i);
    if (array.has_texts) {
      array.texts.push_back(TextOf(type.kind, element, type.size, type.big));
    } else {
      array.numbers.push_back(NumberOf(type.kind, element, type.size, type.big));
    }
  }
  return array;
}

}  // namespace gaitwright
