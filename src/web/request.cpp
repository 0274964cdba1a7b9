// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/request.h"

#include "text/ascii.h"
#include "text/message.h"
#include "text/trimmed.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

namespace candelabra {

namespace {

constexpr std::string_view line_end = "\r\n", head_end = "\r\n\r\n";

struct Header {
    std::string_view name, value;
};

struct Head {
    std::string_view method, target;
    std::vector<Header> headers;

    const Header* find(std::string_view name) const {
        const auto found = std::ranges::find_if(
            headers, [&](const Header& each) { return same_letters(each.name, name); });
        return found == headers.end() ? nullptr : &*found;
    }
};

/// Headers that are read must occur once: otherwise another program may have read the other one.
constexpr auto read_headers =
    std::to_array<std::string_view>({"Host", "Origin", "Sec-Fetch-Site", "Content-Length",
                                     "Transfer-Encoding", "X-Token", "Cookie"});

WebAnswer refusal(int status, std::string_view why) {
    return {"text/plain; charset=utf-8", message(why, '\n'), status};
}

bool printed(std::string_view text) {
    return std::ranges::all_of(text, [](char c) {
        return c == '\t' || (static_cast<unsigned char>(c) >= ' ' && c != '\x7f');
    });
}

/// Whether the text may be a method or the name of a header.
bool is_token(std::string_view text) {
    return !text.empty() &&
           std::ranges::all_of(text, [](char c) { return in_name(c) || c == '-'; });
}

constexpr std::string_view http_blanks = " \t";

bool read_first_line(std::string_view line, Head& head) {
    const std::size_t first = line.find(' '), last = line.rfind(' ');
    if (first == line.npos || first == last) return false;
    head.method = line.substr(0, first);
    head.target = line.substr(first + 1, last - first - 1);
    const std::string_view version = line.substr(last + 1);
    return is_token(head.method) && head.target.starts_with('/') &&
           head.target.find_first_of(" \t") == head.target.npos &&
           (version == "HTTP/1.1" || version == "HTTP/1.0");
}

/// Returns nothing if the text is not a head of HTTP.
std::optional<Head> read_head(std::string_view text) {
    Head head;
    for (bool first = true; first || !text.empty(); first = false) {
        const std::string_view line = text.substr(0, text.find(line_end));
        text.remove_prefix(std::min(text.size(), line.size() + line_end.size()));
        if (!printed(line)) return std::nullopt;
        if (first) {
            if (!read_first_line(line, head)) return std::nullopt;
            continue;
        }
        const std::size_t colon = line.find(':');
        if (colon == line.npos || !is_token(line.substr(0, colon))) return std::nullopt;
        head.headers.push_back(
            {line.substr(0, colon), trimmed(line.substr(colon + 1), http_blanks)});
    }
    return head;
}

bool comes_twice(const Head& head, std::string_view name) {
    return std::ranges::count_if(
               head.headers, [&](const Header& each) { return same_letters(each.name, name); }) > 1;
}

/// Compares in a time that does not depend on how much of the guess is right.
bool same_secret(std::string_view guess, std::string_view secret) {
    if (guess.size() != secret.size() || secret.empty()) return false;
    int difference = 0;
    for (std::size_t i = 0; i < secret.size(); ++i) difference |= guess[i] ^ secret[i];
    return difference == 0;
}

/// Whether the host is a name of this machine that no name server can give to another site's page.
bool is_own_host(std::string_view host, int port) {
    for (const std::string_view name : {"localhost", "127.0.0.1"})
        if (same_letters(host, message(name, ':', port)) ||
            (port == 80 && same_letters(host, name)))
            return true;
    return false;
}

std::string_view query_of(const Head& head) {
    return head.target.substr(std::min(head.target.find('?'), head.target.size() - 1) + 1);
}

/// The value of a parameter of `x=3&y=4`, not decoded; empty if there is none.
std::string_view parameter_of(std::string_view form, std::string_view name) {
    while (!form.empty()) {
        std::string_view pair = take_until(form, "&");
        if (take_until(pair, "=") == name) return pair;
    }
    return {};
}

bool token_in_address(const Head& head, const WebKey& key) {
    return key.open && same_secret(parameter_of(query_of(head), "token"), key.token);
}

bool token_in_cookie(const Head& head, const WebKey& key) {
    const Header* const header = head.find("Cookie");
    if (!header) return false;
    bool found = false;
    for (std::string_view cookies = header->value; !cookies.empty();)
        found |= same_secret(trimmed(take_until(cookies, ";"), http_blanks), cookie_of(key));
    return found;
}

/// The reason why the request comes neither from the own page nor from a typed address, or empty.
std::string_view foreign(const Head& head, const WebKey& key) {
    // Who has the token may come from anywhere, such as a mail.
    if (head.method == "GET" && token_in_address(head, key)) return {};
    const Header* const host = head.find("Host");
    if (!host || !(key.open || is_own_host(host->value, key.port)))
        return "the address must be the one that the program has printed";
    if (key.open && !token_in_cookie(head, key))
        return "the address must be the whole one that the program has printed, with its token";
    const Header* const origin = head.find("Origin");
    if (origin && !same_letters(origin->value, message("http://", host->value)))
        return "the request comes from a page of another site";
    const Header* const site = head.find("Sec-Fetch-Site");
    const bool typed = site && site->value == "none" && head.method == "GET";
    if (site && site->value != "same-origin" && !typed)
        return "another site leads here; type or paste the address instead";
    return {};
}

/// The length of the body, or the answer that refuses it.
std::variant<std::size_t, WebAnswer> body_length(const Head& head) {
    if (head.find("Transfer-Encoding")) return refusal(501, "a body must have a Content-Length");
    const Header* const header = head.find("Content-Length");
    if (!header && head.method == "POST") return refusal(411, "a body must have a Content-Length");
    if (!header) return std::size_t{0};
    const std::string_view digits = header->value;
    if (digits.empty() || !std::ranges::all_of(digits, is_digit))
        return refusal(400, "Content-Length is no number");
    std::size_t length = 0;
    const auto [end, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), length);
    if (problem != std::errc() || length > longest_body)
        return refusal(413, message("a body has at most ", longest_body, " bytes"));
    if (length > 0 && head.method != "POST") return refusal(400, "GET has no body");
    return length;
}

/// The answer that refuses the head, if any.
std::optional<WebAnswer> refused(const Head& head, const WebKey& key) {
    for (const std::string_view name : read_headers)
        if (comes_twice(head, name)) return refusal(400, message("`", name, "` comes twice"));
    if (const std::string_view why = foreign(head, key); !why.empty()) return refusal(403, why);
    if (head.method != "GET" && head.method != "POST")
        return refusal(405, "there are GET and POST");
    if (head.method == "GET") return std::nullopt;
    const Header* const token = head.find("X-Token");
    if (!token || !same_secret(token->value, key.token))
        return refusal(403, "the token is missing or of another run: load the page again");
    return std::nullopt;
}

}  // namespace

std::string cookie_of(const WebKey& key) {
    return message("candelabra-", key.port, "=", key.token);
}

std::string WebRequest::parameter(std::string_view name) const {
    return std::string(parameter_of(form, name));
}

ReadRequest read_request(std::string_view bytes, const WebKey& key) {
    const std::size_t end = bytes.find(head_end);
    // An incomplete head may already have the first bytes of the empty line.
    if (end == bytes.npos ? bytes.size() >= longest_head + head_end.size() : end > longest_head)
        return refusal(431, message("a head has at most ", longest_head, " bytes"));
    if (end == bytes.npos) return std::monostate();
    const auto head = read_head(bytes.substr(0, end));
    if (!head) return refusal(400, "this is no request of HTTP/1.1");
    if (auto answer = refused(*head, key)) return std::move(*answer);
    auto length = body_length(*head);
    if (auto* const answer = std::get_if<WebAnswer>(&length)) return std::move(*answer);
    const std::string_view body = bytes.substr(end + head_end.size());
    const std::size_t wanted = std::get<std::size_t>(length);
    if (body.size() < wanted) return std::monostate();
    const bool post = head->method == "POST";
    WebRequest request;
    request.post = post;
    request.path = head->target.substr(0, head->target.find('?'));
    request.form = post ? body.substr(0, wanted) : query_of(*head);
    request.has_token = token_in_address(*head, key);
    return request;
}

namespace {

/// The header that sets a cookie. Pages and scripts of other sites neither read nor send it.
std::string cookie_header(std::string_view cookie) {
    if (cookie.empty()) return {};
    return message("\r\nSet-Cookie: ", cookie, "; Path=/; HttpOnly; SameSite=Strict");
}

/// The header for a saved file. Characters that could end the file's name are replaced.
std::string disposition(std::string_view name) {
    if (name.empty()) return {};
    std::string safe;
    for (const char c : name) safe += in_name(c) || c == '.' || c == '-' ? c : '_';
    return message("\r\nContent-Disposition: attachment; filename=\"", safe, "\"");
}

}  // namespace

std::string sent_form(const WebAnswer& answer) {
    return message("HTTP/1.1 ", answer.status, " -\r\nContent-Type: ", answer.type,
                   "\r\nContent-Length: ", answer.body.size(),
                   answer.status == 405 ? "\r\nAllow: GET, POST" : "", disposition(answer.saved_as),
                   cookie_header(answer.cookie),
                   "\r\nCache-Control: no-store"
                   "\r\nX-Content-Type-Options: nosniff"
                   "\r\nX-Frame-Options: DENY"
                   "\r\nReferrer-Policy: no-referrer"
                   "\r\nCross-Origin-Resource-Policy: same-origin"
                   "\r\nCross-Origin-Opener-Policy: same-origin"
                   "\r\nContent-Security-Policy: default-src 'none'; script-src ",
                   answer.is_whole ? "'unsafe-inline'" : "'self'",
                   "; style-src 'self' 'unsafe-inline'; img-src ",
                   answer.is_whole ? "data: blob:" : "'self'",
                   "; connect-src 'self'; "
                   "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
                   "\r\nConnection: close\r\n\r\n",
                   answer.body);
}

std::string new_token() {
    std::array<unsigned char, 16> bytes;
    if (::getentropy(bytes.data(), bytes.size()) != 0) return {};
    constexpr std::string_view digits = "0123456789abcdef";
    std::string token;
    for (const unsigned char byte : bytes) {
        token += digits[byte / 16];
        token += digits[byte % 16];
    }
    return token;
}

}  // namespace candelabra
