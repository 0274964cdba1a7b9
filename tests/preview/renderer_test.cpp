// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/renderer.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <future>
#include <memory>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

const std::string scene = R"(#version 3.7;
camera { location -5*z look_at 0 angle 50 }
sphere { 0, 1 pigment { rgb <1, 0.5, 0> } finish { ambient 0.2 diffuse 0.8 } }
plane { z, 3 pigment { rgb 1 } finish { ambient 0.5 diffuse 0.5 } }
light_source { <-1, 0, -5>, 1 }
)";

/// A scene in the preview, with all pictures that the page is shown.
struct Rehearsal {
    SharedWorld world;
    SourceStore sources;
    Options options;
    std::vector<std::string> lights = {"lamp"};
    std::atomic<bool> leaves = false;
    std::mutex mutex;
    std::vector<ScreenPicture> shown;
    PreviewState state{[this] { note(); }};

    explicit Rehearsal(const std::string& script = scene) : Rehearsal(world_of(script)) {}
    explicit Rehearsal(SharedWorld shown_world) : world(std::move(shown_world)) {
        sources.add("scene.pov", scene);
        options.render.width = 64;
        options.render.height = 48;
        options.render.samples = 4;
    }
    void note() {
        const std::lock_guard lock(mutex);
        // The state does not hold its lock when it calls.
        ScreenPicture now = state_picture();
        if (now.bytes && (shown.empty() || shown.back().bytes != now.bytes)) shown.push_back(now);
    }
    ScreenPicture state_picture() { return ready ? state.picture() : ScreenPicture(); }
    /// Renders on another thread until the test is true.
    template <class Test>
    bool until(const Test& test) {
        ready = true;
        leaves = false;
        std::thread renderer([this] {
            const auto left = [this] { return leaves.load(); };
            render_preview({world, sources, options, {}, {}, lights}, state, {left, left});
        });
        bool is_so = false;
        for (int i = 0; i < 4000 && !is_so; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            const std::lock_guard lock(mutex);
            is_so = test();
        }
        leaves = true;
        renderer.join();
        return is_so;
    }
    /// Renders until the picture is finished and shown.
    bool finish() {
        return until([this] {
            return state.status().find("\"progress\":1") != std::string::npos && !shown.empty() &&
                   shown.back().columns == 64;
        });
    }
    bool ready = false;
};

/// Whether the previews come to show the same: they develop pictures on threads of their own.
bool show_alike(Rehearsal& a, Rehearsal& b) {
    const auto alike = [&] { return *a.state.picture().bytes == *b.state.picture().bytes; };
    for (int i = 0; i < 400 && !alike(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return alike();
}

}  // namespace

TEST_CASE("the first picture is a coarse one of all, and the last has each pixel", "[preview]") {
    Rehearsal rehearsal;
    REQUIRE(rehearsal.world->provenance.light_statements.size() == 1);
    CHECK(rehearsal.until(
        [&] { return !rehearsal.shown.empty() && rehearsal.shown.back().columns == 64; }));
    const ScreenPicture first = rehearsal.shown.front();
    CHECK(first.columns <= 32);
    CHECK(first.width == 64);
    CHECK(first.height == 48);
    // No part is black; the ball has no blue, so red is checked.
    for (std::size_t i = 0; i < first.bytes->size(); i += 4) CHECK((*first.bytes)[i] != 0);
}

TEST_CASE("the first picture does not wait for photons, the last has them", "[preview]") {
    const std::string dark =
        "#version 3.7; camera { location <0, 4, -6> look_at 0 angle 40 } "
        "global_settings { photons { count 20000 } } "
        "plane { y, -1 pigment { rgb 1 } finish { ambient 0.05 diffuse 0.8 } } "
        "sphere { 0, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } "
        "photons { target refraction on } } light_source { <0, 20, 0>, 1 photons { refraction on } "
        "}";
    Rehearsal rehearsal(dark);
    REQUIRE_FALSE(rehearsal.world->photon_targets.empty());
    CHECK(rehearsal.until(
        [&] { return !rehearsal.shown.empty() && rehearsal.shown.back().columns == 64; }));
    CHECK(rehearsal.shown.front().columns < 64);
    // The floor below the ball, seen through it, is lit by photons only.
    const auto brightest_in_middle = [](const ScreenPicture& picture) {
        int result = 0;
        const auto columns = static_cast<std::size_t>(picture.columns);
        const std::size_t rows = picture.bytes->size() / 4 / columns;
        for (std::size_t y = rows / 3; y < rows; ++y)
            for (std::size_t x = columns / 3; x < columns - columns / 3; ++x)
                result =
                    std::max(result, static_cast<int>((*picture.bytes)[4 * (y * columns + x)]));
        return result;
    };
    CHECK(brightest_in_middle(rehearsal.shown.back()) >
          brightest_in_middle(rehearsal.shown.front()));
}

TEST_CASE("a scene that is another at once has its coarse picture, one that ends has none",
          "[preview]") {
    for (const bool ends : {false, true}) {
        Rehearsal rehearsal;
        rehearsal.ready = true;
        render_preview(
            {rehearsal.world, rehearsal.sources, rehearsal.options, {}, {}, rehearsal.lights},
            rehearsal.state, {[] { return true; }, [&] { return ends; }});
        // The state develops pictures on its own thread.
        for (int i = 0; i < 400 && !ends && rehearsal.state.picture().width == 0; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        CHECK((rehearsal.state.picture().width == 0) == ends);
    }
}

TEST_CASE("a camera that is moved begins another picture of the same world", "[preview]") {
    Rehearsal rehearsal;
    CHECK(rehearsal.until(
        [&] { return rehearsal.state.status().find("\"progress\":1") != std::string::npos; }));
    const int before = rehearsal.state.picture().generation;
    rehearsal.state.move_camera([](Orbit& orbit, const Sight& given) { orbit.turn(given, 30, 0); });
    CHECK(rehearsal.until([&] {
        return !rehearsal.shown.empty() && rehearsal.shown.back().generation > before &&
               rehearsal.shown.back().columns == 64;
    }));
    CHECK(rehearsal.world->stated_view.camera.location == Vec3(0, 0, -5));
}

TEST_CASE("a camera that is moved sees what a scene with that camera shows", "[preview]") {
    // The cells of the light octree and the number of shadow rays depend on the camera.
    Rehearsal moved(R"(#version 3.7; #default { finish { ambient 0 diffuse 0.7 } }
camera { location <0, 2, -9> look_at 0 angle 50 }
plane { y, -1 pigment { rgb 0.8 } }
box { -1, 1 pigment { rgb <1, 0.5, 0> } }
#for (I, 0, 29)
    sphere { <4, 0, 0>, 0.1 rotate 12*I*y pigment { rgb 1 } finish { emission 5 } }
#end)");
    CHECK(moved.finish());
    Projection camera;
    moved.state.move_camera([&](Orbit& orbit, const Sight& given) {
        orbit.turn(given, 40, 20);
        orbit.approach(0.5);
        camera = orbit.place(given).camera;
    });
    const int before = moved.state.picture().generation;
    World with_that_camera(*moved.world);
    with_that_camera.stated_view.camera = camera;
    Rehearsal fresh(std::make_shared<World>(std::move(with_that_camera)));
    CHECK(fresh.finish());
    CHECK(moved.until([&] {
        return moved.state.status().find("\"progress\":1") != std::string::npos &&
               moved.shown.back().generation > before && moved.shown.back().columns == 64;
    }));
    CHECK(show_alike(moved, fresh));
}

TEST_CASE("a layer is shown instead of the picture", "[preview]") {
    Rehearsal rehearsal;
    CHECK(rehearsal.state.choose_view("albedo"));
    CHECK(rehearsal.until([&] {
        return !rehearsal.shown.empty() && rehearsal.shown.back().view == "albedo" &&
               rehearsal.shown.back().columns == 64;
    }));
    const std::string& bytes = *rehearsal.shown.back().bytes;
    const std::size_t middle = 4 * (24 * 64 + 32);
    CHECK(static_cast<unsigned char>(bytes[middle]) == 255);
    CHECK(static_cast<unsigned char>(bytes[middle + 2]) == 0);
}

TEST_CASE("after a layer, the picture ends as if it had never been left", "[preview]") {
    const auto is_finished = [](const Rehearsal& rehearsal) {
        return rehearsal.state.status().find("\"progress\":1") != std::string::npos;
    };
    Rehearsal straight, back;
    CHECK(straight.until([&] { return is_finished(straight); }));
    CHECK(back.state.choose_view("albedo"));
    std::future<bool> choice;
    const auto returns = [&] {
        if (back.shown.empty()) return false;
        // The state calls note(), which waits for the lock that is held here.
        if (!choice.valid() && back.shown.back().view == "albedo")
            choice =
                std::async(std::launch::async, [&] { return back.state.choose_view("picture"); });
        return back.shown.back().view == "picture" && is_finished(back);
    };
    CHECK(back.until(returns));
    CHECK(show_alike(straight, back));
}

}  // namespace candelabra
