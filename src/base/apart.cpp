// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/apart.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace candelabra {

namespace {

/// The size of this process's memory in bytes; 0 if the system does not tell.
std::uint64_t memory_now() {
    std::FILE* const file = std::fopen("/proc/self/statm", "re");
    if (!file) return 0;
    unsigned long long pages = 0;
    const int read = std::fscanf(file, "%llu", &pages);
    std::fclose(file);
    return read == 1 ? pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

void limit(decltype(RLIMIT_AS) resource, std::uint64_t most) {
    rlimit now{};
    if (::getrlimit(resource, &now) != 0) return;
    now.rlim_cur = std::min<rlim_t>(now.rlim_max, most);
    ::setrlimit(resource, &now);
}

void confine_child(const ApartLimits& limits) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    if (const std::uint64_t now = memory_now()) limit(RLIMIT_AS, now + limits.memory);
    limit(RLIMIT_CPU, limits.seconds);
    // The limit of time ends the process only if nothing handles or blocks its signal.
    ::signal(SIGXCPU, SIG_DFL);
    ::signal(SIGPIPE, SIG_IGN);
    sigset_t none;
    sigemptyset(&none);
    sigaddset(&none, SIGXCPU);
    ::sigprocmask(SIG_UNBLOCK, &none, nullptr);
}

/// Ends a process and waits for it, unless wait() has.
class Child {
public:
    explicit Child(pid_t process) : process_(process) {}
    ~Child() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);
        wait();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    int wait() {
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = 0;
        return status;
    }

private:
    pid_t process_;
};

std::string end_of(int status) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS) return {};
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return "it takes too long";
    return "it is damaged: its reader has crashed";
}

}  // namespace

MessageEnd::~MessageEnd() { ::close(descriptor_); }

bool MessageEnd::send(char kind, std::string_view text) {
    std::array<char, 1 + sizeof(std::uint64_t)> head{};
    const std::uint64_t size = text.size();
    head[0] = kind;
    std::memcpy(&head[1], &size, sizeof size);
    for (std::string_view rest : {std::string_view(head.data(), head.size()), text})
        while (!rest.empty()) {
            const ssize_t sent = ::send(descriptor_, rest.data(), rest.size(), MSG_NOSIGNAL);
            if (sent < 0 && errno == EINTR) continue;
            if (sent <= 0) return false;
            rest.remove_prefix(static_cast<std::size_t>(sent));
        }
    return true;
}

bool MessageEnd::fill(char* to, std::size_t size, FunctionRef<void()> waiting) {
    constexpr int milliseconds = 100;
    while (size > 0) {
        pollfd ready{descriptor_, POLLIN, 0};
        if (::poll(&ready, 1, milliseconds) == 0) {
            waiting();
            continue;
        }
        const ssize_t got = ::recv(descriptor_, to, size, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        to += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

std::optional<std::string> MessageEnd::receive(FunctionRef<void()> waiting) {
    std::array<char, 1 + sizeof(std::uint64_t)> head{};
    if (!fill(head.data(), head.size(), waiting)) return std::nullopt;
    std::uint64_t size = 0;
    std::memcpy(&size, &head[1], sizeof size);
    // What is announced need not come: room is made for what has come.
    constexpr std::uint64_t at_once = std::uint64_t{16} << 20;
    std::string message(1, head[0]);
    while (size > 0) {
        const std::size_t old = message.size();
        const auto more =
            static_cast<std::size_t>(std::min(size, std::max<std::uint64_t>(at_once, old)));
        message.resize(old + more);
        if (!fill(&message[old], more, waiting)) return std::nullopt;
        size -= more;
    }
    return message;
}

SharedMemory::SharedMemory(std::size_t most) {
    void* const made = ::mmap(nullptr, most, PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (made == MAP_FAILED) return;
    data_ = static_cast<char*>(made);
    size_ = most;
}

SharedMemory::~SharedMemory() {
    if (data_) ::munmap(data_, size_);
}

std::string work_apart(const ApartLimits& limits, FunctionRef<void(MessageEnd&)> work,
                       FunctionRef<void(MessageEnd&)> answer) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return std::string("no process can be made for it: ") + std::strerror(errno);
    const pid_t process = ::fork();
    if (process == 0) {
        ::close(ends[0]);
        confine_child(limits);
        try {
            MessageEnd end(ends[1]);
            work(end);
        } catch (...) {
            ::_exit(EXIT_FAILURE);
        }
        ::_exit(EXIT_SUCCESS);
    }
    ::close(ends[1]);
    MessageEnd end(ends[0]);
    if (process < 0) return std::string("no process can be made for it: ") + std::strerror(errno);
    Child child(process);
    answer(end);
    return end_of(child.wait());
}

}  // namespace candelabra
