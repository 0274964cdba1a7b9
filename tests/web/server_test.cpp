// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/server.h"

#include <catch2/catch.hpp>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

/// A connection on which the message has been sent.
int send_to(int port, const std::string& message) {
    const int connection = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(::connect(connection, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    REQUIRE(::send(connection, message.data(), message.size(), 0) > 0);
    return connection;
}

std::string fetch(int port, const std::string& message) {
    const int connection = send_to(port, message);
    std::string answer(1 << 16, '\0');
    std::size_t length = 0;
    for (ssize_t count = 1; count > 0;
         length += static_cast<std::size_t>(std::max<ssize_t>(count, 0)))
        count = ::recv(connection, answer.data() + length, answer.size() - length, 0);
    ::close(connection);
    return answer.substr(0, length);
}

}  // namespace

TEST_CASE("requests are read, and refused when they come for another host") {
    const auto request =
        read_request("GET /pick?x=3&yy=4&y=5 HTTP/1.1\r\nA: b\r\nHOST: localhost:80\r\n\r\n", 80);
    REQUIRE(request);
    CHECK(request->path == "/pick");
    CHECK(request->parameter("x") == "3");
    CHECK(request->parameter("y") == "5");
    CHECK(request->parameter("z").empty());
    for (const char* bad :
         {"", "GET", "GET ", "GET /", "POST / HTTP/1.1\r\nHost: localhost:80\r\n\r\n",
          "GET / HTTP/1.1\r\n\r\n", "GET / HTTP/1.1\r\nHost: evil.example:80\r\n\r\n",
          "GET / HTTP/1.1\r\nHost: localhost:81\r\n\r\n"}) {
        CAPTURE(bad);
        CHECK_FALSE(read_request(bad, 80));
    }
}

TEST_CASE("a page is served on a free port") {
    const WebServer server(0, [](const WebRequest& request) {
        return WebAnswer{"text/plain", "you asked for " + request.path};
    });
    REQUIRE(server.port() > 0);
    const std::string host = "Host: 127.0.0.1:" + std::to_string(server.port()) + "\r\n\r\n";
    const std::string answer = fetch(server.port(), "GET /a HTTP/1.1\r\n" + host);
    CHECK(answer.starts_with("HTTP/1.1 200 "));
    CHECK(answer.ends_with("\r\n\r\nyou asked for /a"));
    CHECK(fetch(server.port(), "PUT /a HTTP/1.1\r\n" + host).starts_with("HTTP/1.1 403 "));
    CHECK(WebServer(server.port(), {}).port() == 0);
}

TEST_CASE("who does not read the answer holds up nobody for long") {
    int connection = 0;
    {
        std::atomic<bool> asked = false;
        const WebServer server(0, [&](const WebRequest&) {
            asked = true;
            return WebAnswer{"text/plain", std::string(64 << 20, 'x')};
        });
        const std::string host = "Host: localhost:" + std::to_string(server.port()) + "\r\n\r\n";
        connection = send_to(server.port(), "GET / HTTP/1.1\r\n" + host);
        while (!asked) std::this_thread::yield();
    }
    ::close(connection);
}
