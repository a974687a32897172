// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/read_png.h"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstring>
#include <utility>

#include "kinematics/base/file.h"
#include "planning/terrain/sense.h"

namespace gaitwright {
namespace {

constexpr std::size_t kLargestPicture = std::size_t{64} << 20;  // [byte]

Failure RefusedPng(const std::string& path, const std::string& why) {
  return {FailureKind::kBadInput, FailureCode::kTerrainFile, "ReadGreyPng", fmt::format("'{}' {}", path, why), {}};
}

void KeepMessage(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}

void Ignore(png_structp, png_const_charp) {}

/// libpng's structures and the results. libpng leaves its functions by longjmp if a file is broken, so every object
/// with a destructor must live here, outside of these functions.
struct Reading {
  explicit Reading(std::string bytes_of_file)
      : file(std::move(bytes_of_file)),
        png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &error, KeepMessage, Ignore)),
        info(png_create_info_struct(png)) {}
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }

  std::string error;
  std::string file;
  std::size_t at = 0;  ///< position of the next byte in the file
  png_structp png;
  png_infop info;
  std::vector<png_byte> bytes;
  std::vector<png_bytep> rows;
};

/// Gives libpng the next bytes of the file.
void TakeBytes(png_structp png, png_bytep to, std::size_t count) {
  Reading& reading = *static_cast<Reading*>(png_get_io_ptr(png));
  if (count > reading.file.size() - reading.at) {
    KeepMessage(png, "the file is truncated");
    return;
  }
  std::memcpy(to, reading.file.data() + reading.at, count);
  reading.at += count;
}

bool ReadHead(Reading& reading) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) return false;
  png_set_read_fn(reading.png, &reading, TakeBytes);
  png_read_info(reading.png, reading.info);
  return true;
}

bool ReadRows(Reading& reading) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) return false;
  png_read_image(reading.png, reading.rows.data());
  png_read_end(reading.png, nullptr);
  return true;
}

/// Reason why this kind of picture is not supported; "" if it is.
std::string ReasonRefused(const Reading& reading) {
  const int depth = png_get_bit_depth(reading.png, reading.info);
  const int colour = png_get_color_type(reading.png, reading.info);
  if (colour != PNG_COLOR_TYPE_GRAY)
    return colour == PNG_COLOR_TYPE_GRAY_ALPHA ? "has transparency; it must be grey without transparency"
                                               : "is in colour; it must be grey";
  if (depth != 8 && depth != 16) return fmt::format("has {} bits per point; accepted: 8 or 16", depth);
  const double columns = png_get_image_width(reading.png, reading.info);
  const double rows = png_get_image_height(reading.png, reading.info);
  if (columns * rows > kMostNodes)
    return fmt::format("has {:.0f} by {:.0f} points; at most {} points in all are read", columns, rows, kMostNodes);
  return "";
}

}  // namespace

Result<GreyImage> ReadGreyPng(const std::string& path) {
  Result<std::string> bytes = ReadBytes(path, kLargestPicture);
  if (!bytes) return RefusedPng(path, fmt::format("cannot be read: {}", bytes.failure().message));
  Reading reading(std::move(*bytes));
  if (!ReadHead(reading)) return RefusedPng(path, fmt::format("is not a readable PNG: {}", reading.error));
  const std::string why = ReasonRefused(reading);
  if (!why.empty()) return RefusedPng(path, why);
  GreyImage image;
  image.columns = static_cast<int>(png_get_image_width(reading.png, reading.info));
  image.rows = static_cast<int>(png_get_image_height(reading.png, reading.info));
  const bool wide = png_get_bit_depth(reading.png, reading.info) == 16;
  image.full = wide ? 65535 : 255;
  png_set_interlace_handling(reading.png);
  const std::size_t length = static_cast<std::size_t>(image.columns) * (wide ? 2 : 1);
  reading.bytes.resize(length * static_cast<std::size_t>(image.rows));
  for (int row = 0; row < image.rows; ++row)
    reading.rows.push_back(&reading.bytes[length * static_cast<std::size_t>(row)]);
  if (!ReadRows(reading)) return RefusedPng(path, fmt::format("is broken: {}", reading.error));
  image.values.reserve(static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows));
  for (std::size_t i = 0; i < reading.bytes.size(); i += wide ? 2 : 1) {
    const int value = wide ? 256 * reading.bytes[i] + reading.bytes[i + 1] : reading.bytes[i];
    image.values.push_back(static_cast<std::uint16_t>(value));
  }
  return image;
}

}  // namespace gaitwright
