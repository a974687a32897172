// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/render/chromium.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "tests/workflows/render/shared_browser.h"

namespace gaitwright {
namespace {

std::unique_ptr<Chromium> Started(const ChromiumOptions& options = {}) {
  Result<std::unique_ptr<Chromium>> browser = Chromium::Start(options);
  EXPECT_TRUE(browser.ok()) << browser.failure().message;
  return std::move(*browser);
}

TEST(Chromium, EvaluatesAndWaitsForPromises) {
  Chromium& browser = SharedBrowser();
  EXPECT_EQ(browser.Evaluate("6 * 7").value(), "42");
  EXPECT_EQ(browser.Evaluate("new Promise((done) => setTimeout(() => done({a: 'b'}), 20))").value(), "{\"a\":\"b\"}");
  EXPECT_EQ(browser.Evaluate("undefined").value(), "null");
}

TEST(Chromium, TellsWhatWentWrong) {
  const auto browser = Started();
  const Result<std::string> thrown = browser->Evaluate("(() => { throw new Error('too short'); })()");
  ASSERT_FALSE(thrown.ok());
  EXPECT_NE(thrown.failure().message.find("too short"), std::string::npos);
  EXPECT_FALSE(browser->Open(FileUrl("/no/such/page.html")).ok());
  EXPECT_TRUE(browser->complaints().empty());
  ASSERT_TRUE(browser->Evaluate("console.error('a complaint')").ok());
  ASSERT_TRUE(browser->Evaluate("0").ok());
  ASSERT_EQ(browser->complaints().size(), 1U);
  EXPECT_NE(browser->complaints()[0].find("a complaint"), std::string::npos);
  ASSERT_TRUE(browser->Open("about:blank").ok());
  EXPECT_TRUE(browser->complaints().empty()) << "they were of the page before";
}

TEST(Chromium, TakesPicturesOfItsSize) {
  const auto browser = Started({.width_px = 320, .height_px = 200});
  const std::string png = browser->Png().value();
  ASSERT_GT(png.size(), 33U);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(png[at + i]);
    return value;
  };
  EXPECT_EQ(number(16), 320);
  EXPECT_EQ(number(20), 200);
}

TEST(Chromium, LeavesNothingBehind) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("gaitwright-chromium-test-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const char* usual = std::getenv("TMPDIR");
  const std::string before = usual == nullptr ? "" : usual;
  setenv("TMPDIR", folder.c_str(), 1);
  {
    const auto browser = Started();
    EXPECT_FALSE(std::filesystem::is_empty(folder)) << "its profile";
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  before.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", before.c_str(), 1);
  std::filesystem::remove_all(folder);
}

TEST(Chromium, WithoutABrowserSaysWhatToDo) {
  const Result<std::unique_ptr<Chromium>> none = Chromium::Start({.program = "/no/such/browser"});
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.failure().message.find("/no/such/browser"), std::string::npos);
}

TEST(FileUrl, EscapesWhatAUrlMayNotHave) { EXPECT_EQ(FileUrl("/a b/ü#1.html"), "file:///a%20b/%C3%BC%231.html"); }

}  // namespace
}  // namespace gaitwright
