// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/source.h"

#include <catch2/catch.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

TEST_CASE("a source keeps its name, text and place of inclusion, at a stable address") {
    SourceStore sources;
    const SourceId main = sources.add("main.pov", "#include \"a.inc\"");
    const std::string_view text = sources.text(main);
    const std::string* name = &sources.name(main);
    for (int i = 0; i < 100; ++i) sources.add("a.inc", "x", {main, 0, 8});
    CHECK(sources.count() == 101);
    CHECK(sources.text(main).data() == text.data());
    CHECK(&sources.name(main) == name);
    CHECK(*name == "main.pov");
    CHECK_FALSE(sources.included_at(main).known());
    CHECK(sources.included_at(100) == Span{main, 0, 8});
}

TEST_CASE("every style of line end makes the same lines") {
    const std::string_view texts[] = {"ab\n\ncd\n", "ab\r\n\r\ncd\r\n", "ab\r\rcd\r", "ab\n\rcd\n"};
    for (const std::string_view text : texts) {
        CAPTURE(text);
        SourceStore sources;
        const SourceId id = sources.add("a", std::string(text));
        CHECK(sources.line_count(id) == 4);
        CHECK(sources.line(id, 1) == "ab");
        CHECK(sources.line(id, 2) == "");
        CHECK(sources.line(id, 3) == "cd");
        CHECK(sources.line(id, 4) == "");
    }
}

TEST_CASE("places count characters") {
    struct Case {
        std::string text;
        std::uint32_t offset;
        Place place;
    };
    const Case cases[] = {
        {"", 0, {1, 1}},
        {"abc", 0, {1, 1}},
        {"abc", 2, {1, 3}},
        {"abc", 3, {1, 4}},
        {"abc", 99, {1, 4}},
        {"a\nb", 1, {1, 2}},
        {"a\nb", 2, {2, 1}},
        {"a\n", 2, {2, 1}},
        {"a\r\nb", 2, {1, 3}},
        {"a\r\nb", 3, {2, 1}},
        {"a\rb", 2, {2, 1}},
        {"é€b", 5, {1, 3}},
        {"\xE9\xE9z", 2, {1, 3}},
        {"\ta", 1, {1, 2}},
        {"\xEF\xBB\xBFz", 0, {1, 1}},
        {"\xEF\xBB\xBFz", 3, {1, 1}},
        {"\xEF\xBB\xBFz", 4, {1, 2}},
        {"\xEF\xBB\xBF", 3, {1, 1}},
    };
    for (const Case& each : cases) {
        CAPTURE(each.text, each.offset);
        SourceStore sources;
        const Place found = sources.place(sources.add("a", each.text), each.offset);
        CHECK(found.line == each.place.line);
        CHECK(found.column == each.place.column);
    }
}

TEST_CASE("a byte order mark is no part of the first line") {
    SourceStore sources;
    const SourceId id = sources.add("a", "\xEF\xBB\xBFone\ntwo");
    CHECK(sources.line(id, 1) == "one");
    CHECK(sources.line(id, 2) == "two");
}

TEST_CASE("what does not exist is empty") {
    SourceStore sources;
    const SourceId id = sources.add("a", "one");
    CHECK(sources.line(id, 0) == "");
    CHECK(sources.line(id, -5) == "");
    CHECK(sources.line(id, 2) == "");
    CHECK(sources.text(7) == "");
    CHECK(sources.name(no_source) == "");
    CHECK_FALSE(sources.included_at(7).known());
    CHECK(sources.place(7, 3) == Place{1, 1});
}

}  // namespace candelabra
