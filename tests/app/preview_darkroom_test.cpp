// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview_darkroom.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <vector>

namespace candelabra {

TEST_CASE("a darkroom prints the newest plate as it is wanted", "[app]") {
    std::mutex mutex;
    std::condition_variable came;
    std::vector<ScreenPicture> shown;
    Darkroom darkroom([&](ScreenPicture picture) {
        const std::lock_guard lock(mutex);
        shown.push_back(std::move(picture));
        came.notify_all();
    });
    const auto wait_for = [&](std::size_t count) {
        std::unique_lock lock(mutex);
        return came.wait_for(lock, std::chrono::seconds(20), [&] { return shown.size() >= count; });
    };
    CHECK(darkroom.png().empty());
    CHECK(darkroom.exr().empty());
    darkroom.set({});  // there is no plate to develop yet, and no change
    Plate plate;
    plate.width = 8;
    plate.height = 4;
    plate.light = Image(2, 1);
    darkroom.take(std::make_shared<const Plate>(plate),
                  std::make_shared<const PlateFrame>(PlateFrame{{}, {}, {}, 1, 7}));
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
    darkroom.set(look);
    REQUIRE(wait_for(2));
    CHECK(darkroom.png().substr(1, 3) == "PNG");
    CHECK(darkroom.exr().starts_with("\x76\x2f\x31\x01"));
}

TEST_CASE("with glare a smaller picture comes first, and the whole one when hands rest", "[app]") {
    std::mutex mutex;
    std::condition_variable came;
    std::vector<int> columns;
    Darkroom darkroom([&](const ScreenPicture& picture) {
        const std::lock_guard lock(mutex);
        columns.push_back(picture.columns);
        came.notify_all();
    });
    Look look;
    look.film = {{"glare", "on"}};
    darkroom.set(look);
    Plate plate;
    plate.width = 256;
    plate.height = 8;
    plate.light = Image(256, 8);
    darkroom.take(std::make_shared<const Plate>(plate),
                  std::make_shared<const PlateFrame>(PlateFrame{{}, {}, {}, 1, 1}));
    std::unique_lock lock(mutex);
    REQUIRE(came.wait_for(lock, std::chrono::seconds(20), [&] { return columns.size() >= 2; }));
    CHECK(columns == std::vector<int>{64, 256});
}

}  // namespace candelabra
