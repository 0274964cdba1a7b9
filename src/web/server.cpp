// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/server.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>
#include <cerrno>

namespace candelabra {

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::milliseconds;

constexpr auto plain_text = "text/plain; charset=utf-8";
constexpr Milliseconds look_up(100);  ///< interval between checks for the end of the server

/// Time for the client to see the end of the answer. Closing a socket with unread input would reset
/// the connection and discard sent data.
constexpr Milliseconds farewell(1000);

bool would_wait() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

/// A connection that receives a request, waits for an answer, sends it, or waits for the client to
/// close.
class Connection {
public:
    enum State { asking, waiting_for_answer, fetching, leaving, gone };

    Connection(int socket, Clock::time_point until) : socket_(socket), until_(until) {}
    Connection(Connection&& other) noexcept { *this = std::move(other); }
    Connection& operator=(Connection&& other) noexcept {
        std::swap(socket_, other.socket_);
        std::swap(state_, other.state_);
        std::swap(bytes_, other.bytes_);
        std::swap(sent_, other.sent_);
        std::swap(until_, other.until_);
        std::swap(request_, other.request_);
        return *this;
    }
    ~Connection() {
        if (socket_ >= 0) ::close(socket_);
    }

    State state() const { return state_; }
    pollfd waits() const {
        return {socket_, static_cast<short>(state_ == fetching ? POLLOUT : POLLIN), 0};
    }
    bool late(Clock::time_point now) const { return now >= until_; }
    /// The part of the request that has been received.
    const std::string& asked() const { return bytes_; }
    std::size_t waiting() const { return state_ == fetching ? bytes_.size() - sent_ : 0; }

    /// Receives available bytes; returns false at the end of the input or after an error.
    bool take() {
        char part[4096];
        const ssize_t count = ::recv(socket_, part, sizeof part, MSG_DONTWAIT);
        if (count < 0 && would_wait()) return true;
        if (count <= 0) return false;
        if (state_ == asking) bytes_.append(part, static_cast<std::size_t>(count));
        return true;
    }

    void answer(std::string bytes, Clock::time_point until) {
        bytes_ = std::move(bytes);
        sent_ = 0;
        state_ = fetching;
        until_ = until;
        give();
    }

    /// Sends as many bytes as the socket takes at the moment.
    void give() {
        const ssize_t count = ::send(socket_, bytes_.data() + sent_, bytes_.size() - sent_,
                                     MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count < 0 && !would_wait()) return end();
        if (count > 0) sent_ += static_cast<std::size_t>(count);
        if (sent_ < bytes_.size()) return;
        bytes_ = {};
        state_ = leaving;
        until_ = Clock::now() + farewell;
        ::shutdown(socket_, SHUT_WR);
    }

    void end() { state_ = gone; }

    /// Keeps the request until there is an answer.
    void wait(WebRequest request, Clock::time_point until) {
        request_ = std::move(request);
        bytes_ = {};
        state_ = waiting_for_answer;
        until_ = until;
    }
    WebRequest& request() { return request_; }

private:
    int socket_ = -1;
    State state_ = asking;
    std::string bytes_;  ///< of the request, then of the answer
    std::size_t sent_ = 0;
    Clock::time_point until_;
    WebRequest request_ = {};  ///< waits for its answer
};

/// All connections of a server, served by one thread.
class Crowd {
public:
    /// `bell` is an eventfd: after each event, waiting requests are answered again.
    Crowd(int socket, int bell, const WebLimits& limits, const WebKey& key,
          const WebServer::Handler& handler)
        : socket_(socket), bell_(bell), limits_(limits), key_(key), handler_(handler) {}

    /// Waits for events for a short time and handles them.
    void turn() {
        std::vector<pollfd> waits = {{socket_, POLLIN, 0}, {bell_, POLLIN, 0}};
        const std::size_t first = waits.size();
        for (const Connection& each : crowd_) waits.push_back(each.waits());
        if (::poll(waits.data(), waits.size(), static_cast<int>(look_up.count())) < 0) return;
        // Taken before the handlers run, which may be slow: requests that expire meanwhile are
        // served.
        const auto now = Clock::now();
        for (std::size_t i = 0; i < crowd_.size(); ++i)
            if (waits[first + i].revents != 0) serve(crowd_[i]);
        if (waits[1].revents != 0) hear_again();
        for (Connection& each : crowd_)
            if (each.late(now)) give_up(each);
        std::erase_if(crowd_, [](const Connection& c) { return c.state() == Connection::gone; });
        if (waits[0].revents != 0) let_in();
    }

private:
    static Clock::time_point after(int milliseconds) {
        return Clock::now() + Milliseconds(milliseconds);
    }

    void let_in() {
        for (std::size_t n = 0; n < limits_.connections; ++n) {
            const int socket = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
            if (socket < 0) {
                // Without free descriptors, accept4() would fail again at once, and forever.
                if (!would_wait() && errno != ECONNABORTED) std::this_thread::sleep_for(look_up);
                return;
            }
            if (crowd_.size() >= limits_.connections) make_room();
            crowd_.emplace_back(socket, after(limits_.request_milliseconds));
        }
    }

    void make_room() {
        const auto silent = std::ranges::find(crowd_, Connection::asking, &Connection::state);
        crowd_.erase(silent == crowd_.end() ? crowd_.begin() : silent);
    }

    void serve(Connection& connection) {
        if (connection.state() == Connection::fetching) return connection.give();
        if (!connection.take()) return connection.end();
        if (connection.state() != Connection::asking) return;
        const ReadRequest read = read_request(connection.asked(), key_);
        if (const auto* const request = std::get_if<WebRequest>(&read)) {
            WebRequest patient = *request;
            patient.can_wait = true;
            if (!answered(connection, patient))
                connection.wait(std::move(patient), after(limits_.patience_milliseconds));
        } else if (const auto* const refusal = std::get_if<WebAnswer>(&read))
            refuse(connection, *refusal);
    }

    void hear_again() {
        std::uint64_t count = 0;
        if (::read(bell_, &count, sizeof count) < 0) return;
        for (Connection& each : crowd_)
            if (each.state() == Connection::waiting_for_answer) answered(each, each.request());
    }

    /// Returns false if there is no answer yet.
    bool answered(Connection& connection, const WebRequest& request) {
        std::optional<std::string> said = answer(request);
        if (said) connection.answer(std::move(*said), after(limits_.answer_milliseconds));
        return said.has_value();
    }

    std::optional<std::string> answer(const WebRequest& request) {
        std::size_t waiting = 0;
        for (const Connection& each : crowd_) waiting += each.waiting();
        if (waiting <= limits_.waiting_bytes) try {
                WebAnswer said = handler_(request);
                if (said.later && request.can_wait) return std::nullopt;
                if (request.has_token) said.cookie = cookie_of(key_);
                return sent_form(said);
            } catch (const std::bad_alloc&) {  // handled like a lack of room
            }
        return sent_form({plain_text, "there is no room for the answer at the moment\n", 503});
    }

    void refuse(Connection& connection, const WebAnswer& why) {
        connection.answer(sent_form(why), after(limits_.answer_milliseconds));
    }

    void give_up(Connection& connection) {
        if (connection.state() == Connection::waiting_for_answer) {
            connection.request().can_wait = false;
            answered(connection, connection.request());
            return;
        }
        if (connection.state() != Connection::asking) return connection.end();
        refuse(connection, {plain_text, "the request took too long\n", 408});
    }

    int socket_, bell_;
    const WebLimits& limits_;
    const WebKey& key_;
    const WebServer::Handler& handler_;
    std::vector<Connection> crowd_;  ///< the oldest first
};

}  // namespace

std::vector<std::string> addresses_of(std::string_view host) {
    if (host != any_host) return {std::string(host)};
    std::vector<std::string> found;
    ifaddrs* all = nullptr;
    if (::getifaddrs(&all) != 0) return found;
    for (const ifaddrs* each = all; each; each = each->ifa_next) {
        if (!each->ifa_addr || each->ifa_addr->sa_family != AF_INET) continue;
        if ((each->ifa_flags & IFF_LOOPBACK) != 0) continue;
        char text[INET_ADDRSTRLEN] = {};
        const auto* const address = reinterpret_cast<const sockaddr_in*>(each->ifa_addr);
        if (::inet_ntop(AF_INET, &address->sin_addr, text, sizeof text)) found.emplace_back(text);
    }
    ::freeifaddrs(all);
    return found;
}

WebServer::WebServer(std::string_view host, int port, std::string token, Handler handler,
                     WebLimits limits)
    : key_{0, std::move(token), host != own_host}, handler_(std::move(handler)), limits_(limits) {
    if (key_.token.empty()) return;
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const int yes = 1;
    ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    if (::inet_pton(AF_INET, std::string(host).c_str(), &address.sin_addr) != 1) return;
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    socklen_t length = sizeof address;
    constexpr int waiting = 128;
    if (::bind(socket_, generic, length) != 0 || ::listen(socket_, waiting) != 0 ||
        ::getsockname(socket_, generic, &length) != 0)
        return;
    bell_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (bell_ < 0) return;
    key_.port = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
}

WebServer::~WebServer() {
    ending_ = true;
    if (thread_.joinable()) thread_.join();
    if (socket_ >= 0) ::close(socket_);
    if (bell_ >= 0) ::close(bell_);
}

void WebServer::wake() const {
    const std::uint64_t one = 1;
    // A full counter wakes the server, too.
    [[maybe_unused]] const ssize_t written = ::write(bell_, &one, sizeof one);
}

void WebServer::serve() {
    Crowd crowd(socket_, bell_, limits_, key_, handler_);
    while (!ending_) crowd.turn();
}

}  // namespace candelabra
