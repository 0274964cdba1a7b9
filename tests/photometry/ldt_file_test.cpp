// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/ldt_file.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct Ldt {
    int symmetry = 1, around = 4;
    std::string planes = "0\n90\n180\n270\n", sets = "1\n2\nLED\n1000\n3000\n80\n10\n";
    std::string conversion = "1", efficiency = "0";
    std::string opening = "300\n200\n0\n0\n0\n0\n";
    std::vector<int> values = {100, 50};  ///< cd in 1000 lm, at 0 and 90 degrees of each plane
};

std::string text_of(const Ldt& ldt) {
    std::string text =
        "Maker\n1\n" + std::to_string(ldt.symmetry) + "\n" + std::to_string(ldt.around) +
        "\n90\n2\n90\nreport\nname\nnumber\nfile\ndate\n300\n200\n100\n" + ldt.opening + "100\n" +
        ldt.efficiency + "\n" + ldt.conversion + "\n0\n" + ldt.sets;
    for (int i = 0; i < 10; ++i) text += "0\n";
    text += ldt.planes + "0\n90\n";
    for (const int value : ldt.values) text += std::to_string(value) + "\n";
    return text;
}

PhotometricFile read_made(const Ldt& ldt, std::size_t set = 0) {
    PhotometricFile file;
    REQUIRE(read_ldt(text_of(ldt), {set}, file) == "");
    return file;
}

std::string problem_made(const Ldt& ldt, std::size_t set = 0) {
    PhotometricFile file;
    return read_ldt(text_of(ldt), {set}, file);
}

double around(const PhotometricFile& file, double angle) {
    return file.web.intensity(WebAngles{90, angle});
}

}  // namespace

TEST_CASE("candela are those of the lamps' flux, and of the conversion", "[photometry]") {
    CHECK(read_made({}).web.greatest() == Approx(100));
    CHECK(
        read_made({.sets = "1\n1\nLED\n5200\n3000\n80\n10\n", .values = {250, 0}}).web.greatest() ==
        Approx(1300));
    CHECK(read_made({.conversion = "1,25"}).web.greatest() == Approx(125));
    for (const char* none : {"", "0", "-1"})
        CHECK(read_made({.conversion = none}).web.greatest() == Approx(100));
    const PhotometricFile absolute = read_made({.sets = "1\n-1\nLED\n1000\n3000\n80\n10\n"});
    CHECK(absolute.absolute);
    CHECK_FALSE(absolute.lamp_flux());
    CHECK(absolute.label("MANUFAC") == "Maker");
    CHECK(absolute.label("LUMINAIRE") == "name");
}

TEST_CASE("sets of lamps are alternatives", "[photometry]") {
    const Ldt two{.sets = "2\n1\n1\nA\nB\n1000\n500\n3000\n4000\n80\n90\n10\n5\n"};
    const PhotometricFile first = read_made(two), second = read_made(two, 1);
    CHECK(first.web.greatest() == Approx(100));
    CHECK(second.web.greatest() == Approx(50));
    CHECK(second.watts == 5);
    CHECK(second.sets[1].type == "B");
    CHECK(first.notes.size() == 1);
    CHECK(problem_made(two, 2) == "it has 2 sets of lamps, and no number 3");
}

TEST_CASE("planes are unfolded as Isym says", "[photometry]") {
    // The values at 90 degrees are 10, 20, 30 ... by plane.
    const PhotometricFile none = read_made({.symmetry = 0, .values = {5, 10, 5, 20, 5, 30, 5, 40}});
    CHECK(around(none, 270) == Approx(40));
    CHECK(around(none, 315) == Approx(25));
    const PhotometricFile one = read_made({.symmetry = 1, .values = {5, 10}});
    CHECK(around(one, 123) == Approx(10));
    const PhotometricFile two = read_made({.symmetry = 2, .values = {5, 10, 5, 20, 5, 30}});
    CHECK(around(two, 180) == Approx(30));
    CHECK(around(two, 270) == Approx(20));
    // C270, C0, C90
    const PhotometricFile three = read_made({.symmetry = 3, .values = {5, 10, 5, 20, 5, 30}});
    CHECK(around(three, 270) == Approx(10));
    CHECK(around(three, 0) == Approx(20));
    CHECK(around(three, 90) == Approx(30));
    CHECK(around(three, 180) == Approx(20));
    const PhotometricFile four = read_made({.symmetry = 4, .values = {5, 10, 5, 20}});
    CHECK(around(four, 90) == Approx(20));
    CHECK(around(four, 270) == Approx(20));
    CHECK(around(four, 180) == Approx(10));
}

TEST_CASE("mistakes of a file are errors that name the line", "[photometry]") {
    CHECK(problem_made({.symmetry = 2, .around = 5, .planes = "0\n72\n144\n216\n288\n"}) ==
          "line 26: 5 C planes do not fit Isym 2");
    CHECK(problem_made({.planes = "0\n90\nx\n270\n"}) ==
          "line 45: `x` is no number, and C angle 3 of 4 is wanted");
    CHECK(problem_made({.symmetry = 5})
              .starts_with("line 3: the number of the symmetry (Isym) is 5 and must be a whole "
                           "number from 0 to 4"));
    CHECK(problem_made({.values = {100}}).ends_with("the file ends before intensity 2 of 2"));
    CHECK(problem_made({.symmetry = 0,
                        .planes = "0\n90\n80\n270\n",
                        .values = {5, 10, 5, 20, 5, 30, 5, 40}}) == "the C angles do not increase");
    CHECK(problem_made({.symmetry = 4, .planes = "0\n45\n90\n135\n", .values = {5, 10, 5, 20}}) !=
          "");
}

TEST_CASE("the opening is round where its width is 0", "[photometry]") {
    CHECK(read_made({}).opening.shape == "rectangle");
    CHECK(read_made({}).opening.length == Approx(0.3));
    const LuminousOpening disc = read_made({.opening = "300\n0\n0\n0\n0\n0\n"}).opening;
    CHECK(disc.shape == "disc");
    CHECK(disc.width == Approx(-0.3));
    CHECK(read_made({.opening = "300\n0\n50\n50\n50\n50\n"}).opening.shape == "vertical cylinder");
    CHECK(read_made({.opening = "300\n200\n50\n0\n0\n0\n"}).opening.shape == "box");
    CHECK(read_made({.opening = "0\n0\n0\n0\n0\n0\n"}).opening.shape == "point");
}

}  // namespace candelabra
