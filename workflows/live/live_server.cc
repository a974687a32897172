// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/ip/host_name.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/http/span_body.hpp>
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

constexpr std::chrono::seconds kPatience{10};  // to wait for a request
constexpr std::size_t kLongestRequest = 16384, kMostWaiting = 32;
constexpr int kMostVisits = 256;
constexpr std::chrono::milliseconds kPause{100};  // after a connection could not be accepted

using Text = std::shared_ptr<const std::string>;

/// Queue of messages from pages, between two threads.
class Inbox {
 public:
  void Put(LiveSaying message) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t page = message.page;
    const bool said = !message.left;
    messages_.push_back(std::move(message));
    if (!said) return;
    ++said_[page];
    if (++all_said_ > kMostLiveMessages) DropOne();
  }
  std::optional<LiveSaying> Next() {
    const std::lock_guard lock(mutex_);
    if (messages_.empty()) return std::nullopt;
    LiveSaying next = std::move(messages_.front());
    messages_.pop_front();
    if (!next.left) Forget(next.page);
    return next;
  }

 private:
  /// Drops the oldest message of the page with the most messages.
  void DropOne() {
    const auto most = std::max_element(said_.begin(), said_.end(),
                                       [](const auto& one, const auto& other) { return one.second < other.second; });
    const std::uint64_t page = most->first;
    messages_.erase(std::find_if(messages_.begin(), messages_.end(),
                                 [page](const LiveSaying& saying) { return saying.page == page && !saying.left; }));
    Forget(page);
  }
  void Forget(std::uint64_t page) {
    --all_said_;
    const auto said = said_.find(page);
    if (--said->second == 0) said_.erase(said);
  }

  std::mutex mutex_;
  std::deque<LiveSaying> messages_;
  std::map<std::uint64_t, std::size_t> said_;  ///< number of queued messages by page, including closed pages
  std::size_t all_said_ = 0;
};

class Page;

/// Data shared by the pages of a server. Only its thread may use them, except the inbox and the count.
struct Shared {
  Text html;
  Text greeting;
  std::string host, machine;  ///< the address, and the name of this machine without its domain
  int port = 0;
  bool loopback = true, everywhere = false;  ///< everywhere: at all addresses of this machine
  Inbox inbox;
  std::map<std::uint64_t, Page*> pages;  ///< by number
  std::uint64_t opened = 0;
  int visits = 0;  ///< connections that are not pages
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

  /// Sends the first message, if it is already set.
  void Greet() {
    if (!shared_.greeting) return;
    Send(shared_.greeting);
    Send(std::make_shared<const std::string>(LivePageNumber(number_)));
  }

  /// Sends a text. A new frame replaces a waiting one. Other texts are queued; if a page does not read them, further
  /// ones are dropped.
  void Send(const Text& text, bool replaceable = false) {
    if (!accepted_ || !socket_.is_open()) return;
    if (replaceable && !waiting_.empty() && waiting_.back().second) waiting_.pop_back();
    if (waiting_.size() >= kMostWaiting) return;
    waiting_.emplace_back(text, replaceable);
    if (!writing_) Write();
  }

 private:
  void Read() {
    socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return;  // closed, lost, silent, message too long, or invalid frame
      self->Hear();
      self->buffer_.consume(self->buffer_.size());
      self->Read();
    });
  }

  /// Receives a message. A binary message counts as an empty text, which is refused.
  void Hear() {
    shared_.inbox.Put({number_, socket_.got_text() ? beast::buffers_to_string(buffer_.data()) : std::string()});
  }

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

/// One connection, until it is answered or becomes a page.
class Visit : public std::enable_shared_from_this<Visit> {
 public:
  Visit(tcp::socket&& socket, Shared& shared) : stream_(std::move(socket)), shared_(shared) { ++shared_.visits; }
  ~Visit() { --shared_.visits; }
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

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
    if (!IsForUs(request))
      return Say(request, http::status::forbidden, "text/plain", Plain("request not from this page\n"));
    const auto target = request.target();
    if (websocket::is_upgrade(request)) {
      if (target != kLivePath)
        return Say(request, http::status::not_found, "text/plain", Plain("this address does not exist\n"));
      if (shared_.count >= LiveServer::kMostPages)
        return Say(request, http::status::service_unavailable, "text/plain", Plain("too many pages are open\n"));
      return std::make_shared<Page>(std::move(stream_), shared_)->Open(request);
    }
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return Say(request, http::status::method_not_allowed, "text/plain", Plain("only GET is accepted\n"));
    if (target == "/") return Say(request, http::status::ok, "text/html; charset=utf-8", shared_.html);
    if (target == "/favicon.ico") return Say(request, http::status::no_content, "image/x-icon", Plain(""));
    Say(request, http::status::not_found, "text/plain", Plain("this address does not exist\n"));
  }

  static Text Plain(const std::string& text) { return std::make_shared<const std::string>(text); }

  /// Whether a request is for this server. A browser sends the origin of a WebSocket's page, which must be this server.
  /// The requested host name must be that of this machine, since other names can be made to resolve to its address.
  bool IsForUs(const http::request<http::empty_body>& request) const {
    const std::string host(request[http::field::host]);
    if (!IsOurs(host)) return false;
    const auto origin = request.find(http::field::origin);
    return origin == request.end() || origin->value() == "http://" + host;
  }

  bool IsOurs(const std::string& host) const {
    constexpr int kUsualPort = 80;  // browsers leave it out
    const std::string port = fmt::format(":{}", shared_.port);
    const bool has_port = host.size() > port.size() && host.ends_with(port);
    if (!has_port && shared_.port != kUsualPort) return false;
    const std::string name = has_port ? host.substr(0, host.size() - port.size()) : host;
    if (name == shared_.host || name == "localhost" || name == "127.0.0.1" || name == "[::1]") return true;
    return !shared_.loopback && (IsAddress(name) || name.substr(0, name.find('.')) == shared_.machine);
  }

  static bool IsAddress(const std::string& name) {
    const bool bracketed = name.starts_with('[') && name.ends_with(']');
    beast::error_code error;
    asio::ip::make_address(bracketed ? name.substr(1, name.size() - 2) : name, error);
    return !error;
  }

  void Say(const http::request<http::empty_body>& request, http::status status, const char* type, const Text& text) {
    const bool head = request.method() == http::verb::head;
    using Body = http::span_body<const char>;
    auto response = std::make_shared<http::response<Body>>(status, request.version());
    response->set(http::field::content_type, type);
    response->set(http::field::cache_control, "no-store");
    response->set("X-Content-Type-Options", "nosniff");
    response->set("X-Frame-Options", "DENY");
    response->keep_alive(request.keep_alive());
    if (!head) response->body() = {text->data(), text->size()};
    response->content_length(text->size());
    stream_.expires_after(kPatience);
    http::async_write(stream_, *response,
                      [self = shared_from_this(), response, text](beast::error_code error, std::size_t) {
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
  Shared shared;  ///< must outlive the pending operations of the context
  asio::io_context context{1};
  tcp::acceptor acceptor{context};
  asio::steady_timer pause{context};
  std::thread thread;

  void Accept() {
    acceptor.async_accept([this](beast::error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error) {
        if (shared.visits < kMostVisits) std::make_shared<Visit>(std::move(socket), shared)->Read();
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
  constexpr int kHighestPort = 65535;
  if (address.port < 0 || address.port > kHighestPort) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kAddress,
                   "LiveServer",
                   fmt::format("the port is {}; accepted: 0 to {}", address.port, kHighestPort),
                   {"use --port 0 for any free port"}};
  }
  boost::system::error_code no_address;
  const asio::ip::address ip =
      asio::ip::make_address(address.host == "localhost" ? "127.0.0.1" : address.host, no_address);
  if (no_address) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kAddress,
                   "LiveServer",
                   fmt::format("'{}' is not an IP address", address.host),
                   {"use 127.0.0.1 for this machine only, 0.0.0.0 for all networks"}};
  }
  try {
    const tcp::endpoint endpoint(ip, static_cast<unsigned short>(address.port));
    impl->acceptor.open(endpoint.protocol());
    impl->acceptor.set_option(asio::socket_base::reuse_address(true));
    impl->acceptor.bind(endpoint);
    impl->acceptor.listen();
    impl->shared.loopback = ip.is_loopback();
    impl->shared.host = ip.is_v6() ? fmt::format("[{}]", ip.to_string()) : ip.to_string();
    impl->shared.everywhere = ip.is_unspecified();
    const std::string machine = asio::ip::host_name();
    impl->shared.machine = machine.substr(0, machine.find('.'));
    impl->shared.port = impl->acceptor.local_endpoint().port();
  } catch (const boost::system::system_error& error) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kAddress,
                   "LiveServer",
                   fmt::format("cannot listen on {}, port {}: {}", address.host, address.port, error.code().message()),
                   {error.code() == asio::error::address_in_use ? "use --port 0 for any free port"
                                                                : "'ip address' lists the addresses of this machine"}};
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

std::string LiveServer::url() const {
  const Shared& shared = impl_->shared;
  const std::string& host = shared.everywhere ? (shared.host == "[::]" ? "[::1]" : "127.0.0.1") : shared.host;
  return fmt::format("http://{}:{}/", host, shared.port);
}

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

std::optional<LiveSaying> LiveServer::Next() { return impl_->shared.inbox.Next(); }

void LiveServer::Tell(std::uint64_t page, const std::string& text) {
  asio::post(impl_->context, [impl = impl_.get(), page, text = std::make_shared<const std::string>(text)] {
    const auto found = impl->shared.pages.find(page);
    if (found != impl->shared.pages.end()) found->second->Send(text);
  });
}

int LiveServer::pages() const { return impl_->shared.count; }

}  // namespace gaitwright
