// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "playback/viewer/viewer_page.h"
#include "workflows/live/live_messages.h"

namespace gaitwright {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = asio::ip::tcp;

constexpr std::chrono::seconds kPatience{10};  // for a request
constexpr std::size_t kLongestRequest = 16384, kMostWaiting = 32;
constexpr std::chrono::milliseconds kPause{100};  // where no connection can be taken

using Text = std::shared_ptr<const std::string>;

/// What pages have said, on its way from one thread to the other.
class Inbox {
 public:
  void Put(LiveSaying message) {
    const std::lock_guard lock(mutex_);
    const bool said = !message.left;
    messages_.push_back(std::move(message));
    if (!said || ++said_ <= kMostLiveMessages) return;
    messages_.erase(std::find_if(messages_.begin(), messages_.end(), [](const LiveSaying& m) { return !m.left; }));
    --said_;
  }
  std::vector<LiveSaying> Take() {
    const std::lock_guard lock(mutex_);
    std::vector<LiveSaying> taken(messages_.begin(), messages_.end());
    messages_.clear();
    said_ = 0;
    return taken;
  }

 private:
  std::mutex mutex_;
  std::deque<LiveSaying> messages_;
  std::size_t said_ = 0;  ///< of these, without those that tell who left
};

class Page;

/// What the pages of a server share. Only its thread touches it, but for the inbox and the count.
struct Shared {
  Text html;
  Text greeting;
  std::string host;
  int port = 0;
  bool loopback = true;
  Inbox inbox;
  std::map<std::uint64_t, Page*> pages;  ///< by number
  std::uint64_t opened = 0;
  std::atomic<int> count{0};
};

/// The WebSocket of one open page.
class Page : public std::enable_shared_from_this<Page> {
 public:
  Page(beast::tcp_stream&& stream, Shared& shared)
      : socket_(std::move(stream)), shared_(shared), number_(++shared.opened) {
    shared_.pages.emplace(number_, this);
    ++shared_.count;
  }
  ~Page() {
    shared_.inbox.Put({number_, "", true});
    shared_.pages.erase(number_);
    --shared_.count;
  }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  void Open(const http::request<http::empty_body>& request) {
    websocket::stream_base::timeout patience = websocket::stream_base::timeout::suggested(beast::role_type::server);
    patience.idle_timeout = std::chrono::seconds(30);
    patience.keep_alive_pings = true;
    beast::get_lowest_layer(socket_).expires_never();
    socket_.set_option(patience);
    socket_.read_message_max(kLongestLiveMessage);
    socket_.auto_fragment(false);
    socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
      if (error) return;
      self->accepted_ = true;
      self->Greet();
      self->Read();
    });
  }

  /// What the page is told first, where there is something to tell yet.
  void Greet() {
    if (!shared_.greeting) return;
    Send(shared_.greeting);
    Send(std::make_shared<const std::string>(LivePageNumber(number_)));
  }

  /// The latest picture takes the place of one that waits; other texts do not, and a page that reads none of them is
  /// not told more.
  void Send(const Text& text, bool replaceable = false) {
    if (!accepted_ || !socket_.is_open()) return;
    if (replaceable && !waiting_.empty() && waiting_.back().second) waiting_.pop_back();
    if (waiting_.size() >= kMostWaiting) return;
    waiting_.emplace_back(text, replaceable);
    if (!writing_) Write();
  }

  void Close() { beast::get_lowest_layer(socket_).close(); }

 private:
  void Read() {
    socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return;  // closed, lost, silent, too long, or no frame of the protocol
      if (self->socket_.got_text()) self->Hear();
      self->buffer_.consume(self->buffer_.size());
      self->Read();
    });
  }

  void Hear() { shared_.inbox.Put({number_, beast::buffers_to_string(buffer_.data())}); }

  void Write() {
    writing_ = true;
    const Text text = waiting_.front().first;
    waiting_.pop_front();
    socket_.text(true);
    socket_.async_write(asio::buffer(*text), [self = shared_from_this(), text](beast::error_code error, std::size_t) {
      self->writing_ = false;
      if (!error && !self->waiting_.empty()) self->Write();
    });
  }

  websocket::stream<beast::tcp_stream> socket_;
  Shared& shared_;
  const std::uint64_t number_;
  beast::flat_buffer buffer_{kLongestLiveMessage + 1024};
  std::deque<std::pair<Text, bool>> waiting_;
  bool accepted_ = false, writing_ = false;
};

/// One connection until it is answered or becomes a page.
class Visit : public std::enable_shared_from_this<Visit> {
 public:
  Visit(tcp::socket&& socket, Shared& shared) : stream_(std::move(socket)), shared_(shared) {}

  void Read() {
    parser_.emplace();
    parser_->header_limit(kLongestRequest);
    parser_->body_limit(0);
    stream_.expires_after(kPatience);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (!error) self->Answer(self->parser_->release());
    });
  }

 private:
  void Answer(const http::request<http::empty_body>& request) {
    if (!IsForUs(request)) return Say(request, http::status::forbidden, "text/plain", Plain("not of this page\n"));
    const auto target = request.target();
    if (websocket::is_upgrade(request)) {
      if (target != kLivePath) return Say(request, http::status::not_found, "text/plain", Plain("no such place\n"));
      if (shared_.count >= LiveServer::kMostPages)
        return Say(request, http::status::service_unavailable, "text/plain", Plain("too many pages are open\n"));
      return std::make_shared<Page>(std::move(stream_), shared_)->Open(request);
    }
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return Say(request, http::status::method_not_allowed, "text/plain", Plain("GET alone\n"));
    if (target == "/") return Say(request, http::status::ok, "text/html; charset=utf-8", shared_.html);
    if (target == "/favicon.ico") return Say(request, http::status::no_content, "image/x-icon", Plain(""));
    Say(request, http::status::not_found, "text/plain", Plain("no such place\n"));
  }

  static Text Plain(const std::string& text) { return std::make_shared<const std::string>(text); }

  /// A browser says which page a WebSocket is of; a page of elsewhere is not ours. On loopback the name that it is
  /// asked for must be this machine's too, since other names may be made to lead here.
  bool IsForUs(const http::request<http::empty_body>& request) const {
    const std::string host(request[http::field::host]);
    if (shared_.loopback) {
      bool known = false;
      for (const std::string& name :
           {shared_.host, std::string("localhost"), std::string("127.0.0.1"), std::string("[::1]")})
        known = known || host == fmt::format("{}:{}", name, shared_.port);
      if (!known) return false;
    }
    const auto origin = request.find(http::field::origin);
    return origin == request.end() || origin->value() == "http://" + host;
  }

  void Say(const http::request<http::empty_body>& request, http::status status, const char* type, Text text) {
    const bool head = request.method() == http::verb::head;
    auto response = std::make_shared<http::response<http::string_body>>(status, request.version());
    response->set(http::field::content_type, type);
    response->set(http::field::cache_control, "no-store");
    response->set("X-Content-Type-Options", "nosniff");
    response->set("X-Frame-Options", "DENY");
    response->keep_alive(request.keep_alive());
    if (!head) response->body() = *text;
    response->content_length(text->size());
    stream_.expires_after(kPatience);
    http::async_write(stream_, *response, [self = shared_from_this(), response](beast::error_code error, std::size_t) {
      if (!error && response->keep_alive()) return self->Read();
      beast::error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  beast::tcp_stream stream_;
  Shared& shared_;
  beast::flat_buffer buffer_{kLongestRequest};
  std::optional<http::request_parser<http::empty_body>> parser_;
};

}  // namespace

struct LiveServer::Impl {
  Shared shared;  ///< outlives what waits in the context
  asio::io_context context{1};
  tcp::acceptor acceptor{context};
  asio::steady_timer pause{context};
  std::thread thread;

  void Accept() {
    acceptor.async_accept([this](beast::error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error) {
        std::make_shared<Visit>(std::move(socket), shared)->Read();
        return Accept();
      }
      pause.expires_after(kPause);
      pause.async_wait([this](beast::error_code) { Accept(); });
    });
  }
};

LiveServer::LiveServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<LiveServer>> LiveServer::Start(const LiveAddress& address, const std::string& page) {
  auto impl = std::make_unique<Impl>();
  try {
    const asio::ip::address ip = asio::ip::make_address(address.host == "localhost" ? "127.0.0.1" : address.host);
    const tcp::endpoint endpoint(ip, static_cast<unsigned short>(address.port));
    impl->acceptor.open(endpoint.protocol());
    impl->acceptor.set_option(asio::socket_base::reuse_address(true));
    impl->acceptor.bind(endpoint);
    impl->acceptor.listen();
    impl->shared.loopback = ip.is_loopback();
    impl->shared.host = ip.is_v6() ? fmt::format("[{}]", ip.to_string()) : ip.to_string();
    impl->shared.port = impl->acceptor.local_endpoint().port();
  } catch (const boost::system::system_error& error) {
    return Failure{FailureKind::kBadInput,
                   "address",
                   "LiveServer",
                   fmt::format("cannot listen at {}, port {}: {}", address.host, address.port, error.code().message()),
                   {"--port 0 takes any port that is free"}};
  }
  impl->shared.html = std::make_shared<const std::string>(page);
  impl->Accept();
  impl->thread = std::thread([context = &impl->context] { context->run(); });
  return std::unique_ptr<LiveServer>(new LiveServer(std::move(impl)));
}

LiveServer::~LiveServer() {
  impl_->context.stop();
  impl_->thread.join();
}

int LiveServer::port() const { return impl_->shared.port; }

std::string LiveServer::url() const { return fmt::format("http://{}:{}/", impl_->shared.host, impl_->shared.port); }

void LiveServer::Greet(const std::string& greeting) {
  asio::post(impl_->context, [impl = impl_.get(), text = std::make_shared<const std::string>(greeting)] {
    impl->shared.greeting = text;
    for (const auto& [number, page] : impl->shared.pages) page->Greet();
  });
}

void LiveServer::Publish(const std::string& picture) {
  asio::post(impl_->context, [impl = impl_.get(), text = std::make_shared<const std::string>(picture)] {
    for (const auto& [number, page] : impl->shared.pages) page->Send(text, true);
  });
}

std::vector<LiveSaying> LiveServer::Take() { return impl_->shared.inbox.Take(); }

void LiveServer::Tell(std::uint64_t page, const std::string& text) {
  asio::post(impl_->context, [impl = impl_.get(), page, text = std::make_shared<const std::string>(text)] {
    const auto found = impl->shared.pages.find(page);
    if (found != impl->shared.pages.end()) found->second->Send(text);
  });
}

int LiveServer::pages() const { return impl_->shared.count; }

}  // namespace gaitwright
