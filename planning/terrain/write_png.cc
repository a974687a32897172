// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/write_png.h"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstdint>
#include <utility>
#include <vector>

namespace gaitwright {
namespace {

void KeepWriterMessage(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}

void PassOverWarning(png_structp, png_const_charp) {}

/// libpng's structures and the written bytes. libpng leaves its functions by longjmp on an error, so every object with
/// a destructor must live here, outside of these functions.
struct PngWriting {
  PngWriting()
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, KeepWriterMessage, PassOverWarning)),
        info(png_create_info_struct(png)) {}
  PngWriting(const PngWriting&) = delete;
  PngWriting& operator=(const PngWriting&) = delete;
  ~PngWriting() { png_destroy_write_struct(&png, &info); }

  std::string error, file;
  png_structp png;
  png_infop info;
  std::vector<png_byte> bytes;
  std::vector<png_bytep> rows;
};

void KeepBytes(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<PngWriting*>(png_get_io_ptr(png))->file.append(reinterpret_cast<const char*>(bytes), count);
}

void FlushNothing(png_structp) {}

/// The rows in PNG order: high byte first.
void FillRows(const GreyImage& image, PngWriting& writing) {
  const bool wide = image.full == 65535;
  for (const std::uint16_t value : image.values) {
    if (wide) writing.bytes.push_back(static_cast<png_byte>(value >> 8U));
    writing.bytes.push_back(static_cast<png_byte>(value & 255U));
  }
  const std::size_t length = static_cast<std::size_t>(image.columns) * (wide ? 2 : 1);
  for (int row = 0; row < image.rows; ++row)
    writing.rows.push_back(&writing.bytes[length * static_cast<std::size_t>(row)]);
}

bool WritePicture(const GreyImage& image, PngWriting& writing) {
  if (setjmp(png_jmpbuf(writing.png)) != 0) return false;
  png_set_write_fn(writing.png, &writing, KeepBytes, FlushNothing);
  png_set_IHDR(writing.png, writing.info, static_cast<png_uint_32>(image.columns), static_cast<png_uint_32>(image.rows),
               image.full == 65535 ? 16 : 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(writing.png, writing.info);
  png_write_image(writing.png, writing.rows.data());
  png_write_end(writing.png, nullptr);
  return true;
}

}  // namespace

Result<std::string> WriteGreyPng(const GreyImage& image) {
  if (image.full != 255 && image.full != 65535)
    throw InvalidArgument(fmt::format("white is {}; it must be 255 or 65535", image.full));
  const auto points = static_cast<double>(image.columns) * image.rows;
  if (image.columns < 1 || image.rows < 1 || static_cast<double>(image.values.size()) != points) {
    throw InvalidArgument(fmt::format("a picture of {} by {} points has {} values; one value per point is needed",
                                      image.columns, image.rows, image.values.size()));
  }
  PngWriting writing;
  FillRows(image, writing);
  if (WritePicture(image, writing)) return std::move(writing.file);
  return Failure{FailureKind::kBadInput,
                 FailureCode::kInternal,
                 "WriteGreyPng",
                 fmt::format("a picture of {} by {} points cannot be written as PNG: {}", image.columns, image.rows,
                             writing.error),
                 {}};
}

}  // namespace gaitwright
