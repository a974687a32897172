// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_server.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "tests/workflows/live/socket_client.h"
#include "workflows/live/live_messages.h"

namespace gaitwright {
namespace {

using std::chrono::milliseconds;

class Server : public testing::Test {
 protected:
  Server() : server_(std::move(LiveServer::Start({}, "<p>the page</p>").value())) { server_->Greet("hello"); }

  std::string host() const { return "127.0.0.1:" + std::to_string(server_->port()); }
  std::string Header() const { return "Host: " + host() + "\r\nConnection: close\r\n"; }
  std::unique_ptr<SocketClient> Opened() const {
    auto client = std::make_unique<SocketClient>(server_->port());
    EXPECT_EQ(client->Open("/live", "http://" + host(), host()), 101);
    EXPECT_EQ(client->Hear(), "hello");
    EXPECT_EQ(client->Hear().value_or("").substr(0, 8), "{\"page\":");
    return client;
  }
  /// Waits for the next message, or for the notice that a page left.
  std::vector<LiveSaying> Taken(bool left = false) const {
    for (int tries = 0; tries < 500; ++tries) {
      std::vector<LiveSaying> taken;
      while (auto saying = server_->Next()) taken.push_back(*saying);
      std::erase_if(taken, [&](const LiveSaying& saying) { return saying.left != left; });
      if (!taken.empty()) return taken;
      std::this_thread::sleep_for(milliseconds(10));
    }
    return {};
  }
  void WaitForPages(int count) const {
    for (int tries = 0; tries < 500 && server_->pages() != count; ++tries)
      std::this_thread::sleep_for(milliseconds(10));
    EXPECT_EQ(server_->pages(), count);
  }

  std::unique_ptr<LiveServer> server_;
};

TEST_F(Server, GivesItsPageAndNothingElse) {
  EXPECT_EQ(server_->url(), "http://" + host() + "/");
  const std::string page = SocketClient(server_->port()).Get("/", Header());
  EXPECT_EQ(page.substr(0, 15), "HTTP/1.1 200 OK") << page;
  EXPECT_NE(page.find("<p>the page</p>"), std::string::npos);
  EXPECT_NE(page.find("X-Content-Type-Options: nosniff"), std::string::npos);
  EXPECT_EQ(SocketClient(server_->port()).Get("/favicon.ico", Header()).substr(9, 3), "204") << "browsers ask for it";
  EXPECT_EQ(SocketClient(server_->port()).Get("/etc/passwd", Header()).substr(9, 3), "404");
  SocketClient poster(server_->port());
  poster.SendRaw("POST / HTTP/1.1\r\nContent-Length: 0\r\n" + Header() + "\r\n");
  EXPECT_EQ(poster.Get("/", Header()).substr(9, 3), "405");
}

TEST_F(Server, IsForItsOwnPagesAlone) {
  SocketClient foreign(server_->port()), renamed(server_->port()), elsewhere(server_->port()), tool(server_->port());
  EXPECT_EQ(foreign.Open("/live", "http://evil.example", host()), 403);
  EXPECT_EQ(renamed.Open("/live", "http://evil.example", "evil.example"), 403) << "a name that was made to lead here";
  EXPECT_EQ(elsewhere.Open("/other", "http://" + host(), host()), 404);
  EXPECT_EQ(tool.Open("/live", "", host()), 101) << "what is no browser names no page";
  EXPECT_EQ(SocketClient(server_->port()).Get("/", "Host: evil.example\r\nConnection: close\r\n").substr(9, 3), "403");
  SocketClient by_name(server_->port());
  const std::string local = "localhost:" + std::to_string(server_->port());
  EXPECT_EQ(by_name.Open("/live", "http://" + local, local), 101);
}

TEST_F(Server, TakesWhatPagesSayAndAnswersTheOneThatSaidIt) {
  const auto one = Opened(), other = Opened();
  other->Say("from the other");
  const auto taken = Taken();
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].text, "from the other");
  server_->Tell(taken[0].page, "for it");
  server_->Tell(taken[0].page + 1000, "for nobody");
  EXPECT_EQ(other->Hear(), "for it");
  EXPECT_EQ(one->Hear(milliseconds(200)), std::nullopt);
  server_->Publish("for all");
  EXPECT_EQ(one->Hear(), "for all");
  EXPECT_EQ(other->Hear(), "for all");
}

TEST(ServerOfAllAddresses, KnowsItsMachineAndAddressesAndNoOtherName) {
  const auto server = std::move(LiveServer::Start({.host = "0.0.0.0"}, "").value());
  const auto status = [&](const std::string& name) {
    const std::string host = name + ":" + std::to_string(server->port());
    return SocketClient(server->port()).Open("/live", "http://" + host, host);
  };
  EXPECT_EQ(status("192.168.7.7"), 101);
  EXPECT_EQ(status("[fe80::1]"), 101);
  EXPECT_EQ(status("localhost"), 101);
  EXPECT_EQ(status("evil.example"), 403) << "a name that was made to lead here";
}

TEST(ServerOfAPort, IsOneThatThereIs) {
  for (const int port : {-1, 65536, 70000}) {
    const auto server = LiveServer::Start({.port = port}, "");
    ASSERT_FALSE(server) << port;
    EXPECT_EQ(server.failure().code, FailureCode::kAddress);
  }
}

TEST_F(Server, PagesThatCameTooEarlyAreGreetedToo) {
  const auto server = std::move(LiveServer::Start({}, "").value());
  SocketClient early(server->port());
  const std::string here = "127.0.0.1:" + std::to_string(server->port());
  EXPECT_EQ(early.Open("/live", "http://" + here, here), 101);
  server->Greet("hello");
  EXPECT_EQ(early.Hear(), "hello");
  EXPECT_EQ(early.Hear(), LivePageNumber(1));
}

TEST_F(Server, TellsWhichPageLeft) {
  auto page = Opened();
  page->Say("here");
  const auto number = Taken()[0].page;
  page.reset();
  const auto taken = Taken(true);
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].page, number);
}

TEST_F(Server, GarbageAndWhatIsTooLongCloseTheirOwnPageAlone) {
  const auto good = Opened(), cut = Opened();
  auto garbage = Opened(), large = Opened();
  garbage->SendRaw(std::string(300, '\xff'));
  EXPECT_EQ(garbage->Hear(), std::nullopt);
  large->Say(std::string(kLongestLiveMessage + 1, 'a'));
  EXPECT_EQ(large->Hear(), std::nullopt);
  cut->SendRaw("\x81");
  SocketClient(server_->port()).SendRaw("no HTTP at all\r\n\r\n");
  SocketClient(server_->port()).SendRaw("GET / HTTP/1.1\r\nX: " + std::string(100000, 'x'));
  garbage.reset();
  large.reset();
  WaitForPages(2);
  good->Say(std::string(kLongestLiveMessage, 'b'));
  const auto taken = Taken();
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].text.size(), kLongestLiveMessage);
  server_->Publish("still here");
  EXPECT_EQ(good->Hear(), "still here");
}

TEST_F(Server, ManyPagesAtOnceAndNotMoreThanItTakes) {
  std::vector<std::unique_ptr<SocketClient>> pages;
  for (int i = 0; i < LiveServer::kMostPages; ++i) pages.push_back(Opened());
  WaitForPages(LiveServer::kMostPages);
  SocketClient beyond(server_->port());
  EXPECT_EQ(beyond.Open("/live", "http://" + host(), host()), 503);
  server_->Publish("for all");
  for (const auto& page : pages) EXPECT_EQ(page->Hear(), "for all");
  pages.resize(3);
  WaitForPages(3);
  Opened();
}

TEST_F(Server, APageThatReadsSlowlyMissesPicturesAndHoldsNobodyUp) {
  const auto slow = Opened(), fast = Opened();
  const std::string large(400000, 'p');
  for (int i = 0; i < 100; ++i) {
    server_->Publish(std::to_string(i) + large);
    ASSERT_TRUE(fast->Hear()) << i;
  }
  server_->Publish("the last");
  EXPECT_EQ(fast->Hear(), "the last");
  int heard = 0;
  std::optional<std::string> text;
  while ((text = slow->Hear()) && *text != "the last") ++heard;
  EXPECT_EQ(text, "the last");
  EXPECT_LT(heard, 60) << "of a hundred";
}

TEST_F(Server, WhatIsSaidFasterThanItIsTakenIsBounded) {
  const auto page = Opened();
  for (std::size_t i = 0; i < 3 * kMostLiveMessages; ++i) page->Say(std::to_string(i));
  std::this_thread::sleep_for(milliseconds(500));
  const auto taken = Taken();
  ASSERT_EQ(taken.size(), kMostLiveMessages);
  EXPECT_EQ(taken.back().text, std::to_string(3 * kMostLiveMessages - 1));
}

TEST_F(Server, APageThatSaysMuchDropsNobodyElsesWordsNorWhoLeft) {
  const auto loud = Opened();
  auto quiet = Opened();
  quiet->Say("the quiet one");
  std::this_thread::sleep_for(milliseconds(200));
  quiet.reset();
  WaitForPages(1);
  for (std::size_t i = 0; i < 2 * kMostLiveMessages; ++i) loud->Say("noise");
  std::this_thread::sleep_for(milliseconds(500));
  const auto first = server_->Next(), second = server_->Next();
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->text, "the quiet one");
  EXPECT_TRUE(second->left);
}

TEST(LiveServerStart, SaysWhereItCannotListen) {
  const auto first = std::move(LiveServer::Start({}, "").value());
  const auto taken = LiveServer::Start({.port = first->port()}, "");
  ASSERT_FALSE(taken.ok());
  EXPECT_NE(taken.failure().message.find("in use"), std::string::npos) << taken.failure().message;
  EXPECT_FALSE(LiveServer::Start({.host = "300.1.2.3"}, "").ok());
  EXPECT_FALSE(LiveServer::Start({.host = "203.0.113.7"}, "").ok()) << "no address of this machine";
}

}  // namespace
}  // namespace gaitwright
