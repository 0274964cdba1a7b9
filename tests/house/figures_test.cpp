// SPDX-License-Identifier: GPL-3.0-or-later
// The times that pages give stand in tests/bench/figures.csv, so that no two pages differ.
#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace candelabra {

namespace {

const std::string top = CANDELABRA_SOURCE_DIR "/";

struct Figure {
    std::string before, time;
    std::vector<std::string> pages;
};

std::vector<Figure> figures() {
    std::vector<Figure> all;
    std::ifstream file(top + "tests/bench/figures.csv");
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream cells(line);
        Figure figure;
        std::string pages;
        std::getline(cells, figure.before, ';');
        std::getline(cells, figure.time, ';');
        std::getline(cells, pages, ';');
        std::istringstream names(pages);
        for (std::string name; names >> name;) figure.pages.push_back(name);
        INFO(line);
        REQUIRE_FALSE(figure.pages.empty());
        all.push_back(figure);
    }
    return all;
}

/// The text of a page with single blanks between its words.
std::string words_of(const std::string& page) {
    std::ifstream file(top + page);
    REQUIRE(file);
    std::string text;
    for (std::string word; file >> word;) text += word + " ";
    return text;
}

}  // namespace

TEST_CASE("a time that a page gives stands in the table of figures", "[house]") {
    const std::vector<Figure> all = figures();
    REQUIRE(all.size() > 10);
    std::set<std::string> pages;
    for (const Figure& each : all) pages.insert(each.pages.begin(), each.pages.end());
    const std::regex time(R"((\d[\d.,]*) (s|minutes)\b)");
    for (const std::string& page : pages) {
        const std::string text = words_of(page);
        std::map<std::string, int> found;
        for (std::sregex_iterator i(text.begin(), text.end(), time), end; i != end; ++i) {
            // The words that stand nearest before it decide whose time it is.
            const std::string before = text.substr(0, static_cast<std::size_t>(i->position()));
            const Figure* owner = nullptr;
            std::size_t nearest = 0;
            for (const Figure& each : all) {
                const std::size_t at = before.rfind(each.before);
                if (at == std::string::npos || (owner && at < nearest)) continue;
                owner = &each;
                nearest = at;
            }
            INFO(page << ": " << text.substr(nearest, 120));
            REQUIRE(owner);
            constexpr std::size_t reach = 100;
            CHECK(before.size() - nearest <= reach);
            CHECK(i->str() == owner->time);
            ++found[owner->before];
        }
        for (const Figure& each : all) {
            INFO(page << ": " << each.before);
            const bool wanted = std::ranges::find(each.pages, page) != each.pages.end();
            CHECK((found[each.before] > 0) == wanted);
        }
    }
}

}  // namespace candelabra
