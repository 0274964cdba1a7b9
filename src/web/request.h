// SPDX-License-Identifier: GPL-3.0-or-later
// Reads requests to the server of this machine from untrusted bytes, and writes the bytes of
// answers. A page of another site is refused, whatever name it uses for this machine. A request
// that changes something is a POST with the token that only the server's own page was given. If
// other machines may ask, each request needs the token: in the address, `/?token=...`, and then in
// a cookie, which the answer to that request sets. Uses no sockets.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

namespace candelabra {

struct WebRequest {
    bool post = false;       ///< false: GET
    std::string path;        ///< without the query: "/picture.png"
    std::string form;        ///< the query of a GET, or the body of a POST: "x=3&y=4"
    bool can_wait = false;   ///< the answer may be `later`
    bool has_token = false;  ///< in its address: the answer sets the cookie

    /// The value of a parameter of the form, not decoded; empty if there is none.
    std::string parameter(std::string_view name) const;
};

struct WebAnswer {
    std::string type;  ///< "text/html"
    std::string body;
    int status = 200;
    std::string saved_as =
        {};              ///< file name under which browsers save the answer; empty: they display it
    bool later = false;  ///< there is no answer yet: the request is repeated later
    std::string cookie = {};  ///< name=value that browsers keep for this server; empty: none
    bool is_whole = false;    ///< a page that has its scripts and pictures within it
};

/// Values that a request must match.
struct WebKey {
    int port = 0;       ///< of the server
    std::string token;  ///< header `X-Token` of each POST; not empty
    bool open = false;  ///< other machines may ask: every request needs the token
};

/// The cookie with the token, as name=value. Servers of several ports have cookies of their own.
std::string cookie_of(const WebKey&);

/// Limits, in bytes, of a request before its empty line, and after it.
inline constexpr std::size_t longest_head = 16384, longest_body = 4096;

/// The state of a request: incomplete, complete, or refused by an answer that says why. Status 400:
/// not HTTP, or a header occurs twice; 403: another site or a wrong token; 405: another method; 411
/// and 501: a body without a length; 413 and 431: a body or a head that is too long.
using ReadRequest = std::variant<std::monostate, WebRequest, WebAnswer>;
ReadRequest read_request(std::string_view bytes, const WebKey&);

/// The answer as it is sent, with headers that forbid other sites to frame or include it.
std::string sent_form(const WebAnswer&);

/// A new unguessable token of 32 characters; empty if the system gives no random bytes.
std::string new_token();

}  // namespace candelabra
