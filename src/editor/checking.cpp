// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/checking.h"

#include "interpret/limits.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <new>
#include <optional>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace candelabra {

namespace {

using ByPath = std::map<std::string, std::vector<Json>>;
using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_report = std::size_t{1} << 26;
constexpr int no_memory = 3;  ///< exit status of a check that ran out of memory

/// The reading and the writing end of a pipe, closed on destruction.
class Ends {
public:
    Ends() { made_ = ::pipe(ends_.data()) == 0; }
    ~Ends() {
        close(0);
        close(1);
    }
    Ends(const Ends&) = delete;
    Ends& operator=(const Ends&) = delete;

    bool made() const { return made_; }
    int operator[](std::size_t i) const { return ends_[i]; }
    void close(std::size_t i) {
        if (ends_[i] >= 0) ::close(ends_[i]);
        ends_[i] = -1;
    }

private:
    std::array<int, 2> ends_ = {-1, -1};
    bool made_ = false;
};

/// Performs the check in the child process, and exits.
[[noreturn]] void check_here(const Workspace& workspace, const std::string& path,
                             const std::string& folder, std::uint64_t bytes, int output) {
    // The child must end if the language server does.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::signal(signal, SIG_DFL);
    const rlim_t most = bytes + Limits().stack_bytes;
    const rlimit memory{most, most}, no_core{0, 0};
    ::setrlimit(RLIMIT_DATA, &memory);
    ::setrlimit(RLIMIT_CORE, &no_core);
    int status = 0;
    try {
        Report result;
        report(workspace, path, folder, result);
        const std::string text = Json(problems(result, workspace, path))
                                     .dump(-1, ' ', false, Json::error_handler_t::replace);
        for (std::size_t sent = 0; sent < text.size();) {
            const ssize_t count = ::write(output, text.data() + sent, text.size() - sent);
            if (count < 0 && errno != EINTR) break;
            sent += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
        }
    } catch (const std::bad_alloc&) {
        status = no_memory;
    }
    ::_exit(status);
}

/// Returns everything that is sent; nothing if it takes too long or is too much, or `stopped` is
/// set because other work goes before.
std::optional<std::string> received(int input, Clock::time_point end, const Meanwhile& meanwhile,
                                    bool& stopped) {
    std::string text;
    std::array<char, 65536> part;
    while (text.size() <= longest_report) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        std::array<pollfd, 2> waits = {{{input, POLLIN, 0}, {meanwhile.descriptor, POLLIN, 0}}};
        const int ready = left > 0 ? ::poll(waits.data(), waits.size(), static_cast<int>(left)) : 0;
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) break;
        if (waits[1].revents != 0 && !meanwhile.serve()) {
            stopped = true;
            break;
        }
        if (waits[0].revents == 0) continue;
        const ssize_t count = ::read(input, part.data(), part.size());
        if (count == 0) return text;
        if (count > 0) text.append(part.data(), static_cast<std::size_t>(count));
    }
    return std::nullopt;
}

int status_of(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

ByPath unchecked(const std::string& path, const std::string& why) {
    const Json top = {{"line", 0}, {"character", 0}};
    return {{path,
             {{{"range", {{"start", top}, {"end", top}}},
               {"severity", 2},
               {"source", "candelabra"},
               {"message", message("this scene is not checked: ", why)}}}}};
}

}  // namespace

std::map<std::string, std::vector<Json>> check(const Workspace& workspace, const std::string& path,
                                               const std::string& folder_for_writing,
                                               const CheckLimits& limits,
                                               const Meanwhile& meanwhile) {
    const auto end = Clock::now() + std::chrono::milliseconds(limits.milliseconds);
    Ends ends;
    const pid_t process = ends.made() ? ::fork() : -1;
    if (process < 0) return unchecked(path, "the system starts no other process");
    if (process == 0) check_here(workspace, path, folder_for_writing, limits.bytes, ends[1]);
    ends.close(1);
    bool stopped = false;
    const auto text = received(ends[0], end, meanwhile, stopped);
    if (!text) ::kill(process, SIGKILL);
    const int status = status_of(process);
    if (stopped) return {};
    if (!text)
        return unchecked(path,
                         message("that takes more than ", limits.milliseconds / 1000.0,
                                 " s\nhelp: a loop that takes long can be shorter while one types; "
                                 "rendering has no such limit"));
    const std::string memory = message("that takes more than ", limits.bytes >> 20,
                                       " MB\nhelp: rendering has a limit of its own, "
                                       "--limit-memory");
    if (WIFEXITED(status) && WEXITSTATUS(status) == no_memory) return unchecked(path, memory);
    if (!WIFEXITED(status)) return unchecked(path, "the check has broken off");
    const Json found = Json::parse(*text, nullptr, false);
    if (!found.is_object()) return unchecked(path, "the check has broken off");
    return found.get<ByPath>();
}

}  // namespace candelabra
