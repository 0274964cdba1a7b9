// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/light_show.h"

#include "base/colour.h"
#include "support/folder.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const LampList& show_lamps() {
    static const LampList lamps({{"Key", 1}, {"Row", 3}}, {0, 0, 1, 2},
                                std::vector<float>(4, 1.0F));
    return lamps;
}

/// The red factors of the lamps in a frame of a table, or what is wrong with it.
std::string shown(const std::string& text, std::size_t frame = 0, double rate = 10) {
    const LampNames names(show_lamps());
    Diagnostics diagnostics;
    const auto frames = show_of_table(text, "a.csv", names, rate, diagnostics);
    if (!frames) return diagnostics.all()[0].message;
    std::vector<Rgb> factors(4, Rgb(1));
    frames->set(frame, factors);
    std::string result = std::to_string(frames->count()) + ":";
    for (const Rgb& factor : factors) result += " " + std::to_string(factor.r).substr(0, 4);
    return result;
}

}  // namespace

TEST_CASE("a table has a frame in each row", "[relight]") {
    CHECK(shown("Key,Row\n0.5,0.25\n1,2\n") == "2: 0.50 0.25 0.25 0.25");
    CHECK(shown("Key,Row\n0.5,0.25\n1,2\n", 1) == "2: 1.00 2.00 2.00 2.00");
    CHECK(shown("time,Key,Row[0..2]\n0,0.5,0.1,0.2,0.3\n") == "1: 0.50 0.10 0.20 0.30");
    CHECK(shown("Row[0..2]\n0.1,0.2,0.3\n\n0,0,1\n", 1) == "2: 1.00 0.00 0.00 1.00");
    CHECK(shown("Row[1];Key\r\n#ff0000;0,5\r\n").find("is no value of a lamp") !=
          std::string::npos);
    CHECK(shown("Row[1];Key\r\n#ff0000;0.5\r\n") == "1: 0.50 1.00 1.00 1.00");
    CHECK(shown("Key,Row\n,0\n") == "1: 1.00 0.00 0.00 0.00");
    CHECK(shown("Key\n\"0.5,#ff8800\"\n") == "1: 0.50 1.00 1.00 1.00");
}

TEST_CASE("cues fade from what lamps do", "[relight]") {
    const std::string cues =
        "cue,time,fade\n1,0,0,*=0\n2,1,2,Key=1\n3,2,1,Row[0..1]=1,Row[2]=0.5\n";
    CHECK(shown(cues, 0) == "31: 0.00 0.00 0.00 0.00");
    CHECK(shown(cues, 10) == "31: 0.00 0.00 0.00 0.00");
    CHECK(shown(cues, 20) == "31: 0.50 0.00 0.00 0.00");
    CHECK(shown(cues, 25) == "31: 0.75 0.50 0.50 0.25");
    CHECK(shown(cues, 30) == "31: 1.00 1.00 1.00 0.50");
    // A cue takes a lamp over while it fades.
    CHECK(shown("cue,time,fade\na,0,2,Key=0\nb,1,1,Key=1\n", 15) == "21: 0.75 1.00 1.00 1.00");
}

TEST_CASE("what is wrong with a table is said with its line", "[relight]") {
    CHECK(shown("") == "`a.csv` has no rows");
    CHECK(shown("Key\n") == "`a.csv` has a header and no row");
    CHECK(shown("Kay\n1\n") == "there is no lamp `Kay`");
    CHECK(shown("Key\n\n1,2\n") == "`a.csv`, line 3: 2 cells, and the header has 1");
    CHECK(shown("Key\n-1\n") == "`a.csv`, line 2: `-1` is no value of a lamp");
    CHECK(shown("cue,fade\n") == "`a.csv`, line 1: a cue list has the columns cue, time and fade");
    CHECK(shown("cue,time,fade\n1,0\n") ==
          "`a.csv`, line 2: the time and the fade of a cue are seconds, from 0 on");
    CHECK(shown("cue,time,fade\n1,5,0\n2,4,0\n") ==
          "`a.csv`, line 3: the cue is earlier than the one before it");
    CHECK(shown("cue,time,fade\n1,0,0,Key\n") ==
          "`a.csv`, line 2: `Key` is no lamp with its value");
    CHECK(shown("cue,time,fade\n1,0,1e9,Key=1\n").find("up to 1000000 frames") !=
          std::string::npos);
    CHECK(shown("cue,time,fade\n") == "`a.csv` has a header and no cue");
}

TEST_CASE("settings hold in all frames", "[relight]") {
    LightShow show(show_lamps());
    Diagnostics diagnostics;
    CHECK(show.frames() == 0);
    CHECK(show.set("Row[1]=0.5,#ff8800", diagnostics));
    CHECK(show.set("Key=0", diagnostics));
    const double half = srgb_decode(0x88 / 255.0);
    const std::vector<Rgb> factors = show.factors(0);
    CHECK(factors[0] == Rgb(0));
    CHECK(factors[1] == Rgb(1));
    CHECK(length(factors[2] - Rgb(0.5, half / 2, 0)) < 1e-12);
    Folder folder;
    folder.put("a.csv", "Key,Row\n0.5,0.25\n1,2\n");
    show.set(read_show_table(folder / "a.csv", show.names(), 25, diagnostics));
    CHECK(show.frames() == 2);
    CHECK(show.factors(1)[0] == Rgb(0));
    CHECK(show.factors(1)[3] == Rgb(2));
    CHECK_FALSE(diagnostics.failed());
    for (const char* wrong : {"Row", "=1", "Row=", "Row=-1", "Raw=1", "Row[7]=1"}) {
        Diagnostics said;
        CHECK_FALSE(show.set(wrong, said));
        CHECK(said.failed());
    }
    CHECK(read_show_table(folder / "none.csv", show.names(), 25, diagnostics) == nullptr);
}

}  // namespace candelabra
