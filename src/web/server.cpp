// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/server.h"

#include "text/ascii.h"

#include <algorithm>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

constexpr std::size_t longest_head = 8192;
constexpr int patience = 2;  ///< seconds that a part of a request or of an answer may take

/// The value of a header, whatever the case of its name; blanks before it are taken away.
std::string header(std::string_view head, std::string_view name) {
    while (!head.empty()) {
        const std::size_t end = std::min(head.find("\r\n"), head.size());
        const std::string_view line = head.substr(0, end);
        head.remove_prefix(std::min(head.size(), end + 2));
        const bool same = line.size() > name.size() && line[name.size()] == ':' &&
                          same_letters(line.substr(0, name.size()), name);
        if (!same) continue;
        const std::string_view value = line.substr(name.size() + 1);
        const std::size_t first = std::min(value.find_first_not_of(" \t"), value.size());
        return std::string(value.substr(first));
    }
    return {};
}

/// What arrives up to the empty line; empty when it takes too long or is too long.
std::string received_head(int connection) {
    std::string text;
    char part[1024];
    while (text.find("\r\n\r\n") == text.npos) {
        pollfd ready{connection, POLLIN, 0};
        if (::poll(&ready, 1, 1000 * patience) <= 0 || text.size() > longest_head) return {};
        const ssize_t count = ::recv(connection, part, sizeof part, 0);
        if (count <= 0) return {};
        text.append(part, static_cast<std::size_t>(count));
    }
    return text;
}

void send_all(int connection, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count <= 0) return;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

}  // namespace

std::string WebRequest::parameter(std::string_view name) const {
    for (std::size_t at = 0; at < query.size();) {
        const std::size_t end = std::min(query.find('&', at), query.size());
        const std::string_view pair = std::string_view(query).substr(at, end - at);
        if (pair.starts_with(name) && pair.substr(name.size()).starts_with('='))
            return std::string(pair.substr(name.size() + 1));
        at = end + 1;
    }
    return {};
}

std::optional<WebRequest> read_request(std::string_view head, int port) {
    const std::string_view line = head.substr(0, std::min(head.find("\r\n"), head.size()));
    const std::size_t end = line.find(' ', 4);
    if (!line.starts_with("GET /") || end == line.npos) return std::nullopt;
    const std::string host = header(head, "host"), number = std::to_string(port);
    if (host != "127.0.0.1:" + number && host != "localhost:" + number) return std::nullopt;
    const std::string_view target = line.substr(4, end - 4);
    const std::size_t mark = std::min(target.find('?'), target.size());
    return WebRequest{std::string(target.substr(0, mark)),
                      std::string(target.substr(std::min(mark + 1, target.size())))};
}

WebServer::WebServer(int port, Handler handler) : handler_(std::move(handler)) {
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int yes = 1;
    ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    socklen_t length = sizeof address;
    if (::bind(socket_, generic, length) != 0 || ::listen(socket_, 16) != 0 ||
        ::getsockname(socket_, generic, &length) != 0)
        return;
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
}

WebServer::~WebServer() {
    ending_ = true;
    if (thread_.joinable()) thread_.join();
    ::close(socket_);
}

void WebServer::serve() {
    while (!ending_) {
        pollfd ready{socket_, POLLIN, 0};
        constexpr int look_up = 100;  // milliseconds between two looks at whether this shall end
        if (::poll(&ready, 1, look_up) <= 0) continue;
        const int connection = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
        if (connection < 0) continue;
        // Who does not read the answer must not hold up the next one, or the end.
        const timeval longest{patience, 0};
        ::setsockopt(connection, SOL_SOCKET, SO_SNDTIMEO, &longest, sizeof longest);
        answer(connection);
        ::close(connection);
    }
}

void WebServer::answer(int connection) const {
    const auto request = read_request(received_head(connection), port_);
    const WebAnswer result =
        request ? handler_(*request) : WebAnswer{"text/plain", "no such page\n", 403};
    send_all(connection, "HTTP/1.1 " + std::to_string(result.status) +
                             " -\r\nContent-Type: " + result.type +
                             "\r\nContent-Length: " + std::to_string(result.body.size()) +
                             "\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n");
    send_all(connection, result.body);
}
