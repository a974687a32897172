// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>

#include "tests/cli/stranger.h"
#include "tests/workflows/live/socket_client.h"

namespace gaitwright::cli {
namespace {

/// A port that is free at present.
int FreePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  EXPECT_EQ(::bind(socket, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size), 0);
  ::close(socket);
  return ntohs(address.sin_port);
}

/// The first message over the WebSocket, returned after some frames were received; "" while there is no server.
std::string Greeting(int port) {
  const std::string host = "127.0.0.1:" + std::to_string(port);
  try {
    SocketClient client(port);
    if (client.Open("/live", "http://" + host, host) != 101) return "";
    std::string greeting = client.Hear().value_or("");
    for (int heard = 0; heard < 10; ++heard) client.Hear();  // the page number, and frames of a running world
    return greeting;
  } catch (const std::runtime_error&) {
    return "";
  }
}

class Live : public Stranger {
 protected:
  /// Runs the program until a page has received its greeting, then sends Ctrl-C. @return the results and the greeting.
  std::pair<Ran, Json> Served(std::vector<std::string> flags) const {
    const int port = FreePort();
    std::vector<std::string> words = {"live", "--port", std::to_string(port), "--no-open"};
    words.insert(words.end(), flags.begin(), flags.end());
    std::string greeting;
    const Ran ran = RunUntil(words, SIGINT, [&] { return !(greeting = Greeting(port)).empty(); });
    return {ran, Json::parse(greeting)};
  }
};

TEST_F(Live, ServesUntilCtrlC) {
  const auto [ran, greeting] = Served({"--robot", "a1", "--json", "--debug", "--set", "gains.stiffness_scale=1.25"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.json()["url"].get<std::string>().substr(0, 17), "http://127.0.0.1:") << ran.out;
  EXPECT_EQ(greeting["scene"]["robot"]["name"], "a1");
  EXPECT_EQ(greeting["options"]["gains.stiffness_scale"]["value"], 1.25);
  EXPECT_NE(ran.err.find("planning the first walk of a1"), std::string::npos);
  EXPECT_NE(ran.err.find("touching"), std::string::npos) << "--debug tells of contacts: " << ran.err;
}

TEST_F(Live, EndsAfterATimeAndTakesOptionsFromAFile) {
  Write("o.yaml", "gains.stiffness_scale: 1.5\n");
  const Ran ran = Run({"live", "--port", "0", "--no-open", "--for", "0.3", "--options", "o.yaml", "--quiet"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(ran.out.starts_with("http://127.0.0.1:") && ran.out.ends_with("/\n")) << ran.out;
  const auto [served, greeting] = Served({"--options", "o.yaml", "--quiet"});
  EXPECT_EQ(served.status, 0);
  EXPECT_EQ(greeting["options"]["gains.stiffness_scale"]["value"], 1.5);
}

TEST_F(Live, ListeningEverywhereItNamesAnAddressToGoTo) {
  const Ran ran = Run({"live", "--host", "0.0.0.0", "--port", "0", "--no-open", "--for", "0.1", "--quiet"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(ran.out.starts_with("http://127.0.0.1:")) << ran.out;
}

TEST_F(Live, RefusesWhatItCannotDoBeforeItPlans) {
  const auto refused = [&](std::vector<std::string> flags, const std::vector<std::string>& parts) {
    flags.insert(flags.begin(), {"live", "--no-open"});
    ExpectRefused(Run(flags), 1, parts);
  };
  refused({"--for=-1"}, {"--for is -1 s", "accepted: 0"});
  refused({"--host", "evil.example"}, {"'evil.example' is not an IP address", "127.0.0.1"});
  refused({"--host", "203.0.113.7"}, {"cannot listen on 203.0.113.7", "'ip address'"});
  refused({"--port", "70000"}, {"70000", "65535"});
  refused({"--controller", "pid"}, {"'pid'", "'stabilised'", "'joint-pd'", "'recovering'"});
  refused({"--engine", "both"}, {"'both'", "'bullet'", "'mujoco'"});
  refused({"--set", "play.engine=both"}, {"'both'", "'bullet'", "'mujoco'"});
  refused({"--set", "gains.stifness_scale=1"}, {"gains.stiffness_scale"});
}

}  // namespace
}  // namespace gaitwright::cli
