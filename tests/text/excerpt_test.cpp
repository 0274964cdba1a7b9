// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/excerpt.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <regex>
#include <string>
#include <string_view>

namespace candelabra {

namespace {

/// Two files, the second included by the first.
struct Scene {
    SourceStore sources;
    SourceId main = sources.add("main.pov",
                                "// a scene\n"
                                "#include \"parts.inc\"\n"
                                "Washer(2)\n"
                                "union {\n"
                                "    box { 0, 1 }\n"
                                "    cone { 2 }\n"
                                "\n");
    SourceId parts = sources.add("parts.inc",
                                 "#macro Washer(Gauge)\n"
                                 "    #local Twice = 2 * Gauge;\n"
                                 "    // the ring\n"
                                 "    torus { 4, Gauge - 5 }\n"
                                 "#end",
                                 at(main, "\"parts.inc\""));

    Span at(SourceId source, std::string_view words) const {
        const std::size_t first = sources.text(source).find(words);
        REQUIRE(first != std::string_view::npos);
        return {source, static_cast<std::uint32_t>(first),
                static_cast<std::uint32_t>(first + words.size())};
    }

    std::string print(const Diagnostic& diagnostic) const {
        return '\n' + format(diagnostic, sources, false);
    }
};

}  // namespace

TEST_CASE("a message with everything") {
    const Scene scene;
    Diagnostic diagnostic = error(Fault::out_of_range, scene.at(scene.parts, "Gauge - 5"),
                                  "`minor` of `torus` must be above 0, but it is -3")
                                .with_label("this is -3")
                                .with_help("torus { major, minor [careful] }");
    diagnostic.frames = {{Frame::macro, "Washer", scene.at(scene.main, "Washer(2)")}};
    CHECK(scene.print(diagnostic) == R"(
error: `minor` of `torus` must be above 0, but it is -3
 --> parts.inc:4:16
  |
4 |     torus { 4, Gauge - 5 }
  |                ^^^^^^^^^ this is -3
  |
  = in macro `Washer`, called at main.pov:3:1
  = `parts.inc` is included at main.pov:2:10
help: torus { major, minor [careful] }
)");
}

TEST_CASE("without a place there is no excerpt") {
    const Scene scene;
    CHECK(scene.print(warning(Fault::missing, {}, "there is no camera").with_help("camera { }")) ==
          R"(
warning[missing]: there is no camera
help: camera { }
)");
    CHECK(scene.print(note(Fault::io, {}, "written").with_note("in 2 seconds\nby one thread")) ==
          R"(
note: written
  = in 2 seconds
    by one thread
)");
    CHECK(scene.print(error(Fault::io, {99, 0, 1}, "of no source")) == "\nerror: of no source\n");
}

TEST_CASE("labels on the same line, near lines, far lines and in other files") {
    const Scene scene;
    CHECK(scene.print(error(Fault::domain, scene.at(scene.parts, "Gauge - 5"), "too small")
                          .with_label("this")
                          .pointing(scene.at(scene.parts, "torus"), "of this")
                          .pointing(scene.at(scene.parts, "2 * Gauge"), "two lines up")
                          .pointing(scene.at(scene.main, "2"), "given here")
                          .pointing(scene.at(scene.main, "cone"), "far from there")) == R"(
error: too small
 --> parts.inc:4:16
  |
2 |     #local Twice = 2 * Gauge;
  |                    --------- two lines up
3 |     // the ring
4 |     torus { 4, Gauge - 5 }
  |     -----      ^^^^^^^^^ this
  |     |
  |     of this
  |
 ::: main.pov:3:8
  |
3 | Washer(2)
  |        - given here
...
6 |     cone { 2 }
  |     ---- far from there
  |
  = `parts.inc` is included at main.pov:2:10
)");
}

TEST_CASE("a label is shown where the diagnostic itself has no place") {
    const Scene scene;
    CHECK(scene.print(error(Fault::missing, {}, "no camera")
                          .pointing(scene.at(scene.main, "union"), "only this")) == R"(
error: no camera
 --> main.pov:4:1
  |
4 | union {
  | ----- only this
)");
}

TEST_CASE("a span of several lines shows its first") {
    const Scene scene;
    Span span = join(scene.at(scene.main, "union"), scene.at(scene.main, "cone { 2 }"));
    CHECK(scene.print(error(Fault::missing, span, "no end").with_label("this block")) == R"(
error: no end
 --> main.pov:4:1
  |
4 | union {
  | ^^^^^^^ this block (to line 6)
)");
    span.last = scene.at(scene.main, "union {\n").last;
    CHECK(scene.print(error(Fault::missing, span, "with the line's end")) == R"(
error: with the line's end
 --> main.pov:4:1
  |
4 | union {
  | ^^^^^^^
)");
}

TEST_CASE("what is missing at the end is missing after the last word") {
    const Scene scene;
    const auto end = static_cast<std::uint32_t>(scene.sources.text(scene.main).size());
    const std::string expected = R"(
error: no end
 --> main.pov:6:15
  |
4 | union {
  |       - opened here
5 |     box { 0, 1 }
6 |     cone { 2 }
  |               ^ `}` is missing
)";
    for (const Span span : {Span{scene.main, end, end}, Span{scene.main, end + 7, end + 9}}) {
        Span brace = scene.at(scene.main, "{\n    b");
        brace.last = brace.first + 1;
        CHECK(scene.print(error(Fault::unterminated, span, "no end")
                              .with_label("`}` is missing")
                              .pointing(brace, "opened here")) == expected);
    }
}

TEST_CASE("empty sources and odd offsets have a place") {
    SourceStore sources;
    const SourceId empty = sources.add("empty", "");
    const SourceId mark = sources.add("mark", "\xEF\xBB\xBF");
    const SourceId line_end = sources.add("crlf", "ab\r\ncd");
    const auto place = [&](Span span) {
        const std::string text = format(error(Fault::syntax, span, "x"), sources, false);
        return text.substr(text.find("-->"));
    };
    CHECK(place({empty, 0, 0}) == "--> empty:1:1\n  |\n1 |\n  | ^\n");
    CHECK(place({empty, 5, 2}) == "--> empty:1:1\n  |\n1 |\n  | ^\n");
    CHECK(place({mark, 0, 1}) == "--> mark:1:1\n  |\n1 |\n  | ^\n");
    CHECK(place({line_end, 2, 3}) == "--> crlf:1:3\n  |\n1 | ab\n  |   ^\n");
    CHECK(place({line_end, 3, 4}) == "--> crlf:1:4\n  |\n1 | ab\n  |   ^\n");
    CHECK(place({line_end, 5, 4}) == "--> crlf:2:2\n  |\n2 | cd\n  |  ^\n");
}

TEST_CASE("of many frames the first and the last five are shown") {
    const Scene scene;
    Diagnostic diagnostic = error(Fault::recursion_limit, {}, "too deep");
    for (int i = 0; i < 10; ++i) {
        diagnostic.frames.push_back({Frame::macro, "m" + std::to_string(i), {}});
    }
    std::string text = format(diagnostic, scene.sources, false);
    CHECK(std::count(text.begin(), text.end(), '\n') == 11);
    CHECK(text.find("more") == std::string::npos);
    for (int i = 10; i < 100; ++i) {
        diagnostic.frames.push_back({Frame::macro, "m" + std::to_string(i), {}});
    }
    text = format(diagnostic, scene.sources, false);
    CHECK(std::count(text.begin(), text.end(), '\n') == 12);
    CHECK(text.find("`m4`, called at an unknown place\n  = ... 90 more\n  = in macro `m95`") !=
          std::string::npos);
}

TEST_CASE("frames of every kind, and no inclusion said twice") {
    const Scene scene;
    Diagnostic diagnostic = error(Fault::syntax, scene.at(scene.parts, "torus"), "x");
    diagnostic.frames = {
        {Frame::loop, "#while", scene.at(scene.main, "union")},
        {Frame::include, "parts.inc", scene.at(scene.main, "\"parts.inc\"")},
        {Frame::macro, "Washer", scene.at(scene.main, "Washer(2)")},
    };
    const std::string text = format(diagnostic, scene.sources, false);
    CHECK(
        text.ends_with("  = in loop `#while` at main.pov:4:1\n"
                       "  = `parts.inc` is included at main.pov:2:10\n"
                       "  = in macro `Washer`, called at main.pov:3:1\n"));
}

TEST_CASE("a chain of inclusions is told from the inside, and a circle ends") {
    SourceStore sources;
    const SourceId a = sources.add("a", "x", {2, 0, 1});
    const SourceId b = sources.add("b", "x", {a, 0, 1});
    const SourceId c = sources.add("c", "x", {b, 0, 1});
    const std::string text = format(error(Fault::syntax, {c, 0, 1}, "x"), sources, false);
    CHECK(text.ends_with("  |\n  = `c` is included at b:1:1\n  = `b` is included at a:1:1\n"));
}

TEST_CASE("messages of several lines are indented, and control characters are printable") {
    SourceStore sources;
    const SourceId id = sources.add("odd\x1bname", "\x1b[31mred");
    CHECK(format(error(Fault::user_error, {id, 0, 5}, "one\n\ntwo\x1b[0m\n").with_help("a\nb"),
                 sources, false) ==
          "error: one\n\n       two␛[0m\n --> odd␛name:1:1\n  |\n1 | ␛[31mred\n  | ^^^^^\n"
          "help: a\n      b\n");
    CHECK(format(error(Fault::user_error, {}, ""), sources, false) == "error: \n");
}

TEST_CASE("colours add escape sequences and nothing else") {
    const Scene scene;
    const std::regex escape("\x1b\\[[0-9;]*m");
    for (const auto make : {error, warning, note}) {
        Diagnostic diagnostic = make(Fault::domain, scene.at(scene.parts, "Gauge - 5"), "small\nx")
                                    .with_label("this")
                                    .with_help("help")
                                    .with_note("note")
                                    .pointing(scene.at(scene.parts, "torus"), "of this")
                                    .pointing(scene.at(scene.main, "2"), "given here");
        const std::string plain = format(diagnostic, scene.sources, false);
        const std::string coloured = format(diagnostic, scene.sources, true);
        CHECK(plain.find('\x1b') == std::string::npos);
        CHECK(coloured.size() > plain.size());
        CHECK(std::regex_replace(coloured, escape, "") == plain);
    }
}

}  // namespace candelabra
