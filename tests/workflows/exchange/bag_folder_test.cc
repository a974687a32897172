// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>

#include "tests/scratch_folder.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/packed_bytes_internal.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/exchange/recorded_motion_internal.h"

namespace gaitwright {
namespace {

using namespace synthetic;

/// A folder with a description and these files.
std::string BagOf(const std::string& description, const std::map<std::string, std::string>& files) {
  const std::filesystem::path folder = ScratchFile("bag");
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "metadata.yaml") << description;
  for (const auto& [name, bytes] : files) std::ofstream(folder / name, std::ios::binary) << bytes;
  return folder.string();
}

std::string Description(const std::string& more) {
  return "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n" + more;
}

std::string ReasonNoBag(const std::string& description, const std::map<std::string, std::string>& files = {}) {
  const auto read = ReadBagFolder(BagOf(description, files));
  return read.ok() ? "" : read.failure().message;
}

TEST(BagFolder, ReadsItsFilesInTheirOrder) {
  const std::string one = McapHead(), two = McapHead() + McapTail();
  const std::string folder =
      BagOf(Description("  relative_file_paths: [old/place/b.mcap, a.mcap]\n"), {{"a.mcap", two}, {"b.mcap", one}});
  EXPECT_TRUE(IsBagFolder(folder));
  const auto files = ReadBagFolder(folder);
  ASSERT_TRUE(files.ok()) << files.failure().message;
  EXPECT_EQ(*files, (std::vector<std::string>{one, two}));
  ImportRequest request;
  request.file = folder;
  const auto text = ReadMotionText(request);
  ASSERT_TRUE(text.ok()) << text.failure().message;
  EXPECT_EQ(text->form, MotionForm::kRecording);
  EXPECT_EQ(text->text, one);
  EXPECT_EQ(text->further, std::vector<std::string>{two});
  EXPECT_NE(text->Hash(), (MotionText{one, MotionForm::kRecording, {}}.Hash()));
}

TEST(BagFolder, UnpacksFilesThatArePackedAsAWhole) {
  const std::string more =
      "  compression_format: zstd\n  compression_mode: FILE\n  relative_file_paths: [a.mcap.zstd]\n";
  const auto files = ReadBagFolder(BagOf(Description(more), {{"a.mcap.zstd", PackedZstd(McapHead())}}));
  ASSERT_TRUE(files.ok()) << files.failure().message;
  EXPECT_EQ(files->front(), McapHead());
  EXPECT_NE(ReasonNoBag(Description(more), {{"a.mcap.zstd", McapHead()}}).find("are damaged"), std::string::npos);
}

TEST(BagFolder, LeavesMessagesPacked) {
  const std::string more = "  compression_format: zstd\n  compression_mode: MESSAGE\n  relative_file_paths: [a.mcap]\n";
  const auto files = ReadBagFolder(BagOf(Description(more), {{"a.mcap", McapHead()}}));
  ASSERT_TRUE(files.ok()) << files.failure().message;
  EXPECT_EQ(files->front(), McapHead());
}

TEST(BagFolder, RefusesOthersWithTheLine) {
  EXPECT_FALSE(IsBagFolder(BagOf("other: 1\n", {})));
  EXPECT_FALSE(IsBagFolder(ScratchFile("none")));
  EXPECT_NE(ReasonNoBag("rosbag2_bagfile_information: 3\n").find("it has no map"), std::string::npos);
  EXPECT_NE(
      ReasonNoBag("rosbag2_bagfile_information: {storage_identifier: bag_v2}\n").find("line 1: the storage 'bag_v2'"),
      std::string::npos);
  EXPECT_NE(ReasonNoBag(Description("")).find("lacks 'relative_file_paths'"), std::string::npos);
  EXPECT_NE(ReasonNoBag(Description("  relative_file_paths: []\n")).find("line 4: relative_file_paths is empty"),
            std::string::npos);
  const std::string other = "  compression_format: lz4\n  compression_mode: FILE\n  relative_file_paths: [a]\n";
  EXPECT_NE(ReasonNoBag(Description(other)).find("'ros2 bag convert'"), std::string::npos);
  EXPECT_NE(ReasonNoBag(Description("  relative_file_paths: [a]\n")).find("bag/a"), std::string::npos)
      << "no such file";
  EXPECT_NE(ReasonNoBag(Description("  relative_file_paths: [a]\n"), {{"a", "text"}}).find("neither an MCAP file"),
            std::string::npos);
  EXPECT_NE(ReasonNoBag(Description("  a: [\n")).find("line "), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
