// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/channels.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const LampList& wired_lamps() {
    static const LampList lamps({{"Key", 1}, {"Row", 2}}, {0, 1, 0}, std::vector<float>(3, 1.0F));
    return lamps;
}

/// The factors of the lamps in a frame, by name and number.
std::vector<Rgb> wired(const std::string& frame, const std::vector<PatchedLamp>& patch,
                       std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges = {},
                       double exponent = 1) {
    ChannelData data;
    data.channels = static_cast<std::uint32_t>(frame.size());
    data.bytes = frame;
    data.ranges = std::move(ranges);
    const auto frames = channel_frames(std::move(data), patch, ChannelCurve{exponent});
    CHECK(frames->count() == 1);
    std::vector<Rgb> factors(3, Rgb(7));
    frames->set(0, factors);
    return {factors[0], factors[2], factors[1]};
}

std::vector<PatchedLamp> patched(const std::string& text) {
    Diagnostics diagnostics;
    auto patch = patch_of_table(text, "a.csv", LampNames(wired_lamps()), diagnostics);
    REQUIRE(patch);
    return *patch;
}

std::string problem_of_patch(const std::string& text) {
    Diagnostics diagnostics;
    CHECK_FALSE(patch_of_table(text, "a.csv", LampNames(wired_lamps()), diagnostics));
    return diagnostics.all()[0].message;
}

}  // namespace

TEST_CASE("without a patch lamps follow each other", "[relight]") {
    const std::string frame("\xff\0\0\0\xff\0\x33\0\xff", 9);
    const auto coloured = usual_patch(wired_lamps(), 9);
    REQUIRE(coloured);
    CHECK(wired(frame, *coloured) == std::vector<Rgb>{Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0.2, 0, 1)});
    const auto grey = usual_patch(wired_lamps(), 3);
    REQUIRE(grey);
    CHECK(wired(std::string("\xff\0\x33", 3), *grey) == std::vector<Rgb>{Rgb(1), Rgb(0), Rgb(0.2)});
    CHECK(usual_patch(wired_lamps(), 12));  // filled up to a multiple of four
    CHECK(usual_patch(wired_lamps(), 4));
    CHECK_FALSE(usual_patch(wired_lamps(), 6));
    CHECK_FALSE(usual_patch(LampList(), 0));
}

TEST_CASE("a patch says which lamp hangs on which channels", "[relight]") {
    const std::string frame("\0\xff\0\x33\0\0\xff\0\0", 9);
    CHECK(wired(frame, patched("lamp,channel,order\nRow[0..1],2,GRB\n")) ==
          std::vector<Rgb>{Rgb(7), Rgb(0, 1, 0.2), Rgb(0, 0, 1)});
    CHECK(wired(frame, patched("order,lamp,channel\nW,Key,2\n")) ==
          std::vector<Rgb>{Rgb(1), Rgb(7), Rgb(7)});
    CHECK(wired(frame, patched("lamp,channel,order\nKey,4,RGBW\n")) ==
          std::vector<Rgb>{Rgb(1.2, 1, 1), Rgb(7), Rgb(7)});
    // Channels that the frames do not have leave a lamp as it is.
    CHECK(wired(frame, patched("lamp,channel,order\nKey,99,RGB\n"))[0] == Rgb(7));
    CHECK(wired(frame, patched("lamp,channel,order\nKey,12,W\n"), {{2, 4}, {11, 5}})[0] == Rgb(0));
    CHECK(wired(frame, patched("lamp,channel,order\nKey,14,W\n"), {{2, 4}, {11, 5}})[0] == Rgb(1));
    CHECK(problem_of_patch("lamp,channel\nKey,1\n") == "`a.csv` has no column `order`");
    CHECK(problem_of_patch("lamp,channel,order\nKey,0,W\n") ==
          "`a.csv` has the channel `0` in row 1");
    CHECK(problem_of_patch("lamp,channel,order\nKey,1.5,W\n") ==
          "`a.csv` has the channel `1.5` in row 1");
    for (const char* order : {"", "RG", "RGBX", "RRGB", "RGBWW"})
        CHECK(problem_of_patch("lamp,channel,order\nKey,1," + std::string(order) + "\n")
                  .find("in row 1") != std::string::npos);
    CHECK(problem_of_patch("lamp,channel,order\nKay,1,W\n") ==
          "there is no lamp `Kay`");
}

TEST_CASE("curves say how much light a value is", "[relight]") {
    CHECK(ChannelCurve::of("linear")->exponent == 1);
    CHECK(ChannelCurve::of("square")->exponent == 2);
    CHECK(ChannelCurve::of("2.2")->exponent == 2.2);
    for (const char* wrong : {"", "cubic", "0", "-1", "99", "nan"})
        CHECK_FALSE(ChannelCurve::of(wrong));
    const auto grey = usual_patch(wired_lamps(), 3);
    const std::vector<Rgb> light = wired(std::string("\xff\0\x33", 3), *grey, {}, 2);
    CHECK(light[0] == Rgb(1));
    CHECK(light[1] == Rgb(0));
    CHECK(light[2].r == Approx(0.04));
}

}  // namespace candelabra
