// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/request.h"

#include <catch2/catch.hpp>

#include <set>

namespace candelabra {

namespace {

const WebKey own_key{80, "secret"};

/// 0: incomplete; 200: accepted; otherwise the status of the refusal.
int status(const std::string& bytes, const WebKey& key = own_key) {
    const ReadRequest read = read_request(bytes, key);
    if (std::holds_alternative<std::monostate>(read)) return 0;
    const auto* const refusal = std::get_if<WebAnswer>(&read);
    if (refusal) CHECK(refusal->body.ends_with('\n'));
    return refusal ? refusal->status : 200;
}

std::string with(const std::string& headers, const std::string& line = "GET / HTTP/1.1") {
    return line + "\r\n" + headers + "\r\n\r\n";
}

std::string post(const std::string& headers, const std::string& body = "") {
    return with("Host: localhost:80\r\n" + headers, "POST /turn HTTP/1.1") + body;
}

}  // namespace

TEST_CASE("requests are read") {
    const auto read = read_request(
        "GET /pick?x=3&yy=4&y=5 HTTP/1.1\r\nA: b\r\nHOST: localhost:80\r\n\r\n", own_key);
    const auto& get = std::get<WebRequest>(read);
    CHECK_FALSE(get.post);
    CHECK(get.path == "/pick");
    CHECK(get.parameter("x") == "3");
    CHECK(get.parameter("y") == "5");
    CHECK(get.parameter("z").empty());
    const auto written =
        read_request(post("X-Token: secret\r\nContent-Length: 8", "name=A&v and no more"), own_key);
    CHECK(std::get<WebRequest>(written).post);
    CHECK(std::get<WebRequest>(written).path == "/turn");
    CHECK(std::get<WebRequest>(written).parameter("name") == "A");
}

TEST_CASE("a request is complete with its last byte") {
    const std::string whole = post("X-Token: secret\r\nContent-Length: 3", "x=1");
    for (std::size_t length = 0; length < whole.size(); ++length)
        CHECK(status(whole.substr(0, length)) == 0);
    CHECK(status(whole) == 200);
}

TEST_CASE("pages of other sites are refused") {
    const std::string host = "Host: localhost:80\r\n";
    CHECK(status(with("Host: localhost:80")) == 200);
    CHECK(status(with("Host: 127.0.0.1:80")) == 200);
    CHECK(status(with("Host: localhost")) == 200);
    CHECK(status(with("Host: localhost"), {8000, "secret"}) == 403);
    CHECK(status(with(host + "Origin: http://localhost:80")) == 200);
    CHECK(status(with(host + "Sec-Fetch-Site: same-origin")) == 200);
    CHECK(status(with(host + "Sec-Fetch-Site: none")) == 200);
    for (const char* bad :
         {"A: b", "Host: evil.example:80", "Host: localhost:81", "Host: localhost.evil.example:80",
          "Host:", "Host: localhost:80, evil.example", "Host: 127.0.0.1:080"}) {
        CAPTURE(bad);
        CHECK(status(with(bad)) == 403);
    }
    for (const char* bad :
         {"Origin: http://evil.example", "Origin: null", "Origin:", "Origin: https://localhost:80",
          "Origin: http://localhost:3000", "Origin: http://127.0.0.1:80",
          "Sec-Fetch-Site: cross-site", "Sec-Fetch-Site: same-site", "Sec-Fetch-Site: new-word"}) {
        CAPTURE(bad);
        CHECK(status(with(host + bad)) == 403);
        CHECK(status(post(std::string("X-Token: secret\r\nContent-Length: 0\r\n") + bad)) == 403);
    }
}

TEST_CASE("only the token lets something be changed") {
    CHECK(status(post("Content-Length: 0\r\nX-Token: secret")) == 200);
    CHECK(status(post("Content-Length: 0\r\nX-Token: secret\r\nSec-Fetch-Site: none")) == 403);
    for (const char* bad : {"A: b", "X-Token:", "X-Token: secreT", "X-Token: secret2",
                            "X-Token: secre", "Cookie: secret"}) {
        CAPTURE(bad);
        CHECK(status(post(std::string("Content-Length: 0\r\n") + bad)) == 403);
    }
    CHECK(status(post("Content-Length: 0\r\nX-Token:"), {80, ""}) == 403);
}

TEST_CASE("what is no request of HTTP has an answer") {
    for (const char* line :
         {"", "GET", "GET ", "GET /", "GET / ", "GET  HTTP/1.1", "GET a HTTP/1.1",
          "GET http://localhost:80/ HTTP/1.1", "GET / / HTTP/1.1", "GET / HTTP/2", "G(T / HTTP/1.1",
          "GET /\x01 HTTP/1.1", "GET / HTTP/1.1\nA: b", "\r\nGET / HTTP/1.1"}) {
        CAPTURE(line);
        CHECK(status(with("Host: localhost:80", line)) == 400);
    }
    for (const char* bad :
         {"A", ": b", "A : b", " A: b", "A: b\r\n c", "A: \x7f", "A: b\rHost: c",
          "Host: localhost:80", "Origin: http://localhost:80\r\norigin: http://localhost:80",
          "Content-Length: 1", "Content-Length: -1", "Content-Length: 0x1",
          "Content-Length:", "Content-Length: 0\r\nContent-Length: 0", "Content-Length: 0, 0"}) {
        CAPTURE(bad);
        CHECK(status(with(std::string("Host: localhost:80\r\n") + bad)) == 400);
    }
    CHECK(status(with("Host: localhost:80\r\n" + std::string("A: \0b", 5))) == 400);
    CHECK(status(with("Host: localhost:80", "DELETE / HTTP/1.1")) == 405);
    CHECK(status(with("Host: localhost:80", "HEAD / HTTP/1.1")) == 405);
}

TEST_CASE("requests have a size") {
    const std::string start = "GET / HTTP/1.1\r\nHost: localhost:80\r\nA: ";
    const std::string most(longest_head - start.size(), 'a');
    CHECK(status(start + most + "\r\n\r\n") == 200);
    CHECK(status(start + most) == 0);
    CHECK(status(start + most + "a\r\n\r\n") == 431);
    CHECK(status(start + most + "aaaa") == 431);
    const std::string token = "X-Token: secret\r\n", length = token + "Content-Length: ";
    CHECK(status(post(length + "4096", std::string(longest_body, 'a'))) == 200);
    CHECK(status(post(length + "4097")) == 413);
    CHECK(status(post(length + "99999999999999999999999")) == 413);
    CHECK(status(post("X-Token: secret")) == 411);
    CHECK(status(post("X-Token: secret\r\nTransfer-Encoding: chunked")) == 501);
}

TEST_CASE("every answer is closed to other sites") {
    for (const int code : {200, 403, 405, 503}) {
        const std::string sent = sent_form({"text/plain", "body", code});
        CHECK(sent.starts_with("HTTP/1.1 " + std::to_string(code) + " "));
        CHECK(sent.ends_with("\r\n\r\nbody"));
        for (const char* header :
             {"X-Content-Type-Options: nosniff", "Cross-Origin-Resource-Policy: same-origin",
              "frame-ancestors 'none'", "Referrer-Policy: no-referrer", "Cache-Control: no-store",
              "Content-Length: 4", "Connection: close", "default-src 'none'"})
            CHECK(sent.find(header) != sent.npos);
        CHECK((sent.find("Allow: GET, POST") != sent.npos) == (code == 405));
    }
}

TEST_CASE("scripts within a page run in a page that is whole, and in no other") {
    WebAnswer answer{"text/html", "body"};
    CHECK(sent_form(answer).find("script-src 'self'; ") != std::string::npos);
    answer.is_whole = true;
    CHECK(sent_form(answer).find("script-src 'unsafe-inline'; ") != std::string::npos);
}

TEST_CASE("an answer is saved under a name that can end no header") {
    const std::string sent = sent_form({"image/png", "body", 200, "a\"b\r\nX: c/../d-1.png"});
    CHECK(sent.find("\r\nContent-Disposition: attachment; "
                    "filename=\"a_b__X__c_.._d-1.png\"\r\n") != sent.npos);
    CHECK(sent_form({"image/png", "body"}).find("Disposition") == std::string::npos);
}

TEST_CASE("tokens are new each time") {
    std::set<std::string> seen;
    for (int i = 0; i < 100; ++i) seen.insert(new_token());
    CHECK(seen.size() == 100);
    for (const std::string& each : seen) CHECK(each.size() == 32);
}

TEST_CASE("other machines need the token, in the address or in a cookie") {
    const WebKey open_key{80, "secret", true};
    const auto asks = [&](const std::string& path, const std::string& headers) {
        const std::string line = "GET " + path + " HTTP/1.1";
        return status(with("Host: 192.168.1.7:80" + headers, line), open_key);
    };
    CHECK(asks("/", "") == 403);
    CHECK(asks("/?token=secret", "") == 200);
    CHECK(asks("/?x=1&token=secret", "\r\nSec-Fetch-Site: cross-site") == 200);
    CHECK(asks("/?token=", "") == 403);
    CHECK(asks("/?token=Secret", "") == 403);
    CHECK(asks("/?tokens=secret", "") == 403);
    CHECK(asks("/picture", "\r\nCookie: candelabra-80=secret") == 200);
    CHECK(asks("/picture", "\r\nCookie: a=b; candelabra-80=secret ;c=d") == 200);
    CHECK(asks("/picture", "\r\nCookie: candelabra-81=secret") == 403);
    CHECK(asks("/picture", "\r\nCookie: candelabra-80=secret\r\nCookie: a=b") == 400);
    CHECK(asks("/picture", "\r\nCookie: candelabra-80=secret\r\nOrigin: http://a.b") == 403);
    const auto turns = [&](const std::string& headers) {
        return status(with("Host: 192.168.1.7:80\r\nContent-Length: 0" + headers,
                           "POST /turn?token=secret HTTP/1.1"),
                      open_key);
    };
    CHECK(turns("") == 403);
    CHECK(turns("\r\nX-Token: secret") == 403);
    CHECK(turns("\r\nCookie: candelabra-80=secret") == 403);
    CHECK(turns("\r\nCookie: candelabra-80=secret\r\nX-Token: secret") == 200);
    // On the machine itself neither is asked for.
    CHECK(status(with("Host: localhost:80\r\nCookie: candelabra-80=other")) == 200);
}

}  // namespace candelabra
