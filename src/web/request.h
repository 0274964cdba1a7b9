// SPDX-License-Identifier: GPL-3.0-or-later
// A request that came to the server of this machine, from bytes that anybody may have sent, and the
// bytes of its answer. A page of another site is not let in, whatever name it uses for this
// machine; what changes something is a POST with the token that only the own page was given. Knows
// no sockets.
#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace candelabra {

struct WebRequest {
    bool post = false;      ///< else GET
    std::string path;       ///< without the query: "/picture.png"
    std::string form;       ///< of a GET behind the question mark, of a POST its body: "x=3&y=4"
    bool can_wait = false;  ///< the answer may be `later`

    /// The value of a parameter of the form, as it is written; empty when there is none.
    std::string parameter(std::string_view name) const;
};

struct WebAnswer {
    std::string type;  ///< "text/html"
    std::string body;
    int status = 200;
    std::string saved_as =
        {};              ///< the name of a file that browsers save it as; empty: they show it
    bool later = false;  ///< there is nothing to say yet: the request is put again after a while
};

/// What a request must know.
struct WebKey {
    int port = 0;       ///< the server's, on 127.0.0.1
    std::string token;  ///< header `X-Token` of each POST; not empty
};

/// Bytes of a request up to its empty line, and behind that.
inline constexpr std::size_t longest_head = 16384, longest_body = 4096;

/// What the bytes are so far: nothing yet, as more must come; a request; or the answer that refuses
/// it, in words. Status 400 what is no HTTP or has a header twice, 403 other sites and wrong
/// tokens, 405 other methods, 411 and 501 a body without a length, 413 and 431 one or a head that
/// is too long.
using ReadRequest = std::variant<std::monostate, WebRequest, WebAnswer>;
ReadRequest read_request(std::string_view bytes, const WebKey&);

/// The answer as it is sent, closed to other sites: they can neither frame nor include it.
std::string sent_form(const WebAnswer&);

/// A new token, of 32 characters that nobody guesses; empty when the system gives no chance.
std::string new_token();

}  // namespace candelabra
