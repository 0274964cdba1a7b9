// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/animation.h"

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

TEST_CASE("frames are numbered backwards if the last comes before the first", "[app]") {
    AnimationSettings settings;
    settings.initial_frame = 5;
    settings.final_frame = 1;
    CHECK(frames(settings) == "5:0 4:0.25 3:0.5 2:0.75 1:1");
    settings.frame_step = 2;
    settings.subset_start_frame = 4;
    CHECK(frames(settings) == "4:0.25 2:0.75");
    settings.subset_start_frame = {};
    settings.subset_end_frame = 0.4;
    settings.frame_step = 1;
    CHECK(frames(settings) == "5:0 4:0.25");
    settings.subset_end_frame = {};
    settings.cyclic = true;
    settings.final_frame = 2;
    CHECK(frames(settings) == "5:0 4:0.25 3:0.5 2:0.75");
    Diagnostics diagnostics;
    CHECK(plan(settings, diagnostics)->final_frame == 1);
    CHECK(plan(settings, diagnostics)->clock_delta == 0.25);
    settings.initial_frame = 2;
    settings.final_frame = -10;
    CHECK(plan(settings, diagnostics)->digits == 2);
}

TEST_CASE("listed frames are rendered in their order, with the clocks of the whole", "[app]") {
    AnimationSettings settings;
    settings.final_frame = 11;
    settings.chosen = *frame_list("3,7,9-11,3,2-1,99");
    CHECK(frames(settings) == "3:0.2 7:0.6 9:0.8 10:0.9 11:1 2:0.1 1:0");
    settings.chosen = *frame_list("50");
    CHECK(frames(settings) == "no frame of the animation is in the subset");
    settings.chosen = *frame_list("-2--1,0");
    settings.initial_frame = -2;
    settings.final_frame = 2;
    CHECK(frames(settings) == "-2:0 -1:0.25 0:0.5");
    settings = {};
    settings.chosen = {1};
    CHECK(frames(settings) == "--frames chooses some frames of an animation");
    for (const char* text :
         {"", "a", "1,", ",1", "1-", "1..3", "1-2-3", "1 2", "1e9", "1-9999999", "99999999999"}) {
        CAPTURE(text);
        CHECK_FALSE(frame_list(text));
    }
}

TEST_CASE("one frame has the first clock", "[app]") {
    AnimationSettings settings;
    settings.initial_frame = 5;
    settings.initial_clock = 2;
    CHECK(frames(settings) == "5:2");
}

TEST_CASE("frames that cannot be are refused", "[app]") {
    AnimationSettings settings;
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
