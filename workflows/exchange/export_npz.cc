// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/export_npz.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "kinematics/base/result.h"
#include "workflows/exchange/stored_zip.h"

namespace gaitwright {
namespace {

template <class Whole>
void AppendLittle(Whole value, std::string& bytes) {
  for (std::size_t i = 0; i < sizeof(Whole); ++i) bytes += static_cast<char>(value >> (8U * i) & 0xffU);
}

std::string ShapeText(const std::vector<std::size_t>& shape) {
  if (shape.size() == 1) return fmt::format("({},)", shape[0]);
  return fmt::format("({})", fmt::join(shape, ", "));
}

/// Magic, version, length, and the dictionary, padded so that the data begin at a multiple of 64 bytes.
std::string NpyHead(const std::string& kind, const std::vector<std::size_t>& shape) {
  std::string words = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", kind, ShapeText(shape));
  constexpr std::size_t kBefore = 10, kMultiple = 64;
  words.append(kMultiple - (kBefore + words.size() + 1) % kMultiple, ' ');
  words += '\n';
  std::string head("\x93NUMPY\x01\x00", 8);
  AppendLittle(static_cast<std::uint16_t>(words.size()), head);
  return head + words;
}

/// The code points of a text in UTF-8.
std::u32string CodePoints(const std::string& text) {
  std::u32string points;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int more = lead < 0x80U ? 0 : lead >= 0xf0U ? 3 : lead >= 0xe0U ? 2 : lead >= 0xc0U ? 1 : -1;
    if (more < 0 || i + static_cast<std::size_t>(more) >= text.size())
      throw InvalidArgument(fmt::format("the name '{}' is not valid UTF-8", text));
    char32_t point = more == 0 ? lead : lead & (0x3fU >> static_cast<unsigned>(more));
    for (int k = 0; k < more; ++k) point = point << 6U | (static_cast<unsigned char>(text[++i]) & 0x3fU);
    points += point;
    ++i;
  }
  return points;
}

void CheckFinite(const std::string& name, const std::vector<double>& values) {
  const auto bad = std::find_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); });
  if (bad == values.end()) return;
  throw InvalidArgument(
      fmt::format("number {} of array '{}' is {}; only finite numbers are exported", bad - values.begin(), name, *bad));
}

/// Collects the arrays of a motion.
class Arrays {
 public:
  explicit Arrays(std::size_t rows) : rows_(rows) {}

  /// Adds an array; `row(k)` returns a vector of `width` numbers.
  template <class Row>
  void Add(const std::string& name, std::size_t width, Row row, std::vector<std::size_t> shape = {}) {
    std::vector<double> values;
    values.reserve(rows_ * width);
    for (std::size_t k = 0; k < rows_; ++k) {
      const VectorX one = row(k);
      values.insert(values.end(), one.data(), one.data() + one.size());
    }
    CheckFinite(name, values);
    if (shape.empty()) shape = {rows_, width};
    entries_.push_back({name + ".npy", NpyOfNumbers(values, shape)});
  }
  void AddTexts(const std::string& name, const std::vector<std::string>& texts) {
    entries_.push_back({name + ".npy", NpyOfTexts(texts)});
  }

  std::string Zip() const { return StoredZip(entries_); }

 private:
  std::size_t rows_;
  std::vector<ZipEntry> entries_;
};

VectorX WrenchRow(const std::vector<ContactWrench>& wrenches, std::size_t feet) {
  VectorX row = VectorX::Zero(6 * static_cast<Eigen::Index>(feet));
  for (std::size_t f = 0; f < wrenches.size(); ++f) {
    row.segment<6>(6 * static_cast<Eigen::Index>(f)) << wrenches[f].force_W, wrenches[f].moment_W;
  }
  return row;
}

VectorX ContactRow(FootSet contact, std::size_t feet) {
  VectorX row(static_cast<Eigen::Index>(feet));
  for (Eigen::Index f = 0; f < row.size(); ++f) row[f] = Contains(contact, static_cast<int>(f)) ? 1.0 : 0.0;
  return row;
}

}  // namespace

std::string NpyOfNumbers(const std::vector<double>& values, const std::vector<std::size_t>& shape) {
  const std::size_t count = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
  if (count != values.size()) {
    throw InvalidArgument(
        fmt::format("an array of shape {} needs {} numbers, not {}", ShapeText(shape), count, values.size()));
  }
  std::string bytes = NpyHead("<f8", shape);
  bytes.reserve(bytes.size() + 8 * values.size());
  for (const double value : values) AppendLittle(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value), bytes);
  return bytes;
}

std::string NpyOfTexts(const std::vector<std::string>& texts) {
  std::vector<std::u32string> all;
  std::size_t width = 1;
  for (const std::string& text : texts) {
    all.push_back(CodePoints(text));
    width = std::max(width, all.back().size());
  }
  std::string bytes = NpyHead(fmt::format("<U{}", width), {texts.size()});
  for (std::u32string& text : all) {
    text.resize(width);
    for (const char32_t point : text) AppendLittle(static_cast<std::uint32_t>(point), bytes);
  }
  return bytes;
}

std::string MotionNpz(const RobotModel& model, const MotionRows& rows) {
  const auto n = static_cast<std::size_t>(model.num_dofs());
  const std::size_t feet = model.feet.size(), count = rows.time_s.size();
  Arrays arrays(count);
  arrays.Add("time_s", 1, [&](std::size_t k) { return VectorX::Constant(1, rows.time_s[k]); }, {count});
  arrays.Add("q", 7 + n, [&](std::size_t k) { return rows.q[k]; });
  arrays.Add("v", 6 + n, [&](std::size_t k) { return rows.v[k]; });
  if (!rows.a.empty()) arrays.Add("a", 6 + n, [&](std::size_t k) { return rows.a[k]; });
  if (!rows.tau.empty()) arrays.Add("tau", n, [&](std::size_t k) { return rows.tau[k]; });
  if (!rows.contact.empty())
    arrays.Add("contact", feet, [&](std::size_t k) { return ContactRow(rows.contact[k], feet); });
  if (!rows.wrenches.empty()) {
    arrays.Add("contact_wrench", 6 * feet, [&](std::size_t k) { return WrenchRow(rows.wrenches[k], feet); },
               {count, feet, 6});
  }
  arrays.Add("base_position_m", 3, [&](std::size_t k) { return rows.q[k].head<3>(); });
  arrays.Add("base_quaternion_xyzw", 4, [&](std::size_t k) { return rows.q[k].segment<4>(3); });
  arrays.Add("base_velocity_m_s", 3, [&](std::size_t k) { return rows.v[k].head<3>(); });
  arrays.Add("base_angular_velocity_rad_s", 3, [&](std::size_t k) { return rows.v[k].segment<3>(3); });
  arrays.AddTexts("joint_names", model.dof_names);
  std::vector<std::string> links;
  for (const Foot& foot : model.feet) links.push_back(foot.link);
  arrays.AddTexts("foot_names", links);
  arrays.AddTexts("robot", {model.name});
  return arrays.Zip();
}

}  // namespace gaitwright
