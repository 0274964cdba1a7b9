// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a process of its own, for tests of what cannot be undone.
#pragma once

#include <catch2/catch.hpp>

#include <functional>

#include <sys/wait.h>
#include <unistd.h>

namespace candelabra {

/// Runs the work in a child process and returns its exit status.
inline int apart(const std::function<int()>& work) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) ::_exit(work());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace candelabra
