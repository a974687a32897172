// SPDX-License-Identifier: BSD-3-Clause
// Messages of a shell process in place of a browser.
#include <gtest/gtest.h>

#include "workflows/render/devtools_pipe_internal.h"

namespace gaitwright {
namespace {

using PipeJson = nlohmann::ordered_json;

Result<DevtoolsPipe> ShellThat(const std::string& script) { return DevtoolsPipe::Start("/bin/sh", {"-c", script}); }

void ExpectBroken(const Result<PipeJson>& received, const std::string& part) {
  ASSERT_FALSE(received.ok());
  EXPECT_EQ(received.failure().code, FailureCode::kBrowserGone);
  EXPECT_NE(received.failure().message.find(part), std::string::npos) << received.failure().message;
}

TEST(DevtoolsPipe, AMessageComesBackAsItWasSent) {
  Result<DevtoolsPipe> pipe = ShellThat("cat <&3 >&4");
  ASSERT_TRUE(pipe.ok()) << pipe.failure().message;
  for (const PipeJson& message : {PipeJson{{"id", 1}, {"method", "Page.enable"}}, PipeJson{{"text", "größer"}}}) {
    ASSERT_TRUE(pipe->Send(message).ok());
    const Result<PipeJson> back = pipe->Receive(10.0);
    ASSERT_TRUE(back.ok()) << back.failure().message;
    EXPECT_EQ(*back, message);
  }
}

TEST(DevtoolsPipe, MessagesThatComeAtOnceAreTakenOneByOne) {
  Result<DevtoolsPipe> pipe = ShellThat("printf '{\"a\": 1}\\0{\"a\": 2}\\0' >&4; cat <&3 >/dev/null");
  ASSERT_TRUE(pipe.ok()) << pipe.failure().message;
  EXPECT_EQ(pipe->Receive(10.0).value()["a"], 1);
  EXPECT_EQ(pipe->Receive(10.0).value()["a"], 2);
}

TEST(DevtoolsPipe, AMessageInPiecesIsWaitedFor) {
  Result<DevtoolsPipe> pipe = ShellThat("printf '{\"a\"' >&4; sleep 0.05; printf ': 3}\\0' >&4; cat <&3 >/dev/null");
  ASSERT_TRUE(pipe.ok()) << pipe.failure().message;
  EXPECT_EQ(pipe->Receive(10.0).value()["a"], 3);
}

TEST(DevtoolsPipe, InvalidJsonAnEndAndSilenceAreReported) {
  Result<DevtoolsPipe> words = ShellThat("printf 'hello\\0' >&4; cat <&3 >/dev/null");
  ExpectBroken(words->Receive(10.0), "not JSON");
  Result<DevtoolsPipe> ended = ShellThat("exit 0");
  ExpectBroken(ended->Receive(10.0), "has ended");
  Result<DevtoolsPipe> silent = ShellThat("cat <&3 >/dev/null");
  ExpectBroken(silent->Receive(0.02), "did not answer");
}

TEST(DevtoolsPipe, AProgramThatIsNotThereIsNamed) {
  const Result<DevtoolsPipe> pipe = DevtoolsPipe::Start("/nowhere/browser", {});
  ASSERT_FALSE(pipe.ok());
  EXPECT_EQ(pipe.failure().code, FailureCode::kBrowserGone);
  EXPECT_NE(pipe.failure().message.find("'/nowhere/browser' cannot be started"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
