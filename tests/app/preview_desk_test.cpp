// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview_desk.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candelabra {

namespace {

nlohmann::json status_of(const PreviewDesk& desk) { return nlohmann::json::parse(desk.status()); }

}  // namespace

TEST_CASE("what the page sets is told to the renderer, and comes back in the status", "[app]") {
    std::atomic<int> told = 0;
    PreviewDesk desk([&] { ++told; });
    CHECK_FALSE(desk.dim(0, {}));
    desk.show_scene({projection(Perspective{}), 5}, {}, {{"lamp", "a.pov:1: sphere"}}, true);
    const int before = desk.wish_version();
    CHECK(desk.dim(0, {2, Vec3(1, 0, 0)}));
    CHECK_FALSE(desk.dim(1, {}));
    CHECK(desk.choose_view("normal"));
    CHECK_FALSE(desk.choose_view("nothing"));
    CHECK(desk.change_film({"exposure", "1"}).empty());
    CHECK_FALSE(desk.change_film({"exposure", "bright"}).empty());
    desk.pause(true);
    desk.denoise(true);
    desk.point_at({0.25, 0.5});
    CHECK(desk.wish_version() > before);
    CHECK(told > 0);
    const Wishes wishes = desk.wishes();
    CHECK(wishes.paused);
    CHECK(wishes.look.view == "normal");
    CHECK(wishes.look.denoised);
    CHECK(wishes.focus->x == 0.25);
    CHECK(wishes.look.lamps.at("lamp").strength == 2);
    const auto status = status_of(desk);
    CHECK(status["relit"] == true);
    CHECK(status["lamps"][0]["colour"] == nlohmann::json({1.0, 0.0, 0.0}));
    CHECK(status["film"]["exposure"] == 1.0);
    CHECK(status["view"] == "normal");
    CHECK(desk.film() == "film { exposure 1 }");
    desk.reset_lamps();
    desk.reset_film();
    CHECK(status_of(desk)["relit"] == false);
    CHECK(status_of(desk)["film_changed"] == false);
}

TEST_CASE("the page moves the camera that the scene gives", "[app]") {
    PreviewDesk desk([] {});
    const auto turn = [](Orbit& orbit, const Sight& given) { orbit.turn(given, 90, 0); };
    desk.move_camera(turn);  // there is no camera yet
    CHECK(desk.camera().empty());
    CHECK(desk.wishes().orbit_version == 0);
    desk.show_scene({projection(Perspective{}), 5}, {}, {}, false);
    CHECK(desk.camera().find("location <0, 0, 0>") != std::string::npos);
    desk.move_camera(turn);
    CHECK(desk.wishes().orbit_version == 1);
    CHECK(desk.camera().find("location <5, 0, 5>") != std::string::npos);
    CHECK(status_of(desk)["moved"] == true);
    desk.show_scene({projection(MeshCamera{}), 5}, {}, {}, false);
    CHECK(status_of(desk)["can_move"] == false);
}

TEST_CASE("knobs keep what the page has set, within their ranges", "[app]") {
    PreviewDesk desk([] {});
    CHECK(desk.take_knobs({{"Size", 1, 0.5, 2, 0.1, ""}}).empty());
    CHECK_FALSE(desk.turned());
    CHECK(desk.turn("Size", 7));
    CHECK_FALSE(desk.turn("Height", 7));
    CHECK(desk.turned());
    CHECK(desk.knob("Size", 0) == 2);
    CHECK(desk.knob("Height", 3) == 3);
    const auto declared = desk.take_knobs({{"Size", 1, 0.5, 2, 0.1, ""}});
    REQUIRE(declared.size() == 1);
    CHECK(declared[0].second == 2);
    CHECK_FALSE(desk.turned());
}

TEST_CASE("who rests hears of a wish", "[app]") {
    PreviewDesk desk([] {});
    std::thread wish([&] { desk.pause(true); });
    for (int i = 0; i < 1000 && !desk.wishes().paused; ++i) desk.rest(20);
    wish.join();
    CHECK(desk.wishes().paused);
    desk.stand([](Standing& standing) { standing.samples = 3; });
    CHECK(status_of(desk)["samples"] == 3.0);
    const int first = desk.next_generation();
    CHECK(desk.next_generation() == first + 1);
}

}  // namespace candelabra
