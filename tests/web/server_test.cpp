// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/server.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace candelabra {

namespace {

/// Opens a connection and sends the message.
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

TEST_CASE("a page is served on a free port") {
    const WebServer server(own_host, 0, "secret", [](const WebRequest& request) {
        return WebAnswer{"text/plain", (request.post ? "you say " : "you ask for ") + request.path +
                                           " " + request.form};
    });
    REQUIRE(server.port() > 0);
    const std::string host = "Host: 127.0.0.1:" + std::to_string(server.port()) + "\r\n";
    const std::string answer = fetch(server.port(), "GET /a HTTP/1.1\r\n" + host + "\r\n");
    CHECK(answer.starts_with("HTTP/1.1 200 "));
    CHECK(answer.ends_with("\r\n\r\nyou ask for /a "));
    CHECK(fetch(server.port(),
                "POST /b HTTP/1.1\r\n" + host + "X-Token: secret\r\nContent-Length: 3\r\n\r\nx=1")
              .ends_with("you say /b x=1"));
    CHECK(fetch(server.port(), "PUT /a HTTP/1.1\r\n" + host + "\r\n").starts_with("HTTP/1.1 405 "));
    CHECK(fetch(server.port(), "GET /a HTTP/1.1\r\n\r\n").starts_with("HTTP/1.1 403 "));
    CHECK(WebServer(own_host, server.port(), "secret", {}).port() == 0);
    CHECK(WebServer(own_host, 0, "", {}).port() == 0);
}

TEST_CASE("who does not read the answer holds up nobody") {
    const std::string large(64 << 20, 'x');
    std::vector<int> lazy;
    {
        std::atomic<int> asked = 0;
        const WebServer server(
            own_host, 0, "secret",
            [&](const WebRequest& request) {
                ++asked;
                return WebAnswer{"text/plain", request.path == "/large" ? large : "quick"};
            },
            {.waiting_bytes = 100 << 20});
        const std::string host = "Host: localhost:" + std::to_string(server.port()) + "\r\n\r\n";
        for (int i = 0; i < 2; ++i)
            lazy.push_back(send_to(server.port(), "GET /large HTTP/1.1\r\n" + host));
        while (asked < 2) std::this_thread::yield();
        // The unread answers leave no room for another one.
        CHECK(fetch(server.port(), "GET / HTTP/1.1\r\n" + host).starts_with("HTTP/1.1 503 "));
        ::close(lazy.back());
        lazy.pop_back();
        std::string answer;
        for (int i = 0; i < 100 && !answer.ends_with("quick"); ++i)
            answer = fetch(server.port(), "GET / HTTP/1.1\r\n" + host);
        CHECK(answer.ends_with("quick"));
    }
    for (const int each : lazy) ::close(each);
}

TEST_CASE("slow and silent connections hold up nobody") {
    const WebServer server(own_host, 0, "secret", [](const WebRequest&) {
        return WebAnswer{"text/plain", "quick"};
    });
    const std::string get =
        "GET / HTTP/1.1\r\nHost: localhost:" + std::to_string(server.port()) + "\r\n\r\n";
    std::vector<int> silent;
    for (int i = 0; i < 300; ++i) silent.push_back(send_to(server.port(), "GET /"));
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 10; ++i) CHECK(fetch(server.port(), get).ends_with("quick"));
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(4));
    for (const int each : silent) ::close(each);
}

TEST_CASE("a request that drips has a time for all of it") {
    const WebServer server(own_host, 0, "secret",
                           [](const WebRequest&) {
                               return WebAnswer{"text/plain", "quick"};
                           },
                           {.request_milliseconds = 300});
    const int connection = send_to(server.port(), "GET /");
    std::string answer;
    for (int i = 0; i < 100 && answer.empty(); ++i) {
        ::send(connection, "a", 1, MSG_NOSIGNAL);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        char part[4096];
        const ssize_t count = ::recv(connection, part, sizeof part, MSG_DONTWAIT);
        if (count >= 0) answer.assign(part, static_cast<std::size_t>(count)) += ' ';
    }
    CHECK(answer.starts_with("HTTP/1.1 408 "));
    ::close(connection);
}

TEST_CASE("a request waits for its answer, and hears of it at once") {
    std::atomic<bool> there = false;
    std::atomic<int> asked = 0;
    const WebServer server(own_host, 0, "secret",
                           [&](const WebRequest& request) {
                               if (request.path == "/other")
                                   return WebAnswer{"text/plain", "other"};
                               ++asked;
                               WebAnswer answer{"text/plain", there ? "there" : "nothing"};
                               answer.later = !there;
                               return answer;
                           },
                           {.patience_milliseconds = 60000});
    const std::string end =
        " HTTP/1.1\r\nHost: localhost:" + std::to_string(server.port()) + "\r\n\r\n";
    std::string answer;
    std::thread waiting([&] { answer = fetch(server.port(), "GET /news" + end); });
    while (asked < 1) std::this_thread::yield();
    CHECK(fetch(server.port(), "GET /other" + end).ends_with("other"));
    server.wake();
    while (asked < 2) std::this_thread::yield();
    there = true;
    server.wake();
    waiting.join();
    CHECK(answer.ends_with("\r\n\r\nthere"));
}

TEST_CASE("who waits in vain is answered when the time is over") {
    const WebServer server(
        own_host, 0, "secret",
        [&](const WebRequest& request) {
            WebAnswer answer{"text/plain", request.can_wait ? "soon" : "nothing"};
            answer.later = true;
            return answer;
        },
        {.connections = 8, .patience_milliseconds = 200});
    const std::string get =
        "GET /news HTTP/1.1\r\nHost: localhost:" + std::to_string(server.port()) + "\r\n\r\n";
    CHECK(fetch(server.port(), get).ends_with("\r\n\r\nnothing"));
    // Waiting requests take no more places than others.
    std::vector<int> waiting;
    for (int i = 0; i < 40; ++i) waiting.push_back(send_to(server.port(), get));
    CHECK(fetch(server.port(), get).ends_with("nothing"));
    for (const int each : waiting) ::close(each);
}

TEST_CASE("a server that others reach answers nobody without its token") {
    const WebServer server(any_host, 0, "secret", [](const WebRequest& request) {
        return WebAnswer{"text/plain", request.path};
    });
    REQUIRE(server.port() > 0);
    const std::string host = "Host: some.name:1\r\n";
    const auto get = [&](const std::string& path, const std::string& headers = "") {
        return fetch(server.port(), "GET " + path + " HTTP/1.1\r\n" + host + headers + "\r\n");
    };
    CHECK(get("/a").starts_with("HTTP/1.1 403 "));
    CHECK(get("/a?token=secre").starts_with("HTTP/1.1 403 "));
    const std::string cookie = "candelabra-" + std::to_string(server.port()) + "=secret";
    const std::string first = get("/?token=secret");
    CHECK(first.starts_with("HTTP/1.1 200 "));
    CHECK(first.find("\r\nSet-Cookie: " + cookie + "; Path=/; HttpOnly; SameSite=Strict\r\n") !=
          first.npos);
    const std::string next = get("/a", "Cookie: " + cookie + "\r\n");
    CHECK(next.ends_with("/a"));
    CHECK(next.find("Set-Cookie") == next.npos);
}

TEST_CASE("addresses are those of this machine in its networks") {
    CHECK(addresses_of("192.168.1.7") == std::vector<std::string>{"192.168.1.7"});
    for (const std::string& each : addresses_of(any_host)) {
        CHECK(WebServer(each, 0, "secret", {}).port() > 0);
        CHECK_FALSE(each.starts_with("127."));
    }
    for (const char* const other : {"", "localhost", "1.2.3", "1.2.3.4.5", "::1", "1.2.3.4 "})
        CHECK(WebServer(other, 0, "secret", {}).port() == 0);
}

}  // namespace candelabra
