// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/layers.h"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <filesystem>
#include <fstream>

#include <sys/inotify.h>
#include <unistd.h>

namespace candelabra {

namespace {

LayeredPicture example() {
    LayeredPicture picture{3, 2, {}, {{"candelabraIdentity", "a=1\nb=2\n"}}};
    picture.planes.push_back({"samples", true, {0, 1, 0xffffffffu, 3, 4, 0x80000000u}});
    picture.planes.push_back({"R", false, {}});
    for (const float value : {0.0f, 1.5f, -2.0f, 1e30f, 0.1f, 7.0f})
        picture.planes[1].bits.push_back(std::bit_cast<std::uint32_t>(value));
    return picture;
}

}  // namespace

TEST_CASE("planes and texts come back bit by bit; a damaged file is an error") {
    const std::string path = std::filesystem::temp_directory_path() / "candelabra_layers.exr";
    Diagnostics diagnostics;
    const LayeredPicture made = example();
    const auto bytes = encode(made, diagnostics);
    REQUIRE(bytes);
    std::ofstream(path, std::ios::binary) << *bytes;
    const std::string_view wanted[] = {"candelabraIdentity", "none"};
    const auto read = read_layers(path, wanted, diagnostics);
    REQUIRE(read);
    CHECK(read->width == 3);
    CHECK(read->height == 2);
    CHECK(read->texts[0].second == "a=1\nb=2\n");
    CHECK(read->texts[1].second.empty());
    REQUIRE(read->planes.size() == 2);
    for (const ChannelPlane& plane : made.planes) {
        const auto found = std::ranges::find(read->planes, plane.name, &ChannelPlane::name);
        REQUIRE(found != read->planes.end());
        CHECK(found->whole == plane.whole);
        CHECK(found->bits == plane.bits);
    }
    CHECK(diagnostics.all().empty());

    for (const std::size_t length : {std::size_t{0}, std::size_t{5}, bytes->size() / 2}) {
        CAPTURE(length);
        std::ofstream(path, std::ios::binary) << bytes->substr(0, length);
        Diagnostics problems;
        CHECK_FALSE(read_layers(path, wanted, problems));
        CHECK(problems.error_count() == 1);
    }
    std::filesystem::remove(path);
}

TEST_CASE("a file of layers has no date, which would be wrong or change its bytes") {
    Diagnostics diagnostics;
    const auto bytes = encode(example(), diagnostics);
    REQUIRE(bytes);
    CHECK(bytes->find("capDate") != bytes->npos);
    CHECK(bytes->find("2000:01:01") == bytes->npos);
    CHECK(encode(example(), diagnostics) == bytes);
}

TEST_CASE("a file of layers is opened once: nobody can put another one in its place") {
    const std::string path = std::filesystem::temp_directory_path() / "candelabra_once.exr";
    Diagnostics diagnostics;
    std::ofstream(path, std::ios::binary) << encode(example(), diagnostics).value();
    const int watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    // The kernel merges equal events that follow each other, so watch two kinds that alternate.
    REQUIRE(::inotify_add_watch(watch, path.c_str(), IN_OPEN | IN_CLOSE) >= 0);
    CHECK(read_layers(path, {}, diagnostics));
    alignas(inotify_event) std::array<char, 4096> events;
    const ssize_t bytes = ::read(watch, events.data(), events.size());
    int opened = 0;
    for (ssize_t at = 0; at < bytes;) {
        const auto* const event =
            reinterpret_cast<const inotify_event*>(&events[static_cast<std::size_t>(at)]);
        opened += (event->mask & IN_OPEN) != 0;
        at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
    }
    CHECK(opened == 1);
    ::close(watch);
    std::filesystem::remove(path);
}

}  // namespace candelabra
