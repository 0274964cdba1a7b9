// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/confine.h"

#include "support/apart.h"
#include "support/folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace candelabra {

namespace {

/// Rights of a confined process, as bits. The process of the tests is not confined.
enum Goes {
    reads_inside = 1,
    reads_outside = 2,
    writes_inside = 4,
    writes_outside = 8,
    sockets = 16,
    programs = 32
};

bool opens(const std::string& path, int how) {
    const int file = ::open(path.c_str(), how, 0600);
    if (file >= 0) ::close(file);
    return file >= 0;
}

int tried(const SandboxRules& rules, const std::string& inside, const std::string& outside) {
    return apart([&] {
        if (!confine(rules)) return 64;
        const pid_t child = ::vfork();
        if (child == 0) {
            ::execl("/bin/true", "true", nullptr);
            ::_exit(1);
        }
        int status = 1;
        if (child > 0) ::waitpid(child, &status, 0);
        return (opens(inside + "/a", O_RDONLY) ? reads_inside : 0) |
               (opens(outside + "/a", O_RDONLY) ? reads_outside : 0) |
               (opens(inside + "/b", O_WRONLY | O_CREAT) ? writes_inside : 0) |
               (opens(outside + "/b", O_WRONLY | O_CREAT) ? writes_outside : 0) |
               (::socket(AF_INET, SOCK_STREAM, 0) >= 0 ? sockets : 0) |
               (child > 0 && status == 0 ? programs : 0);
    });
}

}  // namespace

TEST_CASE("a confined process reaches what its rules name, and nothing else", "[app]") {
    const Folder folder;
    const std::string in = (folder.path() / "in").string(), out = (folder.path() / "out").string();
    for (const std::string& each : {in, out}) {
        std::filesystem::create_directories(each);
        std::ofstream(each + "/a") << "text";
    }
    const int free = tried({{"/"}, {"/"}, true, true}, in, out);
    if (free == 64) {
        WARN("this system has no Landlock or no seccomp");
        return;
    }
    CHECK(free ==
          (reads_inside | reads_outside | writes_inside | writes_outside | sockets | programs));
    CHECK(tried({{in}, {}}, in, out) == reads_inside);
    CHECK(tried({{}, {in}}, in, out) == (reads_inside | writes_inside));
    CHECK(tried({{in, "/usr", "/lib", "/lib64", "/bin", "/etc"}, {}, false, true}, in, out) ==
          (reads_inside | programs));
    CHECK(tried({{in}, {}, true, false}, in, out) == (reads_inside | sockets));
}

}  // namespace candelabra
