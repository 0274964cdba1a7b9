// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/memory_limit.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>

namespace {

/// What the program says about a scene; its exit status at the end.
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
    const std::string text = said("--check --limit-memory 200 " + folder / "big.pov");
    INFO(text);
    CHECK(text.find("not enough memory to evaluate this scene") != std::string::npos);
    CHECK(text.find("--limit-memory") != std::string::npos);
    CHECK(text.find("status 1") != std::string::npos);
    // The loop is named.
    CHECK(text.find("big.pov:2:18") != std::string::npos);
    CHECK(text.find("this loop has run ") != std::string::npos);
}
