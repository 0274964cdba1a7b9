// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/photometric_file.h"

#include "text/loader.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

namespace candelabra {

namespace {

const std::string folder = CANDELABRA_SOURCE_DIR "/tests/photometry/files/";

std::string content(const std::string& name) {
    const auto text = disk_reader()(folder + name);
    REQUIRE(text);
    return *text;
}

std::string type_letter(WebType type) {
    return type == WebType::c ? "C" : type == WebType::b ? "B" : "A";
}

}  // namespace

TEST_CASE("files of all years and symmetries have the flux and candela expected of them",
          "[photometry]") {
    std::ifstream list(folder + "expected.jsonl");
    int count = 0;
    for (std::string line; std::getline(list, line); ++count) {
        const auto expected = nlohmann::json::parse(line);
        const std::string name = expected["file"];
        CAPTURE(name);
        PhotometricFile file;
        REQUIRE(read_photometric(content(name), {}, file) == "");
        CHECK(type_letter(file.web.type()) == expected["type"].get<std::string>());
        CHECK(file.symmetry == expected["symmetry"].get<std::string>());
        CHECK(file.web.flux() == Approx(expected["flux_lm"].get<double>()).epsilon(1e-6));
        if (expected.contains("down_lm"))
            CHECK(file.web.flux_down() == Approx(expected["down_lm"].get<double>()).epsilon(1e-6));
        CHECK(file.web.greatest() == Approx(expected["max_cd"].get<double>()).epsilon(1e-6));
        for (const auto& each : expected["directions"]) {
            const auto d = each["dir"].get<std::vector<double>>();
            CHECK(file.web.intensity(Vec3(d[0], d[1], d[2])) ==
                  Approx(each["cd"].get<double>()).epsilon(1e-6).margin(1e-4));
        }
        CHECK(file.absolute == expected["absolute"].get<bool>());
        if (expected.contains("watts")) CHECK(file.watts == expected["watts"].get<double>());
        if (expected.contains("version")) CHECK(file.version == expected["version"].get<int>());
        if (expected.contains("lumens_per_lamp"))
            CHECK(file.lumens_per_lamp == expected["lumens_per_lamp"].get<double>());
        if (expected.contains("opening_m")) {
            const auto opening = expected["opening_m"].get<std::vector<double>>();
            CHECK(file.opening.width == Approx(opening[0]));
            CHECK(file.opening.length == Approx(opening[1]));
            CHECK(file.opening.height == Approx(opening[2]));
        }
        if (expected.contains("tilt")) {
            REQUIRE(file.tilt);
            CHECK(file.tilt->angles == expected["tilt"]["angles"].get<std::vector<double>>());
            CHECK(file.tilt->factors == expected["tilt"]["factors"].get<std::vector<double>>());
        }
        if (expected.contains("sets")) CHECK(file.sets.size() == expected["sets"].size());
    }
    CHECK(count == 14);
}

TEST_CASE("a file that is cut short is an error and not another luminaire", "[photometry]") {
    for (const char* name : {"c-quadrant-1995.ies", "tilt-include-1986.ies", "isym0.ldt"}) {
        const std::string whole = content(name);
        const std::size_t last = whole.find_last_of("0123456789");
        for (std::size_t length = 0; length < last; ++length) {
            PhotometricFile file;
            const bool within_last_number = whole.find_first_not_of("0123456789.", length) > last;
            CAPTURE(name, length);
            CHECK(
                (read_photometric(whole.substr(0, length), {}, file) != "" || within_last_number));
        }
    }
}

TEST_CASE("what contradicts itself is noted", "[photometry]") {
    PhotometricFile file;
    REQUIRE(read_photometric("IESNA:LM-63-2002\nTILT=NONE\n1 10 1 2 1 1 2 8 8 0 1 1 5\n"
                             "0 90\n0\n100 100\n",
                             {}, file) == "");
    REQUIRE(file.notes.size() == 2);
    CHECK(file.notes[0] == "the luminous opening is 8 m large: its unit may be wrong");
    CHECK(file.notes[1] == "the flux of the table, 628 lm, is more than that of the lamps, 10 lm");
    std::string odd = content("isym0.ldt");
    odd.replace(odd.find("78.1"), 4, "98.1");
    REQUIRE(read_photometric(odd, {}, file) == "");
    REQUIRE(file.notes.size() == 1);
    CHECK(file.notes[0].starts_with("the table gives 78.1 % of the lamps' flux, and the file"));
}

TEST_CASE("no file takes much memory or time", "[photometry]") {
    PhotometricFile file;
    CHECK(read_photometric(std::string(max_photometric_bytes + 1, ' '), {}, file) != "");
    CHECK(read_photometric("TILT=NONE\n1 1 1 4000 4000 1 1 0 0 0 1 1 1\n0 1", {}, file) ==
          "line 2: the table has more than a million entries");
    CHECK(read_photometric("TILT=NONE\n1 1 1 1e9 1 1 1 0 0 0 1 1 1\n", {}, file) ==
          "line 2: the number of vertical angles is 1000000000 and must be a whole number from 2 "
          "to 4096");
    CHECK(read_photometric("", {}, file) != "");
    CHECK(read_photometric(std::string(1000, '\0'), {}, file) != "");
}

}  // namespace candelabra
