// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lsp.h"

#include "editor/language_server.h"
#include "text/message.h"

#include <array>
#include <filesystem>
#include <system_error>

#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

/// A folder for the files that scenes write while they are edited; removed by the destructor.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string pattern = (fs::temp_directory_path() / "candelabra-XXXXXX").string();
        if (const char* made = ::mkdtemp(pattern.data())) path = made;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        if (!path.empty()) fs::remove_all(path, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::string path;
};

/// Time without messages from the editor after which scenes are checked.
constexpr int pause_milliseconds = 150;

}  // namespace

std::optional<Framing::Message> MessageReader::next(int milliseconds) {
    while (true) {
        if (auto message = framing_.take()) return message;
        if (!framing_.lost().empty()) ended_ = true;
        if (ended_) return std::nullopt;
        pollfd waits{descriptor_, POLLIN, 0};
        if (::poll(&waits, 1, milliseconds) == 0) return std::nullopt;
        std::array<char, 65536> buffer;
        const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0)
            ended_ = true;
        else
            framing_.add({buffer.data(), static_cast<std::size_t>(count)});
    }
}

std::string MessageReader::problem() const {
    if (!framing_.lost().empty()) return framing_.lost();
    return ended_ && framing_.inside() ? "the stream ends inside a message" : "";
}

int run_lsp(int descriptor, const Console& console) {
    const ScratchFolder scratch;
    LanguageServer server(console.library, scratch.path, [&](const std::string& text) {
        console.out(message("Content-Length: ", text.size(), "\r\n\r\n", text));
    });
    MessageReader reader(descriptor);
    /// Handles the next message. Returns whether one came within the time.
    const auto handle = [&](int milliseconds) {
        const auto message = reader.next(milliseconds);
        if (message && message->skipped)
            server.receive_too_long();
        else if (message)
            server.receive(message->text);
        return message.has_value();
    };
    const Meanwhile serve{descriptor, [&] {
                              while (!server.ended() && handle(0)) {
                              }
                              return !reader.ended();
                          }};
    while (!server.ended() && !reader.ended())
        if (!handle(server.behind() ? pause_milliseconds : -1) && server.behind())
            server.catch_up(serve);
    if (server.ended()) return server.ended_well() ? exit_status::done : exit_status::usage;
    if (reader.problem().empty()) return exit_status::usage;
    console.err(message("error: the editor cannot be understood any more: ", reader.problem(),
                        "\nhelp: the editor starts `candelabra lsp` again\n"));
    return exit_status::scene;
}

}  // namespace candelabra
