// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <string>

namespace candelabra {

namespace {

/// Returns settings for a scene that is in no file.
SessionSettings of_text(const std::string& text) {
    SessionSettings settings;
    settings.source.text = text;
    settings.source.name = "a text";
    return settings;
}

}  // namespace

TEST_CASE("a scene's file is found without its ending, and what it includes beside it",
          "[session]") {
    const Folder folder;
    folder.put("scene.pov", "#include \"ball.inc\"\nball");
    folder.put("ball.inc", "#declare ball = sphere { 0, 1 }\nobject { ball }\n#macro b() #end");
    Diagnostics diagnostics;
    SessionSettings settings;
    settings.source.path = folder / "scene";
    Session session(settings, diagnostics);
    REQUIRE(session.read());
    session.evaluate();
    REQUIRE(session.files().size() == 2);
    CHECK(session.files()[0].path == folder / "scene.pov");
    CHECK(session.files()[1].path == folder / "ball.inc");
}

TEST_CASE("a scene that is not there is an error", "[session]") {
    Diagnostics diagnostics;
    SessionSettings settings;
    settings.source.path = "nowhere/scene.pov";
    Session session(settings, diagnostics);
    CHECK_FALSE(session.read());
    CHECK(diagnostics.error_count() == 1);
}

TEST_CASE("a scene that changes with the clock is compiled for each shutter sample", "[session]") {
    const std::string text =
        "#version 3.7; camera { shutter 1, 4 } light_source { 9, 1 } sphere { clock, 1 }";
    using enum Session::Shutter;
    for (const auto& [shutter, others] :
         {std::pair(first_sample, 0u), std::pair(all_samples, 3u)}) {
        Diagnostics diagnostics;
        Session session(of_text(text), diagnostics);
        REQUIRE(session.read());
        const World world = session.compile(session.evaluate(), shutter);
        CHECK(world.shutter.size() == others);
        CHECK_FALSE(diagnostics.failed());
    }
}

TEST_CASE("what a scene writes goes to no disk unless it is allowed", "[session]") {
    const Folder folder;
    for (const bool allowed : {false, true}) {
        Diagnostics diagnostics;
        SessionSettings settings = of_text("#fopen F \"" + (folder / "out.txt") +
                                           "\" write\n#write (F, \"x\")\n#fclose F");
        settings.source.writable = {folder.path().string()};
        settings.source.writes_files = allowed;
        Session session(settings, diagnostics);
        REQUIRE(session.read());
        session.evaluate();
        CHECK_FALSE(diagnostics.failed());
        CHECK(disk_reader().holds(folder / "out.txt") == allowed);
    }
}

TEST_CASE("what is likely a mistake is said of a scene", "[session]") {
    Diagnostics diagnostics;
    Session session(of_text("#version 3.7; sphere { 0, 1 }"), diagnostics);
    REQUIRE(session.read());
    session.review(session.evaluate());
    CHECK(diagnostics.all().size() >= 2);  // no camera and no light
    CHECK_FALSE(diagnostics.failed());
}

}  // namespace candelabra
