// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

#include <sys/xattr.h>

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
        const SharedWorld world = session.compile(session.evaluate(), shutter);
        CHECK(world->shutter.size() == others);
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

TEST_CASE("where the current folder is the disk or a home, a scene reads nothing from it",
          "[session]") {
    const Folder folder;
    folder.put("job/s.pov", "#declare A = read_csv(\"/proc/self/environ\");");
    folder.put("job/t.pov", "#include \"etc/hostname\"");
    folder.put("job/u.pov", "#declare A = file_exists(\"/etc/passwd\"); #include \".hidden.inc\"");
    folder.put("job/.hidden.inc", "");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path("/");
    for (const char* name : {"job/s.pov", "job/t.pov", "job/u.pov"}) {
        CAPTURE(name);
        Diagnostics diagnostics;
        SessionSettings settings;
        settings.source.path = folder / name;
        settings.source.picture = "/p.png";
        Session session(settings, diagnostics);
        CHECK(session.read());
        session.evaluate();
        CHECK(diagnostics.failed());
    }
    std::filesystem::current_path(before);
}

TEST_CASE("an included file that another scene has made is passed over with a warning",
          "[session]") {
    const Folder folder;
    folder.put("lib/colors.inc", "#declare Red = 1;");
    folder.put("evil.pov",
               "#fopen F \"colors.inc\" write #write (F, \"#declare Red = 2;\") "
               "#fclose F #include \"colors.inc\" #debug str(Red, 0, 0)");
    folder.put("good.pov", "#include \"colors.inc\" #debug str(Red, 0, 0)");
    const auto run = [&](const std::string& scene, std::string& said) {
        Diagnostics diagnostics;
        SessionSettings settings;
        settings.source.path = folder / (scene + ".pov");
        settings.source.library = {folder / "lib"};
        // As with --allow-write for the folder of the scenes.
        settings.source.writable = {folder / (scene + ".files"), folder.path().string()};
        settings.source.writes_files = true;
        settings.source.made_files = std::make_shared<MadeFiles>(settings.source.path);
        settings.evaluation.print = [&](std::string_view text) { said += text; };
        Session session(settings, diagnostics);
        REQUIRE(session.read());
        const std::filesystem::path before = std::filesystem::current_path();
        std::filesystem::current_path(folder.path());
        session.evaluate();
        std::filesystem::current_path(before);
        for (const Diagnostic& each : diagnostics.all()) said += " " + each.message;
    };
    std::string evil, again, good;
    run("evil", evil);
    run("evil", again);
    CHECK(evil == "2");
    CHECK(again == "2");
    std::string mark(100, '\0');
    if (::getxattr((folder / "colors.inc").c_str(), "user.candelabra.scene", mark.data(),
                   mark.size()) < 0) {
        WARN("this file system has no attributes");
        return;
    }
    run("good", good);
    CHECK(good.starts_with("1 "));
    CHECK(good.find("colors.inc` is passed over, since another scene has made it") != good.npos);
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
