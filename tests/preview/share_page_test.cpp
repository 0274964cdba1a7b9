// SPDX-License-Identifier: GPL-3.0-or-later
// tests/production/share_page.py looks at pages in a browser.
#include "preview/share_page.h"

#include "support/shell.h"

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

SharedPicture shared(const std::string& title, std::vector<std::string> lamps) {
    SharedPicture picture;
    picture.title = title;
    picture.name = title;
    picture.width = 2;
    picture.height = 1;
    picture.lamps = std::move(lamps);
    picture.lamps.emplace_back("rest");
    const std::vector<Image> lights(picture.lamps.size(), Image(2, 1));
    picture.light = light_code(lights, 1);
    picture.film.on = true;
    return picture;
}

std::string between(const std::string& text, const std::string& from, const std::string& to) {
    const std::size_t start = text.find(from);
    if (start == text.npos) return "";
    const std::size_t first = start + from.size();
    return text.substr(first, text.find(to, first) - first);
}

nlohmann::json facts(const std::string& page) {
    return nlohmann::json::parse(between(page, "id=\"data\">", "</script>"));
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

}  // namespace

TEST_CASE("a page to share names nothing outside of itself") {
    const std::string page = share_page(shared("ring", {"Top"}));
    CHECK(has(page, "default-src 'none'"));
    for (const char* outside : {"http:", "https:", "src=", "fetch(", "import ", "url("}) {
        CAPTURE(outside);
        CHECK_FALSE(has(page, outside));
    }
    CHECK_FALSE(has(page, "-OF-THE-PAGE"));
    CHECK(count(page, "<title>ring</title>") == 1);
}

TEST_CASE("a page that a server makes asks this server alone") {
    SharedPicture picture = shared("ring", {"Top"});
    picture.watched = 7;
    const std::string page = share_page(picture);
    CHECK(has(page, "default-src 'none'"));
    CHECK(has(page, "connect-src 'self'\""));
    CHECK(count(page, "fetch(") == 1);
    CHECK(facts(page).at("watched") == 7);
    CHECK_FALSE(has(page, "-OF-THE-PAGE"));
}

TEST_CASE("names in a page to share are text, whatever they are") {
    const std::string hostile = "</script><script>hacked()</script><!-- \"x\" & DATA-OF-THE-PAGE";
    const std::string harmless = share_page(shared("ring", {"Top"}));
    const std::string page = share_page(shared(hostile, {hostile, "Sign \xff\x01"}));
    for (const char* part : {"<script", "</script", "<!--"}) {
        CAPTURE(part);
        CHECK(count(page, part) == count(harmless, part));
    }
    CHECK(facts(page)["names"][0] == hostile);
    CHECK(facts(page)["lamps"][2] == "Other light");
    CHECK(facts(page)["names"][2] == "rest");
}

TEST_CASE("a page to share has the numbers of its film") {
    SharedPicture picture = shared("ring", {});
    CHECK_FALSE(facts(share_page(picture))["film"].contains("curve"));
    picture.film.response = "agx";
    picture.film.white_balance = 4000;
    picture.exposure = -1.5;
    const nlohmann::json film = facts(share_page(picture))["film"];
    CHECK(film["exposure"] == -1.5);
    CHECK(film["balance"].size() == 9);
    CHECK(film["curve"]["values"].size() == 449);
    CHECK(film["agx"]["half_kept_exposure"] == 16);
}

TEST_CASE("light has the room that a page leaves") {
    const SharedPicture picture = shared("ring", {"Top"});
    const std::size_t frame = share_page(picture).size();
    CHECK(room_for_light(picture, frame / 2) == 0);
    SharedPicture full = picture;
    full.light.bytes = std::string(room_for_light(picture, 200'000), 'x');
    CHECK(share_page(full).size() <= 200'000);
    CHECK(share_page(full).size() > 199'000);
}

}  // namespace candelabra
