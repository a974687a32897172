// SPDX-License-Identifier: BSD-3-Clause
// The archives are read here by their published formats, independently of the code that wrote them.
#include "workflows/exchange/export_npz.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"
#include "tests/playback/played.h"
#include "tests/scratch_folder.h"
#include "workflows/exchange/stored_zip.h"

namespace gaitwright {
namespace {

std::uint32_t Little(const std::string& bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + i))) << (8 * i);
  return value;
}

std::uint32_t Crc32(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

/// The files of an archive, from its central directory. PKWARE, APPNOTE.TXT, sections 4.3.7, 4.3.12 and 4.3.16.
std::map<std::string, std::string> Unzipped(const std::string& zip) {
  std::map<std::string, std::string> files;
  const std::size_t end = zip.size() - 22;
  EXPECT_EQ(Little(zip, end, 4), 0x06054b50U);
  std::size_t at = Little(zip, end + 16, 4);
  for (std::uint32_t i = 0; i < Little(zip, end + 10, 2); ++i) {
    EXPECT_EQ(Little(zip, at, 4), 0x02014b50U);
    EXPECT_EQ(Little(zip, at + 10, 2), 0U) << "stored";
    EXPECT_EQ(Little(zip, at + 12, 4), 0x00210000U) << "1980-01-01";
    const std::uint32_t size = Little(zip, at + 24, 4), name = Little(zip, at + 28, 2), local = Little(zip, at + 42, 4);
    EXPECT_EQ(Little(zip, at + 20, 4), size);
    EXPECT_EQ(Little(zip, local, 4), 0x04034b50U);
    const std::size_t data = local + 30 + Little(zip, local + 26, 2) + Little(zip, local + 28, 2);
    const std::string bytes = zip.substr(data, size);
    EXPECT_EQ(Little(zip, at + 16, 4), Crc32(bytes));
    EXPECT_EQ(Little(zip, local + 14, 4), Crc32(bytes)) << "in the local header too";
    files[zip.substr(at + 46, name)] = bytes;
    at += 46 + name + Little(zip, at + 30, 2) + Little(zip, at + 32, 2);
  }
  return files;
}

/// An array of a `.npy` of version 1.0.
struct Npy {
  std::string head;
  std::string data;

  explicit Npy(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t length = Little(bytes, 8, 2);
    EXPECT_EQ((10 + length) % 64, 0U) << "aligned";
    head = bytes.substr(10, length);
    EXPECT_EQ(head.back(), '\n');
    head.erase(head.find_last_not_of(" \n") + 1);
    data = bytes.substr(10 + length);
  }

  double Number(std::size_t i) const {
    const std::uint64_t bits = Little(data, 8 * i, 4) | static_cast<std::uint64_t>(Little(data, 8 * i + 4, 4)) << 32U;
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
};

synthetic::Played ShortWalker() { return synthetic::Walked(2, {.count = 2}); }

TEST(MotionNpzArchive, HoldsEveryRowExactly) {
  const synthetic::Played walker = ShortWalker();
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 500.0);
  const std::string npz = MotionNpz(walker.model, rows);
  EXPECT_TRUE(npz == MotionNpz(walker.model, rows)) << "the same bytes again";
  const auto files = Unzipped(npz);
  EXPECT_EQ(files.size(), 14U);
  const std::size_t n = rows.time_s.size();
  const Npy time(files.at("time_s.npy")), q(files.at("q.npy")), tau(files.at("tau.npy")),
      contact(files.at("contact.npy"));
  EXPECT_EQ(time.head, "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(n) + ",), }");
  EXPECT_EQ(q.head, "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(n) + ", 13), }");
  ASSERT_EQ(q.data.size(), 8 * 13 * n);
  for (std::size_t k = 0; k < n; ++k) {
    ASSERT_EQ(time.Number(k), rows.time_s[k]);
    for (std::size_t i = 0; i < 13; ++i) ASSERT_EQ(q.Number(13 * k + i), rows.q[k][static_cast<Eigen::Index>(i)]);
    for (std::size_t i = 0; i < 6; ++i) ASSERT_EQ(tau.Number(6 * k + i), rows.tau[k][static_cast<Eigen::Index>(i)]);
    for (int f = 0; f < 2; ++f)
      ASSERT_EQ(contact.Number(2 * k + static_cast<std::size_t>(f)), Contains(rows.contact[k], f) ? 1.0 : 0.0);
  }
  const Npy wrench(files.at("contact_wrench.npy"));
  EXPECT_TRUE(synthetic::Says(wrench.head, "'shape': (" + std::to_string(n) + ", 2, 6)")) << wrench.head;
  EXPECT_EQ(wrench.Number(6 * 2 * 7 + 8), rows.wrenches[7][1].force_W.z());
}

TEST(MotionNpzArchive, NamesAreTextsOfOneWidth) {
  const Npy names(NpyOfTexts({"hip", "kn\xc3\xa9\xe2\x82\xac", ""}));
  EXPECT_EQ(names.head, "{'descr': '<U4', 'fortran_order': False, 'shape': (3,), }");
  ASSERT_EQ(names.data.size(), 4U * 4U * 3U);
  EXPECT_EQ(Little(names.data, 0, 4), 'h');
  EXPECT_EQ(Little(names.data, 12, 4), 0U) << "filled up with nothing";
  EXPECT_EQ(Little(names.data, 16 + 8, 4), 0xe9U);
  EXPECT_EQ(Little(names.data, 16 + 12, 4), 0x20acU);
  EXPECT_THROW(NpyOfTexts({"\x80"}), InvalidArgument);
  EXPECT_THROW(NpyOfNumbers({1.0, 2.0}, {3}), InvalidArgument);
}

TEST(MotionNpzArchive, OfALogHasNoAccelerations) {
  const synthetic::Played walker = ShortWalker();
  const auto files = Unzipped(MotionNpz(walker.model, RowsOfLog(walker.model, walker.log, 200.0)));
  EXPECT_EQ(files.count("a.npy"), 0U);
  EXPECT_EQ(files.count("tau.npy"), 1U);
}

TEST(StoredZip, RefusesNamesThatDoNotDo) {
  EXPECT_THROW(StoredZip({{"a", "1"}, {"a", "2"}}), InvalidArgument);
  EXPECT_THROW(StoredZip({{"", "1"}}), InvalidArgument);
  EXPECT_EQ(Unzipped(StoredZip({{"a", "one"}, {"b/c", ""}})),
            (std::map<std::string, std::string>{{"a", "one"}, {"b/c", ""}}));
}

/// A Python that has NumPy: Debian's, or the first on the path; empty without one.
std::string PythonWithNumPy() {
  for (std::string python : {"/usr/bin/python3", "python3"}) {
    if (std::system((python + " -c 'import numpy' >/dev/null 2>&1").c_str()) == 0) return python;
  }
  return "";
}

// NumPy itself must read the archive.
TEST(MotionNpzArchive, IsOpenedByNumPy) {
  const std::string python = PythonWithNumPy();
  ASSERT_NE(python, "") << "NumPy is not installed (Debian: python3-numpy)";
  const synthetic::Played walker = ShortWalker();
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 200.0);
  const std::string file = ScratchFile("numpy.npz");
  ASSERT_TRUE(WriteFileAtomically(file, MotionNpz(walker.model, rows)));
  const std::string script =
      "import numpy, sys\nm = numpy.load(sys.argv[1])\n"
      "assert m[\"q\"].shape == (len(m[\"time_s\"]), 13) and m[\"q\"].dtype == \"<f8\"\n"
      "assert list(m[\"joint_names\"][:2]) == [\"left_x\", \"left_y\"], m[\"joint_names\"]\n"
      "assert (m[\"q\"][:, :3] == m[\"base_position_m\"]).all()\n";
  EXPECT_EQ(std::system((python + " -c '" + script + "' " + file).c_str()), 0);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace gaitwright
