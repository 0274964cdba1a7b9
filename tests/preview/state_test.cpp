// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/state.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candelabra {

namespace {

nlohmann::json status_of(const PreviewState& state) {
    return nlohmann::json::parse(state.status());
}

}  // namespace

TEST_CASE("what the page sets is told to the renderer, and comes back in the status", "[preview]") {
    std::atomic<int> told = 0;
    PreviewState state([&] { ++told; });
    CHECK_FALSE(state.dim(0, {}));
    state.show_scene({projection(Perspective{}), 5}, {}, {{"lamp", "a.pov:1: sphere"}}, true);
    const int before = state.wish_version();
    CHECK(state.dim(0, {2, Rgb(1, 0, 0)}));
    CHECK_FALSE(state.dim(1, {}));
    CHECK(state.choose_view("normal"));
    CHECK_FALSE(state.choose_view("nothing"));
    CHECK(state.change_film({"exposure", "1"}).empty());
    CHECK_FALSE(state.change_film({"exposure", "bright"}).empty());
    state.pause(true);
    state.denoise(true);
    state.point_at({0.25, 0.5});
    CHECK(state.wish_version() > before);
    CHECK(told > 0);
    const Wishes wishes = state.wishes();
    CHECK(wishes.paused);
    CHECK(wishes.look.view == "normal");
    CHECK(wishes.look.denoised);
    CHECK(wishes.focus->x == 0.25);
    CHECK(wishes.look.lamps.at("lamp").strength == 2);
    const auto status = status_of(state);
    CHECK(status["relit"] == true);
    CHECK(status["lamps"][0]["colour"] == nlohmann::json({1.0, 0.0, 0.0}));
    CHECK(status["film"]["exposure"] == 1.0);
    CHECK(status["view"] == "normal");
    CHECK(state.film() == "film { exposure 1 }");
    state.reset_lamps();
    state.reset_film();
    CHECK(status_of(state)["relit"] == false);
    CHECK(status_of(state)["film_changed"] == false);
}

TEST_CASE("the page moves the camera that the scene gives", "[preview]") {
    PreviewState state([] {});
    const auto turn = [](Orbit& orbit, const Sight& given) { orbit.turn(given, 90, 0); };
    state.move_camera(turn);  // there is no camera yet
    CHECK(state.camera().empty());
    CHECK(state.wishes().orbit_version == 0);
    state.show_scene({projection(Perspective{}), 5}, {}, {}, false);
    CHECK(state.camera().find("location <0, 0, 0>") != std::string::npos);
    state.move_camera(turn);
    CHECK(state.wishes().orbit_version == 1);
    CHECK(state.camera().find("location <5, 0, 5>") != std::string::npos);
    CHECK(status_of(state)["moved"] == true);
    state.show_scene({projection(MeshCamera{}), 5}, {}, {}, false);
    CHECK(status_of(state)["can_move"] == false);
}

TEST_CASE("knobs keep what the page has set, within their ranges", "[preview]") {
    PreviewState state([] {});
    const Knob size{"Size", 1.0, Knob::Kind::slider, 0.5, 2, 0.1};
    const Knob tint{"Tint", Numbers::vector(Vec3(1)), Knob::Kind::colour};
    CHECK(state.take_knobs({size, tint}).empty());
    CHECK_FALSE(state.turned());
    CHECK(state.turn("Size", "7"));
    CHECK_FALSE(state.turn("Height", "7"));
    CHECK_FALSE(state.turn("Tint", "7"));
    CHECK(status_of(state)["knobs"][1]["value"] == nlohmann::json({1, 1, 1}));
    CHECK(status_of(state)["knobs"][1]["kind"] == "colour");
    CHECK(state.turned());
    CHECK(state.knob("Size", 0) == 2);
    CHECK(state.knob("Height", 3) == 3);
    const auto declared = state.take_knobs({size});
    REQUIRE(declared.size() == 1);
    CHECK(declared[0].second == KnobValue(2.0));
    CHECK_FALSE(state.turned());
}

TEST_CASE("who rests hears of a wish", "[preview]") {
    PreviewState state([] {});
    std::thread wish([&] { state.pause(true); });
    for (int i = 0; i < 1000 && !state.wishes().paused; ++i) state.rest(20);
    wish.join();
    CHECK(state.wishes().paused);
    state.set_status([](RenderStatus& status) { status.samples = 3; });
    CHECK(status_of(state)["samples"] == 3.0);
    const int first = state.next_generation();
    CHECK(state.next_generation() == first + 1);
}

}  // namespace candelabra
