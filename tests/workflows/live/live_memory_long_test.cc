// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <malloc.h>

#include <thread>

#include "tests/workflows/live/made_world.h"
#include "tests/workflows/live/socket_client.h"
#include "workflows/live/live_session.h"

namespace gaitwright {
namespace {

/// Memory in use on the program's heaps [MB], without freed memory that the allocator keeps (up to 120 MB after plans
/// that were made beside the session).
double Held_mb() {
  const struct mallinfo2 heaps = mallinfo2();
  return 1e-6 * static_cast<double>(heaps.uordblks + heaps.hblkhd);
}

/// Ten minutes of simulated time with two pages, one of which reads nothing. Gait and speed change; the robot is
/// pushed, posed, stood up and reset. The session's clock stands still and each picture is waited for, so that the
/// outcome does not depend on the load of the machine.
TEST(LiveMemory, IsFlatOverTenMinutes) {
  constexpr double kPicture_s = 1.0 / 60.0;
  const RobotModel model = ChooseRobot("a1", "").value();
  const std::unique_ptr<LiveWorld> live = MadeWorld(model);
  const std::unique_ptr<LiveServer> server = std::move(LiveServer::Start({}, "").value());
  server->Greet(LiveGreeting(*live));
  const std::string host = "127.0.0.1:" + std::to_string(server->port());
  SocketClient reads(server->port()), idle(server->port());
  for (SocketClient* page : {&reads, &idle}) ASSERT_EQ(page->Open("/live", "http://" + host, host), 101);
  LiveSession session(*live, *server, {}, [] { return 0.0; });
  const std::vector<std::pair<int, std::string>> says = {
      {60, R"({"do":"pace","gait":"trot","speed_m_s":0.3})"},
      {600, R"({"do":"pace","gait":"trot","speed_m_s":0.6})"},
      {1200, R"({"do":"heading","heading_deg":90})"},
      {1700, R"({"do":"push","force_n":[0,40,0],"for_s":0.1})"},
      {2400, R"({"do":"pace","gait":"bound","speed_m_s":0.5})"},
      {3000, R"({"do":"reset"})"},
      {3060, R"({"do":"pose","q":[0,0,0.5,0,0,0,1,0,0.8,-1.6,0,0.8,-1.6,0,0.8,-1.6,0,0.8,-1.6]})"},
      {3100, R"({"do":"stand_up"})"},
      {3200, R"({"do":"ground","friction":0.7,"slope_deg":1,"slope_direction_deg":0})"}};
  double after_two_minutes = 0.0;
  int walked = 0, heard = 0;
  for (int picture = 0; picture < 36000; ++picture) {
    for (const auto& [at, text] : says) {
      if (picture % 3600 == at) reads.Say(text);
    }
    session.Turn(kPicture_s);
    if (live->wanted() && picture % 60 == 0) live->WaitForPlan();
    if (picture % 4 == 0 && reads.Hear()) {
      do ++heard;
      while (reads.Hear(std::chrono::milliseconds(2)));
    }
    walked += live->mode() == LiveMode::kWalks ? 1 : 0;
    if (picture == 7199) after_two_minutes = Held_mb();
  }
  EXPECT_GT(walked, 18000);
  EXPECT_GE(heard, 9000);
  EXPECT_GT(after_two_minutes, 1.0);
  EXPECT_LT(Held_mb(), after_two_minutes + 1.0) << "MB, from " << after_two_minutes;
}

}  // namespace
}  // namespace gaitwright
