// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame_run.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

struct Frames : Shell {
    Console console;
    Frames() {
        console.out = [this](std::string_view text) { out += text; };
        console.err = [this](std::string_view text) { err += text; };
    }
    Options options(const std::string& name) const {
        Options result;
        result.scene = path(name + ".pov");
        result.output = path(name + ".png");
        result.render.width = result.render.height = 8;
        result.render.samples = 1;
        return result;
    }
};

}  // namespace

TEST_CASE("a frame renders when it may, and is heard when it may speak") {
    Frames shell;
    shell.write("a.pov", std::string(lit_scene) + "#debug \"here\\n\"");
    FrameRun frame(shell.options("a"), shell.console, {});
    CHECK(frame.render());
    CHECK(frame.wait_wound_down());
    CHECK(shell.err.empty());
    CHECK_FALSE(fs::exists(shell.path("a.png")));  // pictures are written in order
    frame.speak();
    CHECK(frame.finish() == exit_status::done);
    CHECK(has(shell.err, "here"));
    CHECK(fs::exists(shell.path("a.png")));
}

TEST_CASE("a frame is rendered while the one before it is not written yet") {
    Frames shell;
    shell.write("a.pov", lit_scene);
    shell.write("b.pov", lit_scene);
    FrameRun before(shell.options("a"), shell.console, {});
    FrameRun now(shell.options("b"), shell.console, {}, shell.path("a.png"));
    CHECK(before.render());
    CHECK(before.wait_wound_down());
    CHECK(now.render());
    CHECK(now.wait_wound_down());
    CHECK_FALSE(fs::exists(shell.path("a.png")));
    before.speak();
    CHECK(before.finish() == exit_status::done);
    CHECK(fs::exists(shell.path("a.png")));
    CHECK_FALSE(fs::exists(shell.path("b.png")));
    now.speak();
    CHECK(now.finish() == exit_status::done);
    CHECK(fs::exists(shell.path("b.png")));
}

TEST_CASE("a frame that is not wanted any more ends without a picture") {
    Frames shell;
    shell.write("a.pov", lit_scene);
    { const FrameRun frame(shell.options("a"), shell.console, {}); }
    CHECK_FALSE(fs::exists(shell.path("a.png")));
    CHECK(shell.err.empty());
}

TEST_CASE("an error ends a frame before it is rendered") {
    Frames shell;
    shell.write("a.pov", "sphere { 0, Sise }");
    FrameRun frame(shell.options("a"), shell.console, {});
    CHECK_FALSE(frame.render());
    CHECK(frame.finish() == exit_status::scene);
    CHECK(shell.err.empty());
    frame.speak();
    CHECK(has(shell.err, "Sise"));
}

TEST_CASE("a frame that reads a picture that is being made is not rendered") {
    Frames shell;
    shell.write("a.pov", lit_scene);
    REQUIRE(shell({shell.path("a.pov"), "-V", "+W4", "+H4", "+O" + shell.path("before.png")}) == 0);
    shell.write("a.pov", std::string(lit_scene) +
                             "plane { z, 9 pigment { image_map { png \"before.png\" } } }");
    FrameRun now(shell.options("a"), shell.console, {}, shell.path("before.png"));
    CHECK_FALSE(now.render());
    CHECK(now.finish() != exit_status::done);
    FrameRun later(shell.options("a"), shell.console, {});
    later.speak();
    CHECK(later.render());
    CHECK(later.finish() == exit_status::done);
}

}  // namespace candelabra
