// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/docstrings.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/built_paths.h"

namespace gaitwright::architecture {
namespace {

using Names = std::vector<std::string>;

TEST(Docstrings, AreMissedWhereTheyAreMissing) {
  const std::string header = R"(#pragma once
namespace a {
struct Bare {
  double x = 0.0;
  std::vector<int> list = {};
};
/// Has one.
struct Told {
  explicit Told(int n) : n_(n) {}
  Fields Fields() { return {{"x", &x, "1", 0.0, 1.0, "Braces { in words.", {}}}; }
  void Silent();
  int size() const { return 0; }
  bool operator==(const Told&) const = default;
  enum class Kind { kOne, kTwo };
};

/// One.
void First(int a, const Told& b = {});
void OfItsGroup();

void Second(std::function<void(int)> call = [](int) {}, int more = 0);
constexpr double kValue = Halved(2.0);
template <class T>
T Third(T t);
class Later;
}
)";
  EXPECT_EQ(WithoutDocstring(header), (Names{"3: struct Bare", "11: Told::Silent", "21: Second", "23: Third"}));
}

TEST(Docstrings, OfClassesArePublicPartsOnly) {
  const std::string header = R"(namespace a {
/// Has one.
class Walker final : public Base {
 public:
  Walker();
  ~Walker() override;
  int Update(int) override;
  void Push();

  /// Words.
  void Pull();

 private:
  struct Inner {
    void Hidden();
  };
  void Own();
};

namespace {
void Helper();
}
}
)";
  EXPECT_EQ(WithoutDocstring(header), Names{"8: Walker::Push"});
}

TEST(Docstrings, StandAboveAllThatIsPublic) {
  namespace fs = std::filesystem;
  int headers = 0;
  for (const std::string room : {"kinematics", "planning", "optimisation", "playback", "workflows"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SourceFolder()) / room)) {
      const std::string name = entry.path().filename().string();
      if (!name.ends_with(".h") || name.ends_with("_internal.h")) continue;
      ++headers;
      std::ifstream stream(entry.path());
      for (const std::string& missing : WithoutDocstring({std::istreambuf_iterator<char>(stream), {}}))
        ADD_FAILURE() << fs::relative(entry.path(), SourceFolder()).string() << ":" << missing;
    }
  }
  EXPECT_GT(headers, 50);
}

}  // namespace
}  // namespace gaitwright::architecture
