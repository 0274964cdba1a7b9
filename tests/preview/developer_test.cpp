// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/developer.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <vector>

namespace candelabra {

TEST_CASE("a developer prints the newest snapshot as it is wanted", "[preview]") {
    std::mutex mutex;
    std::condition_variable came;
    std::vector<ScreenPicture> shown;
    SnapshotDeveloper developer([&](ScreenPicture picture) {
        const std::lock_guard lock(mutex);
        shown.push_back(std::move(picture));
        came.notify_all();
    });
    const auto wait_for = [&](std::size_t count) {
        std::unique_lock lock(mutex);
        return came.wait_for(lock, std::chrono::seconds(20), [&] { return shown.size() >= count; });
    };
    CHECK(developer.png().empty());
    CHECK(developer.exr().empty());
    developer.set({});  // there is no snapshot to develop yet, and no change
    LightSnapshot snapshot;
    snapshot.width = 8;
    snapshot.height = 4;
    snapshot.light = Image(2, 1);
    developer.take(std::make_shared<const LightSnapshot>(snapshot),
                   std::make_shared<const SnapshotContext>(SnapshotContext{{}, {}, {}, 1, 7}));
    REQUIRE(wait_for(1));
    {
        const std::lock_guard lock(mutex);
        CHECK(shown[0].width == 8);
        CHECK(shown[0].columns == 2);
        CHECK(shown[0].rows == 1);
        CHECK(shown[0].generation == 7);
        CHECK(*shown[0].bytes == std::string("\0\0\0\xff\0\0\0\xff", 8));
    }
    Look look;
    look.film = {{"exposure", "1"}};
    developer.set(look);
    REQUIRE(wait_for(2));
    CHECK(developer.png().substr(1, 3) == "PNG");
    CHECK(developer.exr().starts_with("\x76\x2f\x31\x01"));
}

TEST_CASE("with glare a smaller picture comes first, and the whole one when hands rest", "[preview]") {
    std::mutex mutex;
    std::condition_variable came;
    std::vector<int> columns;
    SnapshotDeveloper developer([&](const ScreenPicture& picture) {
        const std::lock_guard lock(mutex);
        columns.push_back(picture.columns);
        came.notify_all();
    });
    Look look;
    look.film = {{"glare", "on"}};
    developer.set(look);
    LightSnapshot snapshot;
    snapshot.width = 256;
    snapshot.height = 8;
    snapshot.light = Image(256, 8);
    developer.take(std::make_shared<const LightSnapshot>(snapshot),
                   std::make_shared<const SnapshotContext>(SnapshotContext{{}, {}, {}, 1, 1}));
    std::unique_lock lock(mutex);
    REQUIRE(came.wait_for(lock, std::chrono::seconds(20), [&] { return columns.size() >= 2; }));
    CHECK(columns == std::vector<int>{64, 256});
}

}  // namespace candelabra
