// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/animation.h"

#include "text/message.h"

#include <catch2/catch.hpp>

#include <limits>

namespace candelabra {

namespace {

/// "1:0 2:0.5 3:1"
std::string frames(const AnimationSettings& settings) {
    Diagnostics diagnostics;
    const std::optional<Animation> animation = plan(settings, diagnostics);
    if (!animation)
        return diagnostics.failed() ? diagnostics.all()[0].message : std::string("none");
    std::string text;
    for (const AnimationFrame& frame : animation->frames)
        text += message(text.empty() ? "" : " ", frame.number, ":", frame.clock);
    return text;
}

}  // namespace

TEST_CASE("frames have the clocks that POV-Ray gives them", "[app]") {
    AnimationSettings settings;
    CHECK(frames(settings) == "none");
    settings.final_frame = 3;
    CHECK(frames(settings) == "1:0 2:0.5 3:1");
    settings.cyclic = true;
    settings.final_frame = 4;
    CHECK(frames(settings) == "1:0 2:0.25 3:0.5 4:0.75");
    settings.cyclic = false;
    settings.initial_clock = 10;
    settings.final_clock = 40;
    CHECK(frames(settings) == "1:10 2:20 3:30 4:40");
    settings.frame_step = 2;
    CHECK(frames(settings) == "1:10 3:30");
}

TEST_CASE("a subset keeps the clocks of the whole", "[app]") {
    AnimationSettings settings;
    settings.final_frame = 11;
    settings.subset_start_frame = 10;
    CHECK(frames(settings) == "10:0.9 11:1");
    settings.subset_start_frame = 0.5;
    settings.subset_end_frame = 6;
    CHECK(frames(settings) == "5:0.4 6:0.5");
    settings.subset_start_frame = 7;
    CHECK(frames(settings) == "no frame of the animation is in the subset");
}

TEST_CASE("one frame has the first clock", "[app]") {
    AnimationSettings settings;
    settings.initial_frame = 5;
    settings.initial_clock = 2;
    CHECK(frames(settings) == "5:2");
}

TEST_CASE("frames that cannot be are refused", "[app]") {
    AnimationSettings settings;
    settings.initial_frame = 5;
    settings.final_frame = 4;
    CHECK(frames(settings) == "the last frame, 4, comes before the first, 5");
    settings.final_frame = 5.5;
    CHECK(frames(settings) == "the number of a frame is a whole number");
    settings.final_frame = 1e9;
    CHECK(frames(settings) == "an animation has at most 1000000 frames");
}

TEST_CASE("numbers in file names are padded", "[app]") {
    CHECK(numbered("out.png", 7, 2) == "out07.png");
    CHECK(numbered("a.b/out.x.png", 120, 3) == "a.b/out.x120.png");
    CHECK(numbered("out", -3, 2) == "out-03");
}

TEST_CASE("steps that lead beyond all numbers end", "[app]") {
    AnimationSettings settings;
    settings.final_frame = 3;
    settings.frame_step = 1'000'000'000;
    CHECK(frames(settings) == "1:0");
    settings.frame_step = std::numeric_limits<int>::max();
    settings.initial_frame = settings.final_frame = 999'999'999;
    CHECK(frames(settings) == "999999999:0");
}

}  // namespace candelabra
