// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/ies_file.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

PhotometricFile read(const std::string& bytes) {
    PhotometricFile file;
    const std::string problem = read_ies(bytes, file);
    INFO(bytes);
    REQUIRE(problem == "");
    return file;
}

std::string problem_of(const std::string& bytes) {
    PhotometricFile file;
    return read_ies(bytes, file);
}

/// A file with a line of factors; its table has 1000 and 0.
std::string with_factors(const std::string& version, const std::string& factors) {
    return version + "\nTILT=NONE\n1 1000 1.5 2 1 1 2 0 0 0\n" + factors + "\n0 90\n0\n1000 0\n";
}

}  // namespace

TEST_CASE("the second factor counts before 1995 and never after", "[photometry]") {
    struct Case {
        const char* version;
        const char* factors;
        double candela;
    };
    const Case cases[] = {
        {"IES:LM-63-2019", "0.9 1.10100 50", 1350}, {"IESNA:LM-63-2002", "0.9 0.5 50", 1350},
        {"IESNA:LM-63-1995", "0.9 0.5 50", 1350},   {"IESNA91", "0.9 0.5 50", 675},
        {"Test of a lamp", "0.9 0.5 50", 675},      {"IESNA: LM-63-2002", "1 0.5 50", 1500},
        {"iesna:lm-63-2002", "1 0.5 50", 1500},     {"\n\nIESNA91  ", "1 0.5 50", 750},
        {"IES:LM-63-2030", "1.0, 1.1, 50", 1500},
    };
    for (const Case& each : cases) {
        CAPTURE(each.version);
        CHECK(read(with_factors(each.version, each.factors)).web.greatest() ==
              Approx(each.candela));
    }
    CHECK(read(with_factors("IES:LM-63-2030", "1 1 1")).notes.size() == 1);
}

TEST_CASE("the line of tilt is found however it is written", "[photometry]") {
    const std::string rest = "\n1 100 1 2 1 1 2 0 0 0 1 1 10 0 90 0 5 5";
    for (const char* line : {"TILT=NONE", "  tilt = none ", "TILT=\tNone", "Tilt =NONE"})
        CHECK(read("IESNA91\n" + std::string(line) + rest).web.greatest() == 5);
    const PhotometricFile other = read("IESNA91\nTILT=lamp.tlt" + rest);
    REQUIRE(other.notes.size() == 1);
    CHECK(other.notes[0] ==
          "the factors of tilting are in another file, `lamp.tlt`, and are not read");
    const PhotometricFile tilted = read("IESNA91\nTILT=INCLUDE\n2 3 0 45 90 1 0.9 0.8" + rest);
    REQUIRE(tilted.tilt);
    CHECK(tilted.tilt->geometry == 2);
    CHECK(tilted.tilt->factors == std::vector<double>{1, 0.9, 0.8});
    CHECK(tilted.web.greatest() == 5);
}

TEST_CASE("labels are kept, and continued by MORE", "[photometry]") {
    const PhotometricFile file = read(
        "IESNA:LM-63-1995\n[manufac] Own\n[LUMINAIRE] a lamp\n[MORE] on a pole\n[_MINE] x\n"
        "stray\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0 1 1 10 0 90 0 5 5");
    CHECK(file.label("MANUFAC") == "Own");
    CHECK(file.label("LUMINAIRE") == "a lamp on a pole");
    CHECK(file.label("_MINE") == "x");
    CHECK(file.label("LAMP").empty());
    CHECK(file.absolute);
    CHECK_FALSE(file.lamp_flux());
    CHECK(file.notes == std::vector<std::string>{"line 6 has no keyword in brackets: passed over"});
}

TEST_CASE("numbers too many are noted or refused", "[photometry]") {
    const std::string whole = "TILT=NONE\n1 100 1 2 1 1 2 0 0 0 1 1 10 0 90 0 5 5";
    CHECK(read(whole + " 7 8").notes == std::vector<std::string>{"2 numbers too many"});
    CHECK(read(whole + " 0 0 0 0").notes == std::vector<std::string>{"4 numbers too many"});
    CHECK(read(whole + "\nEND").notes ==
          std::vector<std::string>{"there is other text behind the table"});
    CHECK(problem_of(whole + " 7 8 9") == "there are 3 numbers too many behind the table");
}

TEST_CASE("mistakes in a table are errors that name the line", "[photometry]") {
    struct Case {
        const char* text;
        const char* problem;
    };
    const Case cases[] = {
        {"IESNA91\n1 2 3", "it has no line `TILT=`"},
        {"IESNA:LM-63-1995\n[BLOCK]\nTILT=NONE", "line 2: BLOCK: a file with several luminaires"},
        {"TILT=NONE\n1 100 1 2.5 1 1 2", "line 2: the number of vertical angles is 2.5 and must"},
        {"TILT=NONE\n1 100 1 1 1 1 2", "line 2: the number of vertical angles is 1 and must be"},
        {"TILT=NONE\n1 100 1 2 0 1 2", "line 2: the number of horizontal angles is 0 and must"},
        {"TILT=NONE\n1 100 1 2 1 4 2", "line 2: the type is 4 and must be a whole number"},
        {"TILT=NONE\n1 100 1 2 1 1 3", "line 2: the unit is 3 and must be a whole number"},
        {"TILT=NONE\n1 100 x", "line 2: `x` is no number, and the multiplier of candela is"},
        {"TILT=NONE\n1 100 1 3 1 1 2 0 0 0 1 1 10\n0 90 45",
         "line 3: vertical angle 45 follows 90"},
        {"TILT=NONE\n1 100 1 3 1 1 2 0 0 0 1 1 10\n0 90 270", "line 3: vertical angle 270 is not"},
        {"TILT=NONE\n1 100 1 2 1 1 2 0 0 0 1 1 10\n0 90 0\n5",
         "line 4: the file ends before candela value 2 of 2"},
        {"TILT=NONE\n1 100 1 2 1 1 2 0 0 0 1 1 10\n0 90 0\n5 1e10", "an intensity is more than"},
        {"TILT=NONE\n1 100 1 2 1 1 2 0 0 0 1 1 10\n0 90 0\n5 nan", "line 4: `nan` is no number"},
        {"TILT=INCLUDE\n4", "line 2: the lamp's geometry is 4 and must be"},
        {"TILT=NONE\n1 100 1 2 2 1 2 0 0 0 1 1 10\n0 90 0 45\n5 5 5 5", "its planes go from 0 to"},
    };
    for (const Case& each : cases) {
        CAPTURE(each.text);
        CHECK(problem_of(each.text).starts_with(each.problem));
    }
    CHECK(read("TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 10 0 90 0 -5 5").notes[0] ==
          "negative intensities are taken to be 0");
}

TEST_CASE("signs and zeros tell the shape of the luminous opening", "[photometry]") {
    struct Case {
        int year;
        double width, length, height;
        const char* shape;
    };
    const Case cases[] = {
        {2002, 0, 0, 0, "point"},
        {1991, 0.3, 0.6, 0, "rectangle"},
        {2019, 0.3, 0.6, 0.1, "box"},
        {1991, -0.3, 0, 0, "disc"},
        {2002, -0.3, 0, 0, "disc"},
        {2002, -0.3, -0.3, 0, "disc"},
        {1991, -0.3, 0.6, 0, "ellipse"},
        {2002, -0.3, -0.6, 0, "ellipse"},
        {1986, -0.3, 0, 0.2, "vertical cylinder"},
        {2002, -0.3, -0.3, 0.2, "vertical cylinder"},
        {1995, -0.3, 0.6, 0.2, "vertical elliptic cylinder"},
        {2002, -0.3, -0.6, 0.2, "vertical elliptic cylinder"},
        {1991, -0.3, 0.6, 0.2, "ellipsoid"},
        {1995, -0.3, 0, -0.3, "sphere"},
        {2002, -0.3, -0.3, -0.3, "sphere"},
        {2002, -0.3, -0.6, -0.3, "ellipsoid"},
        {1995, -0.3, 0.6, -0.3, "ellipsoid"},
        {1995, 0, 1.2, -0.1, "horizontal cylinder along"},
        {2002, -0.1, 1.2, -0.1, "horizontal cylinder along"},
        {1995, 1.2, 0, -0.1, "horizontal cylinder across"},
        {2002, 1.2, -0.1, -0.1, "horizontal cylinder across"},
        {2002, -0.12, 0, -0.12, "vertical disc"},
    };
    for (const Case& each : cases) {
        CAPTURE(each.year, each.width, each.length, each.height);
        CHECK(ies_opening(each.year, each.width, each.length, each.height).shape == each.shape);
    }
}

}  // namespace candelabra
