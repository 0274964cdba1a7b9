// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/light_weights.h"

#include "base/colour.h"
#include "support/rgb.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct Weighed : Shell {
    /// The weights of a file, or what is wrong with it.
    std::string said(const std::string& name, const std::string& text, std::size_t frame = 0) {
        write(name, text);
        Diagnostics diagnostics;
        LightWeights weights;
        if (!weights.read(path(name), diagnostics)) return diagnostics.all()[0].message;
        std::string result = std::to_string(weights.frames()) + ":";
        for (const auto& [lamp, factor] : weights.of(frame))
            result += " " + lamp + " " + std::to_string(factor.r).substr(0, 4) + " " +
                      std::to_string(factor.b).substr(0, 4);
        return result;
    }
};

}  // namespace

TEST_CASE("a weight is a number, a colour, or both", "[output]") {
    const double half = srgb_decode(0x88 / 255.0);
    struct Case {
        std::string text;
        Rgb factor;
    };
    for (const Case& each :
         {Case{"Top=4", Rgb(4)}, Case{"Top=0", Rgb(0)}, Case{"Top=#ff8800", Rgb(1, half, 0)},
          Case{"Top=4,#f80", Rgb(4, 4 * half, 0)},
          Case{"Top=#ff8800 0.5", Rgb(0.5, half / 2, 0)}}) {
        INFO(each.text);
        Diagnostics diagnostics;
        LightWeights weights;
        CHECK(weights.add(each.text, diagnostics));
        REQUIRE(weights.of(7).size() == 1);
        CHECK(weights.of(7)[0].first == "Top");
        CHECK(length(weights.of(7)[0].second - each.factor) < 1e-12);
    }
    for (const char* wrong : {"Top", "=4", "Top=", "Top=-1", "Top=4x", "Top=nan", "Top=#ff88",
                              "Top=1,2", "Top=#fff,#fff", "Top=inf"}) {
        INFO(wrong);
        Diagnostics diagnostics;
        CHECK_FALSE(LightWeights().add(wrong, diagnostics));
        CHECK(diagnostics.failed());
    }
}

TEST_CASE("weights come from tables and JSON, for all frames or for each", "[output]") {
    Weighed file;
    CHECK(file.said("a.json",
                    R"({"Top": 4, "Low": "0.5,#00f", "Key": {"strength": 2, "colour": "#fff"}})") ==
          "0: Top 4.00 4.00 Low 0.00 0.50 Key 2.00 2.00");
    CHECK(file.said("a.json", R"([{"Top": 4}, {"Top": 1}])", 1) == "2: Top 1.00 1.00");
    CHECK(file.said("a.csv", "frame,Top,Low\n1,2,#f00\n2,,\"3,#00f\"\n", 0) ==
          "2: Top 2.00 2.00 Low 1.00 0.00");
    CHECK(file.said("a.csv", "frame,Top,Low\n1,2,#f00\n2,,\"3,#00f\"\n", 1) == "2: Low 0.00 3.00");
    const auto fails = [&](const std::string& name, const std::string& text,
                           const std::string& part) {
        INFO(text);
        CHECK(file.said(name, text).find(part) != std::string::npos);
    };
    fails("a.json", "{", "has no lamps with weights");
    fails("a.json", "[]", "has no lamps with weights");
    fails("a.json", "3", "has no lamps with weights");
    fails("a.json", R"({"Top": -1})", "the weight of `Top` is none");
    fails("a.json", R"({"Top": {"stength": 1}})", "the weight of `Top` is none");
    fails("a.csv", "Top\nmuch\n", "the weight of `Top` in frame 1 is `much`");
    fails("a.csv", "Top,Low\n1\n", "line 2");
    fails("a.csv", "Top,Low\n", "has a header and no row");
}

TEST_CASE("options replace the weights of a file, lamp by lamp", "[output]") {
    Weighed file;
    file.write("a.csv", "Top,Low\n1,2\n3,4\n");
    Diagnostics diagnostics;
    LightWeights weights;
    REQUIRE(weights.add("Low=9", diagnostics));
    REQUIRE(weights.read(file.path("a.csv"), diagnostics));
    CHECK(weights.of(1) == LightFactors{{"Top", Rgb(3)}, {"Low", Rgb(9)}});
    CHECK_FALSE(weights.read(file.path("none.csv"), diagnostics));
}

TEST_CASE("light is weighted exactly", "[output]") {
    Image picture(2, 1), lamp(2, 1);
    picture.pixels = {Rgb(0.3f, 0.7f, 1e-9f), Rgb(5)};
    lamp.pixels = {Rgb(0.1f, 0.7f, 0), Rgb(2)};
    Image same = picture;
    relight(same, std::vector<LampLight>{{lamp, Rgb(1)}});
    CHECK(same.pixels == picture.pixels);
    Image more = picture;
    relight(more, std::vector<LampLight>{{lamp, Rgb(3, 1, 1)}});
    CHECK(more.pixels[1] == Rgb(9, 5, 5));
    Image less = picture;
    relight(less, std::vector<LampLight>{{lamp, Rgb(0)}});
    CHECK(less.pixels[0].r == Approx(0.2));
    CHECK(less.pixels[0].g == 0);
    CHECK(less.pixels[0].b == 1e-9f);
}

}  // namespace candelabra
