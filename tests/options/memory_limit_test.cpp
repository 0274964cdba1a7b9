// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/memory_limit.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>

namespace candelabra {

namespace {

/// Returns the output of the program for a scene, followed by its exit status.
std::string said(const std::string& arguments) {
    const std::string command = CANDELABRA_BINARY " " + arguments + " 2>&1; echo status $?";
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 4096> buffer;
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
        output.append(buffer.data(), n);
    pclose(pipe);
    return output;
}

}  // namespace

TEST_CASE("the machine tells how much memory it has", "[app]") {
    CHECK(physical_memory().value_or(0) > std::uint64_t{1} << 26);
}

TEST_CASE("as much memory again must fit into the limit", "[app]") {
    CHECK(memory_in_use() > 1 << 20);
    CHECK(memory_in_use() < physical_memory().value_or(0));
    CHECK(may_double(100, 200));
    CHECK_FALSE(may_double(101, 200));
    CHECK_FALSE(may_double(0, 200));  // unknown
    CHECK(may_double(1 << 20, {}));
}

TEST_CASE("a scene that takes too much memory gets a message", "[app]") {
    const Folder folder;
    folder.put("big.pov", R"(#version 3.7; #declare S = "0123456789";
        #for (i, 1, 60) #declare S = concat(S, S); #end)");
    const std::string text =
        said("--check --limit-memory 200 --limit-text 1000000 " + folder / "big.pov");
    INFO(text);
    CHECK(text.find("not enough memory to evaluate this scene") != std::string::npos);
    CHECK(text.find("--limit-memory") != std::string::npos);
    CHECK(text.find("status 1") != std::string::npos);
    // The message names the loop.
    CHECK(text.find("big.pov:2:18") != std::string::npos);
    CHECK(text.find("this loop has run ") != std::string::npos);
}

TEST_CASE("a million lamps in unions that stand in many places take little memory", "[app]") {
    const Folder folder;
    const std::string text =
        said("+W16 +H12 --samples 1 +WT1 --limit-memory 100 -o " +
             folder / "city.png " CANDELABRA_SOURCE_DIR "/tests/bench/blocks.pov");
    INFO(text);
    CHECK(text.find("1000000 luminaires") != std::string::npos);
    CHECK(text.find("status 0") != std::string::npos);
}

TEST_CASE("the usual limit is half of what is free, for the machine and for the group", "[app]") {
    const Folder folder;
    const std::string root = folder / "";
    const auto usual = [&] { return usual_memory_limit(root).value_or(0); };
    CHECK(usual() == 0);
    folder.put("proc/meminfo", "MemTotal: 9000 kB\nMemFree: 10 kB\nMemAvailable:   4000 kB\n");
    CHECK(usual() == 2000 * 1024);
    folder.put("proc/self/cgroup", "0::/user/job\n");
    CHECK(usual() == 2000 * 1024);
    folder.put("sys/fs/cgroup/user/job/memory.max", "max\n");
    CHECK(usual() == 2000 * 1024);
    folder.put("sys/fs/cgroup/user/job/memory.max", "1000000\n");
    CHECK(usual() == 500'000);
    folder.put("sys/fs/cgroup/user/job/memory.current", "600000\n");
    CHECK(usual() == 200'000);
    // The page cache can be dropped.
    folder.put("sys/fs/cgroup/user/job/memory.stat", "anon 100\nfile 300000\n");
    CHECK(usual() == 350'000);
    folder.put("sys/fs/cgroup/user/memory.max", "400000\n");
    CHECK(usual() == 200'000);
    folder.put("sys/fs/cgroup/memory.max", "100\n");
    folder.put("sys/fs/cgroup/memory.current", "1000\n");
    CHECK(usual() == 0);
    const std::uint64_t here = usual_memory_limit().value_or(0);
    CHECK(here > 0);
    CHECK(here <= physical_memory().value_or(0) / 2);
}

TEST_CASE("the older groups of control are known", "[app]") {
    const Folder folder;
    folder.put("proc/meminfo", "MemAvailable: 4000 kB\n");
    folder.put("proc/self/cgroup", "12:cpu,cpuacct:/a\n7:memory:/a\n0::/\n");
    folder.put("sys/fs/cgroup/memory/a/memory.limit_in_bytes", "2000000\n");
    folder.put("sys/fs/cgroup/memory/a/memory.usage_in_bytes", "1000000\n");
    folder.put("sys/fs/cgroup/memory/a/memory.stat", "cache 1\ntotal_cache 200000\n");
    CHECK(usual_memory_limit(folder / "") == 600'000);
}

}  // namespace candelabra
