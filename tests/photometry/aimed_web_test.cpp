// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/aimed_web.h"

#include "photometry/photometric_file.h"
#include "photometry/web_table.h"
#include "text/loader.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <numbers>

namespace candelabra {

namespace {

const std::string web_files = CANDELABRA_SOURCE_DIR "/tests/photometry/files/";

WebPlace place_of(const std::string& name) {
    PhotometricFile file;
    REQUIRE(read_photometric(disk_reader()(web_files + name).value_or(""), {}, file) == "");
    WebPlace place;
    place.web = make_handle<PhotometricWeb>(std::move(file.web));
    return place;
}

/// Brighter towards C0 than towards C90, C180 and C270.
WebPlace lopsided() {
    PhotometricWeb web;
    std::string symmetry;
    std::vector<std::string> notes;
    REQUIRE(complete_table({WebType::c, {0, 90}, {0, 90, 180, 270}, {9, 4, 9, 3, 9, 2, 9, 1}}, web,
                           symmetry, notes) == "");
    WebPlace place;
    place.web = make_handle<PhotometricWeb>(std::move(web));
    return place;
}

/// Intensities towards x, z, -x, -z, which are those of C0, C90, C180, C270 as it stands.
std::vector<double> around(const AimedWeb& web) {
    return {web.intensity({1, 0, 0}), web.intensity({0, 0, 1}), web.intensity({-1, 0, 0}),
            web.intensity({0, 0, -1})};
}

bool are(const std::vector<double>& found, const std::vector<double>& expected) {
    for (std::size_t i = 0; i < found.size(); ++i)
        if (std::abs(found[i] - expected[i]) > 1e-9) return false;
    return true;
}

}  // namespace

TEST_CASE("a web stands with its straight down in -y, C0 in x and C90 in z", "[photometry]") {
    std::ifstream list(web_files + "expected.jsonl");
    for (std::string line; std::getline(list, line);) {
        const auto expected = nlohmann::json::parse(line);
        const std::string name = expected["file"];
        CAPTURE(name);
        const AimedWeb web(place_of(name));
        CHECK(web.greatest() == Approx(expected["max_cd"].get<double>()).epsilon(1e-6));
        for (const auto& each : expected["directions"]) {
            const auto d = each["dir"].get<std::vector<double>>();
            CHECK(web.intensity({d[0], d[2], d[1]}) ==
                  Approx(each["cd"].get<double>()).epsilon(1e-6).margin(1e-4));
        }
    }
}

TEST_CASE("a web turns with its lamp, and a mirror mirrors it", "[photometry]") {
    struct Row {
        const char* what;
        Transform transform;
        std::vector<double> expected;
    };
    const std::vector<Row> rows = {
        {"as it stands", Transform(), {4, 3, 2, 1}},
        {"moved", Transform::translation({1, 2, 3}), {4, 3, 2, 1}},
        {"larger", Transform::scaling(Vec3(3)), {4, 3, 2, 1}},
        {"stretched", Transform::scaling({1, 1, 7}), {4, 3, 2, 1}},
        // A positive turn about y takes z to x in this left-handed space.
        {"turned about y", Transform::rotation({0, 90, 0}), {3, 2, 1, 4}},
        {"mirrored in z", Transform::scaling({1, 1, -1}), {4, 1, 2, 3}},
        {"mirrored in x", Transform::scaling({-1, 1, 1}), {2, 3, 4, 1}}};
    for (const Row& row : rows) {
        CAPTURE(row.what);
        WebPlace place = lopsided();
        turn(place, row.transform);
        CHECK(are(around(AimedWeb(place)), row.expected));
    }
    WebPlace up = lopsided();
    turn(up, Transform::rotation({180, 0, 0}));
    CHECK(AimedWeb(up).intensity({0, 1, 0}) == Approx(9));
    CHECK(AimedWeb(up).intensity({0, -1, 0}) == 0);
}

TEST_CASE("two axes turn a web, and only what is across the aim counts", "[photometry]") {
    WebPlace place = lopsided();
    place.aim = Vec3(0, 0, 2);
    place.c0 = Vec3(1, 0, 5);
    const AimedWeb web(place);
    CHECK(web.aim() == Vec3(0, 0, 1));
    CHECK(web.intensity({0, 0, 1}) == Approx(9));
    CHECK(web.intensity({1, 0, 0}) == Approx(4));
    CHECK(web.intensity({-1, 0, 0}) == Approx(2));
    CHECK(has_axes(place));
    place.c0 = Vec3(0, 0, 1);
    CHECK_FALSE(has_axes(place));
    place.c0 = Vec3(0);
    CHECK_FALSE(has_axes(place));
}

TEST_CASE("no light of a web is outside of its cone", "[photometry]") {
    for (const char* name : {"c-axial-2002.ies", "c-full-absolute-2019.ies", "b-flood-1995.ies",
                             "a-beam-2002.ies", "isym3.ldt"}) {
        CAPTURE(name);
        const AimedWeb web(place_of(name));
        double widest = 0, half = 0;
        for (int i = 0; i < 40000; ++i) {
            const double y = 1 - (2 * i + 1) / 40000.0, angle = 2.399963 * i;
            const double across = std::sqrt(1 - y * y);
            const Vec3 direction(across * std::cos(angle), y, across * std::sin(angle));
            const double off = std::acos(-y);
            if (web.intensity(direction) > 0) widest = std::max(widest, off);
            if (web.intensity(direction) > 0.5 * web.greatest()) half = std::max(half, off);
        }
        CHECK(widest <= web.dark() + 1e-9);
        CHECK(half <= web.bright() + 1e-9);
    }
    CHECK(AimedWeb(place_of("c-axial-2002.ies")).dark() < 0.51 * std::numbers::pi);
}

}  // namespace candelabra
