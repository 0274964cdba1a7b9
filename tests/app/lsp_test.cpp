// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lsp.h"

#include <catch2/catch.hpp>

#include <unistd.h>

namespace candelabra {

namespace {

/// A pipe whose other end the test writes to.
struct Pipe {
    int ends[2] = {-1, -1};

    Pipe() { REQUIRE(::pipe(ends) == 0); }
    ~Pipe() {
        ::close(ends[0]);
        close();
    }
    void write(const std::string& text) {
        REQUIRE(::write(ends[1], text.data(), text.size()) == ssize_t(text.size()));
    }
    void send(const std::string& message) {
        write("Content-Length: " + std::to_string(message.size()) + "\r\n\r\n" + message);
    }
    void close() {
        if (ends[1] >= 0) ::close(ends[1]);
        ends[1] = -1;
    }
};

}  // namespace

TEST_CASE("messages are read however they are cut") {
    Pipe pipe;
    MessageReader reader(pipe.ends[0]);
    CHECK_FALSE(reader.next(0));
    pipe.write("Content-Length: 5\r\nOther: x\r\n\r\nab");
    CHECK_FALSE(reader.next(0));
    pipe.write("cdeContent-Length: 2\r\n\r\nfg");
    CHECK(reader.next(-1)->text == "abcde");
    CHECK(reader.next(-1)->text == "fg");
    pipe.close();
    CHECK_FALSE(reader.next(-1));
    CHECK(reader.ended());
    CHECK(reader.problem().empty());
}

TEST_CASE("a stream that is lost ends the server with a message") {
    for (const char* bytes : {"Content-Length: -1\r\n\r\n{}", "Content-Length: 9\r\n\r\n{}",
                              "Content-Le", "Content-Length: 5000000000\r\n\r\n{}", "\r\n\r\n"}) {
        CAPTURE(bytes);
        Pipe pipe;
        pipe.write(bytes);
        pipe.close();
        std::string said;
        Console console;
        console.out = [](std::string_view) {};
        console.err = [&](std::string_view text) { said += text; };
        CHECK(run_lsp(pipe.ends[0], console) == 1);
        CHECK(said.starts_with("error: the editor cannot be understood any more: "));
    }
}

TEST_CASE("a whole conversation goes through the streams") {
    Pipe pipe;
    pipe.send(R"({"id": 1, "method": "initialize", "params": {}})");
    pipe.send(R"({"method": "textDocument/didOpen", "params": {"textDocument":
        {"uri": "file:///none/a.pov", "text": "sphere { 0, Size }"}}})");
    pipe.send(R"({"id": 2, "method": "shutdown"})");
    pipe.send(R"({"method": "exit"})");
    std::string said;
    Console console;
    console.out = [&](std::string_view text) { said += text; };
    CHECK(run_lsp(pipe.ends[0], console) == exit_status::done);
    CHECK(said.find("hoverProvider") != said.npos);
    Pipe closed;
    closed.close();
    CHECK(run_lsp(closed.ends[0], console) == exit_status::usage);
}

}  // namespace candelabra
