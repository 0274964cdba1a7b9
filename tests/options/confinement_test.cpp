// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/confinement.h"

#include "support/folder.h"
#include "text/loader.h"

#include <catch2/catch.hpp>

#include <sys/stat.h>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

/// An INI file in the folder of a scene, parsed as the program does it.
struct Stranger {
    Folder folder;
    std::string here = folder / "scene";

    Stranger() {
        folder.put("scene/a.pov", "");
        folder.put("scene/lib/x.inc", "");
        folder.put("scene/old.png", "");
        folder.put("outside.pov", "");
        fs::create_symlink("../outside.pov", folder / "scene/way.pov");
        fs::create_symlink("..", folder / "scene/up");
        fs::create_symlink("../none", folder / "scene/loose.png");
        REQUIRE(mkfifo((folder / "scene/pipe.pov").c_str(), 0600) == 0);
    }

    /// Returns the rule that a line breaks, or "".
    std::string said(const std::string& line, std::vector<std::string> before = {}) const {
        folder.put("scene/a.ini", line + "\n");
        before.push_back(here + "/a.ini");
        return read(before);
    }
    static std::string read(const std::vector<std::string>& arguments,
                            const std::string& settings = {}) {
        const std::vector<std::string_view> words(arguments.begin(), arguments.end());
        Diagnostics diagnostics;
        read_options(words, diagnostics, disk_reader(), settings);
        std::string text;
        for (const Diagnostic& each : diagnostics.all())
            if (each.severity == Severity::error) text += each.message + "\n";
        return text;
    }
};

/// Options that name output files, without their values.
constexpr auto written = {"Output_File_Name=",
                          "+O",
                          "--movie=",
                          "All_File=",
                          "+GA",
                          "Debug_File=",
                          "+GD",
                          "Fatal_File=",
                          "+GF",
                          "Render_File=",
                          "+GR",
                          "Statistic_File=",
                          "+GS",
                          "Warning_File=",
                          "+GW",
                          "--export-mesh=",
                          "--depfile=",
                          "--stats=",
                          "Create_Ini=",
                          "+GI"};

}  // namespace

TEST_CASE("what an INI file of a stranger writes lies below its folder", "[app]") {
    const Stranger stranger;
    for (const std::string option : written) {
        INFO(option);
        CHECK(stranger.said(option + stranger.here + "/new.txt") == "");
        CHECK(stranger.said(option + stranger.here + "/lib/new.txt") == "");
        for (const std::string& path :
             {std::string("/new.txt"), stranger.here + "/../new.txt", stranger.here + "/up/new.txt",
              stranger.here + "/loose.png", stranger.here + "/.hidden/new.txt",
              stranger.here + "/.bashrc", stranger.here + "/way.pov", std::string("/dev/null"),
              std::string("../../../../../../../../new.txt"), stranger.here + "/pipe.pov",
              stranger.here + "/a.pov"}) {
            INFO(path);
            CHECK(stranger.said(option + path) != "");
        }
    }
    CHECK(stranger.said("Debug_File=" + stranger.here + "/other.ini") != "");
    CHECK(stranger.said("Debug_File=" + stranger.here + "/other.INI.") != "");
    CHECK(stranger.said("Debug_File=" + stranger.here + "/x.state.exr") != "");
    CHECK(stranger.said("Debug_File=off") == "");
    CHECK(stranger.said("--stats=-") == "");
    CHECK(stranger.said("Output_File_Name=" + stranger.here + "/") == "");
    CHECK(stranger.said("Create_Ini=" + stranger.here + "/all.ini") == "");
    CHECK(stranger.said("Create_Ini=" + stranger.here + "/a.ini") != "");
}

TEST_CASE("what an INI file of a stranger reads lies below its folder", "[app]") {
    const Stranger stranger;
    const std::string& here = stranger.here;
    stranger.folder.put("scene/lib/b.ini", "Width=10\n");
    stranger.folder.put("other.ini", "Width=10\n");
    for (const std::string& line :
         {"Input_File_Name=" + here + "/a.pov", "+I" + here + "/a", here + "/a.pov",
          "Library_Path=" + here, "+L" + here + "/lib", "Include_Header=" + here + "/lib/x.inc",
          std::string("Include_Header=colors.inc"), here + "/lib/b.ini"}) {
        INFO(line);
        CHECK(stranger.said(line) == "");
    }
    const std::string up = here + "/../";
    for (const std::string& line :
         {std::string("Input_File_Name=/etc/passwd"), "+I" + up + "outside.pov", up + "outside.pov",
          here + "/way.pov", here + "/way", here + "/pipe.pov", here + "/pipe", std::string("+I-"),
          std::string("Library_Path=/"), "+L" + here + "/up",
          std::string("Include_Header=/etc/passwd"), std::string("+HI../x.inc"),
          up + "other.ini"}) {
        INFO(line);
        CHECK(stranger.said(line) != "");
    }
}

TEST_CASE("an INI file that a stranger's names is judged and opened in one", "[app]") {
    const Stranger stranger;
    stranger.folder.put("scene/lib/b.ini", "Width=10\n");
    stranger.folder.put("scene/a.ini", stranger.here + "/lib/b.ini\n");
    const Reader disk = disk_reader();
    std::vector<std::string> by_user, by_stranger;
    const Reader reader(
        [&](const std::string& path) {
            by_user.push_back(path);
            return disk(path);
        },
        [&](const std::string& path) { return disk.holds(path); },
        [&](const FileAccess& access) {
            return Reader([&, access](const std::string& path) {
                by_stranger.push_back(path);
                return scene_reader(access)(path);
            });
        });
    Diagnostics diagnostics;
    const std::string named = stranger.here + "/a.ini";
    const std::vector<std::string_view> words = {named};
    CHECK(read_options(words, diagnostics, reader).render.width == 10);
    CHECK(by_user == std::vector{named});
    CHECK(by_stranger == std::vector{stranger.here + "/lib/b.ini"});
}

TEST_CASE("an INI file of a stranger permits nothing and raises no limit", "[app]") {
    const Stranger stranger;
    for (const char* line :
         {"--allow-read=/", "--allow-write=/", "--allow-commands", "--preview=0",
          "--limit-steps=1e12", "--limit-depth=1e8", "--limit-nesting=1e8", "--limit-objects=1e12",
          "--limit-includes=1000", "--limit-files=1e9", "--limit-elements=1e9",
          "--limit-written=1e6", "--limit-said=1e6", "--limit-text=1e6", "--limit-function=1e9",
          "--limit-work=1e9", "--limit-memory=1e9", "--memory=100T"}) {
        INFO(line);
        CHECK(stranger.said(line) != "");
        CHECK(stranger.said(std::string("Width=10\n") + line) != "");
    }
    for (const char* line : {"--limit-steps=1000", "--limit-work=1", "--limit-memory=16",
                             "--memory=16M", "--limit-depth=10\n--limit-depth=20"}) {
        INFO(line);
        CHECK(stranger.said(line) == "");
    }
    CHECK(stranger.said("--limit-steps=900000000", {"--limit-steps=1e9"}) == "");
    CHECK(stranger.said("--limit-steps=1e10", {"--limit-steps=1e9"}) != "");
}

TEST_CASE("what the user permits holds for INI files as well, wherever it is said", "[app]") {
    const Stranger stranger;
    const std::string& all = stranger.folder / ".";
    stranger.folder.put("scene/a.ini", "Input_File_Name=" + stranger.folder / "outside.pov" + "\n");
    const std::string ini = stranger.here + "/a.ini";
    CHECK(Stranger::read({ini}) != "");
    CHECK(Stranger::read({"--allow-read", all, ini}) == "");
    CHECK(Stranger::read({ini, "--allow-read=" + all}) == "");
    stranger.folder.put("scene/a.ini", "Debug_File=" + stranger.folder / "said.txt" + "\n");
    CHECK(Stranger::read({ini, "--allow-read=" + all}) != "");
    CHECK(Stranger::read({ini, "--allow-write", all}) == "");
    // The user's own settings are trusted, but files that they name are not.
    const std::string settings = stranger.folder / "settings.ini";
    stranger.folder.put("settings.ini", "Library_Path=/\n--limit-steps=1e10\n");
    CHECK(Stranger::read({}, settings) == "");
    stranger.folder.put("scene/a.ini", "Library_Path=/\n");
    stranger.folder.put("settings.ini", ini + "\n");
    CHECK(Stranger::read({}, settings) != "");
    CHECK(Stranger::read({"+L/", "+O/tmp/x.png", "+I/etc/passwd"}) == "");
}

TEST_CASE("an INI file of a stranger reads no hidden files, and no whole home or disk") {
    const Stranger stranger;
    for (const char* line : {"Library_Path=", "+L", "Include_Header=", "+I"}) {
        CAPTURE(line);
        CHECK(stranger.said(line + stranger.here + "/.secret") != "");
        CHECK(stranger.said(line + stranger.here + "/.git/x.inc") != "");
    }
    const Confinement root("/x.ini", Options());
    const auto refuses = [&](std::string_view keyword, const std::string& value) {
        for (const OptionRow& row : option_table())
            if (row.keyword == keyword)
                return !root.of_option(row, {keyword, true, value}).rule.empty();
        return false;
    };
    CHECK(refuses("Library_Path", "/etc"));
    CHECK(refuses("Library_Path", "/"));
    CHECK(refuses("Include_Header", "/etc/passwd"));
    CHECK(refuses("Output_File_Name", "/usr/x.png"));
    CHECK(refuses("Input_File_Name", "/etc/passwd"));
    CHECK_FALSE(refuses("Input_File_Name", "/a.pov"));
    CHECK_FALSE(refuses("Output_File_Name", "/a.png"));
    Options permitted;
    permitted.readable = {"/"};
    const Confinement free("/x.ini", permitted);
    CHECK(free.of_read("/etc/a.pov").rule.empty());
}

}  // namespace candelabra
