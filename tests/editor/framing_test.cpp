// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/framing.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string framed(const std::string& text) {
    return "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text;
}

}  // namespace

TEST_CASE("messages come out as they went in, however they are cut") {
    const std::string stream = framed("abc") + framed("") + "X: y\r\ncontent-length:2 \r\n\r\nde";
    for (std::size_t cut = 1; cut < stream.size(); ++cut) {
        Framing framing;
        std::string seen;
        for (std::size_t at = 0; at < stream.size(); at += cut) {
            framing.add(std::string_view(stream).substr(at, cut));
            while (const auto message = framing.take()) seen += message->text + '|';
        }
        CHECK(seen == "abc||de|");
        CHECK(framing.lost().empty());
        CHECK_FALSE(framing.inside());
    }
}

TEST_CASE("a stream is lost where no length can be believed") {
    struct Case {
        const char *head, *why;
    };
    for (const Case& each : {
             Case{"", "a message has no Content-Length"},
             Case{"A: b", "a message has no Content-Length"},
             Case{"Content-Length: -1", "the Content-Length of a message is no number"},
             Case{"Content-Length: ", "the Content-Length of a message is no number"},
             Case{"Content-Length: 1 1", "the Content-Length of a message is no number"},
             Case{"Content-Length: 1e1", "the Content-Length of a message is no number"},
             Case{"Content-Length: 4294967297", "a message has more than 4294967296 bytes"},
             Case{"Content-Length: 99999999999999999999",
                  "a message has more than 4294967296 bytes"},
             Case{"Content-Length: 1\r\nContent-Length: 1", "a message has two lengths"},
             Case{"Content-Length: 1\r\nnoise", "a line in the head of a message is no header"},
             Case{": 1", "a line in the head of a message is no header"},
         }) {
        CAPTURE(each.head);
        Framing framing;
        framing.add(each.head + std::string("\r\n\r\n{}"));
        CHECK_FALSE(framing.take());
        CHECK(framing.lost() == each.why);
        framing.add(framed("{}"));
        CHECK_FALSE(framing.take());
    }
    Framing framing;
    framing.add(std::string(Framing::longest_head, 'a'));
    CHECK_FALSE(framing.take());
    CHECK(framing.lost().empty());
    framing.add("a");
    CHECK_FALSE(framing.take());
    CHECK(framing.lost() == "the head of a message has more than 4096 bytes");
}

TEST_CASE("a message that is too long is passed over, and takes no memory") {
    Framing framing;
    constexpr std::uint64_t length = Framing::longest_message + 1;
    framing.add("Content-Length: " + std::to_string(length) + "\r\n\r\nab");
    CHECK_FALSE(framing.take());
    CHECK(framing.inside());
    const std::string part(1 << 20, 'x');
    std::uint64_t left = length - 2;
    for (; left > part.size(); left -= part.size()) {
        framing.add(part);
        REQUIRE_FALSE(framing.take());
    }
    framing.add(part.substr(0, static_cast<std::size_t>(left)) + framed("next"));
    const auto skipped = framing.take();
    REQUIRE(skipped);
    CHECK(skipped->skipped);
    CHECK(skipped->text.empty());
    CHECK(framing.take()->text == "next");
}

}  // namespace candelabra
