// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lsp.h"

#include "editor/language_server.h"
#include "text/message.h"

#include <array>
#include <charconv>
#include <filesystem>

#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

/// A folder for the files that scenes write while they are edited; gone with the object.
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

/// How long the editor must be silent before mistakes are looked for.
constexpr int pause_milliseconds = 150;

}  // namespace

std::optional<std::string> MessageReader::take() {
    constexpr std::string_view blank_line = "\r\n\r\n", length_name = "Content-Length: ";
    const std::size_t head = waiting_.find(blank_line);
    if (head == waiting_.npos) return std::nullopt;
    const std::size_t at = waiting_.find(length_name);
    std::size_t length = 0;
    if (at < head)
        std::from_chars(waiting_.data() + at + length_name.size(), waiting_.data() + head, length);
    const std::size_t first = head + blank_line.size();
    if (waiting_.size() - first < length) return std::nullopt;
    std::string message = waiting_.substr(first, length);
    waiting_.erase(0, first + length);
    return message;
}

std::optional<std::string> MessageReader::next(int milliseconds) {
    while (true) {
        if (auto message = take()) return message;
        if (ended_) return std::nullopt;
        pollfd waits{descriptor_, POLLIN, 0};
        if (::poll(&waits, 1, milliseconds) == 0) return std::nullopt;
        std::array<char, 65536> buffer;
        const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0)
            ended_ = true;
        else
            waiting_.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

int run_lsp(int descriptor, const Console& console) {
    const ScratchFolder scratch;
    LanguageServer server(console.library, scratch.path, [&](const std::string& text) {
        console.out(message("Content-Length: ", text.size(), "\r\n\r\n", text));
    });
    MessageReader reader(descriptor);
    while (!server.ended() && !reader.ended()) {
        if (const auto message = reader.next(server.behind() ? pause_milliseconds : -1))
            server.receive(*message);
        else if (server.behind())
            server.catch_up();
    }
    return server.ended_well() ? exit_status::done : exit_status::usage;
}
