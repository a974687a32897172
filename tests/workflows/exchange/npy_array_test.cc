// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>

#include "kinematics/base/result.h"
#include "workflows/exchange/export_npz.h"
#include "workflows/exchange/npy_array_internal.h"
#include "workflows/exchange/read_zip_internal.h"

namespace gaitwright {
namespace {

/// What numpy.savez_compressed of NumPy 1.24 wrote for
///   x = np.array([[1.5, 2.5], [3.5, -4.5]], dtype='<f4', order='F'), n = np.array(['left', 'grün']),
///   k = np.array(7, dtype='>i2')
std::string OfNumPy() {
  constexpr const char* kHex =
      "504b030414000000080000002100ef32c4bb540000009000000005001400782e6e707901001000900000000000000054000000000000"
      "009bec17ea1b10c9c850c650ad9e925a9c5ca46ea5a06e9366a2aea3a09e965f54529498179f5f94920a120f292a4d050a17672416a4"
      "02b91a463a0a469a3a0ab50ae4032e068603f60c0c090e0c0c0a403ce10000504b030414000000080000002100ef4b9cd15a000000a0"
      "000000050014006e2e6e707901001000a0000000000000005a000000000000009bec17ea1b10c9c850c650ad9e925a9c5ca46ea5a06e"
      "136aa2aea3a09e965f54529498179f5f94920a12774bcc294e058a17672416a402f91a463a9a3a0ab50a1400ae1c06068654204e03e2"
      "12204e07e22220fe03c479400c00504b0304140000000800000021009f4665e94400000082000000050014006b2e6e70790100100082"
      "0000000000000044000000000000009bec17ea1b10c9c850c650ad9e925a9c5ca46ea5a06e9769a4aea3a09e965f54529498179f5f94"
      "920a12774bcc294e058a17672416a402f91a9a3a0ab50a14012e067600504b0102140314000000080000002100ef32c4bb5400000090"
      "000000050000000000000000000000800100000000782e6e7079504b0102140314000000080000002100ef4b9cd15a000000a0000000"
      "05000000000000000000000080018b0000006e2e6e7079504b01021403140000000800000021009f4665e94400000082000000050000"
      "00000000000000000080011c0100006b2e6e7079504b0506000000000300030099000000970100000000";
  std::string bytes;
  for (const char* c = kHex; *c != '\0'; c += 2) bytes += static_cast<char>(std::stoi(std::string(c, 2), nullptr, 16));
  return bytes;
}

std::string ReasonNoArray(const std::string& bytes) {
  try {
    ParseNpy(bytes);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

/// A `.npy` of version 1 with a dictionary and data.
std::string Npy(const std::string& dictionary, const std::string& data) {
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(dictionary.size());
  bytes += '\0';
  return bytes + dictionary + data;
}

TEST(NpyArray, ReadsACompressedArchiveOfNumPy) {
  std::map<std::string, NpyArray> arrays;
  for (const ZipEntry& entry : ReadZip(OfNumPy(), 10000)) arrays[entry.name] = ParseNpy(entry.bytes);
  ASSERT_EQ(arrays.size(), 3U);
  EXPECT_EQ(arrays["x.npy"].numbers, (std::vector<double>{1.5, 2.5, 3.5, -4.5})) << "in C order";
  EXPECT_EQ(arrays["x.npy"].shape, (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(arrays["n.npy"].texts, (std::vector<std::string>{"left", "gr\xc3\xbcn"}));
  EXPECT_EQ(arrays["k.npy"].numbers, (std::vector<double>{7.0})) << "the highest byte first";
  EXPECT_TRUE(arrays["k.npy"].shape.empty());
}

TEST(NpyArray, ReadsBackWhatExportWrites) {
  const NpyArray numbers = ParseNpy(NpyOfNumbers({1.0, -2.5, 3e-300, 4.0, 5.0, 6.0}, {2, 3}));
  EXPECT_EQ(numbers.numbers, (std::vector<double>{1.0, -2.5, 3e-300, 4.0, 5.0, 6.0}));
  EXPECT_EQ(numbers.rows(), 2U);
  EXPECT_EQ(numbers.width(), 3U);
  EXPECT_EQ(ParseNpy(NpyOfTexts({"a", "", "long name"})).texts, (std::vector<std::string>{"a", "", "long name"}));
}

TEST(NpyArray, ReadsWholeNumbersAndTruth) {
  const std::string of = "'fortran_order': False, 'shape': (3,), }\n";
  EXPECT_EQ(ParseNpy(Npy("{'descr': '|i1', " + of, "\x01\xff\x80")).numbers, (std::vector<double>{1, -1, -128}));
  EXPECT_EQ(ParseNpy(Npy("{'descr': '|u1', " + of, "\x01\xff\x80")).numbers, (std::vector<double>{1, 255, 128}));
  EXPECT_EQ(ParseNpy(Npy("{'descr': '|b1', " + of, std::string("\x01\x00\x01", 3))).numbers,
            (std::vector<double>{1, 0, 1}));
  EXPECT_EQ(ParseNpy(Npy("{'descr': '|S1', " + of, "abc")).texts, (std::vector<std::string>{"a", "b", "c"}));
}

TEST(NpyArray, SaysWhyItRefuses) {
  const auto of = [](const std::string& kind, const std::string& shape) {
    return "{'descr': " + kind + ", 'fortran_order': False, 'shape': " + shape + ", }\n";
  };
  EXPECT_EQ(ReasonNoArray("PK"), "it is not an array of NumPy");
  EXPECT_NE(ReasonNoArray(Npy(of("'|O'", "(1,)"), "x")).find("Python objects"), std::string::npos);
  EXPECT_NE(ReasonNoArray(Npy(of("[('x', '<f8')]", "(1,)"), "x")).find("records"), std::string::npos);
  EXPECT_EQ(ReasonNoArray(Npy(of("'<c16'", "(1,)"), std::string(16, 'x'))), "elements of type '<c16' are not read");
  EXPECT_EQ(ReasonNoArray(Npy(of("'<f8'", "(2,)"), std::string(8, 'x'))),
            "it has 8 bytes of data, but its shape needs 16");
  EXPECT_EQ(ReasonNoArray(Npy(of("'<f8'", "(4294967296, 4294967296)"), "")), "it is too large");
  EXPECT_EQ(ReasonNoArray(Npy(of("'<U1'", "(1,)"), "\xff\xff\xff\xff")), "a text in it is not valid Unicode");
  EXPECT_EQ(ReasonNoArray(Npy("{'descr': '<f8'}", "")), "its head is not one that NumPy writes");
  std::string cut = NpyOfNumbers({1.0}, {1});
  cut.resize(9);
  EXPECT_EQ(ReasonNoArray(cut), "it is not an array of NumPy");
}

TEST(ReadZip, SaysWhyItRefuses) {
  const auto why = [](const std::string& bytes, std::size_t most) {
    try {
      ReadZip(bytes, most);
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string good = OfNumPy();
  EXPECT_EQ(why("", 100), "it is not a ZIP archive, or is cut off");
  EXPECT_EQ(why(good.substr(0, good.size() - 30), 10000), "it is not a ZIP archive, or is cut off");
  EXPECT_EQ(why(good, 100), "the archive is too large: its files have more than 100 bytes");
  std::string damaged = StoredZip({{"a.txt", "some words"}});
  damaged[damaged.find("words")] = 'W';
  EXPECT_NE(why(damaged, 100).find("file 'a.txt' of the archive is damaged"), std::string::npos);
  const std::vector<ZipEntry> read = ReadZip(StoredZip({{"b", "1"}, {"a", ""}}), 100);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].name, "b");
  EXPECT_EQ(read[0].bytes, "1");
  EXPECT_EQ(read[1].bytes, "");
}

}  // namespace
}  // namespace gaitwright
