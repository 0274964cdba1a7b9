// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/made_files.h"

#include "support/folder.h"

#include <unistd.h>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

struct MadePlace {
    Folder folder;
    std::string here = fs::canonical(folder.path()).string() + "/";

    /// Writes the letter; returns whether that was permitted.
    bool write(MadeFiles& made, const std::string& name, char letter, bool append = false,
               bool any = false) const {
        CHECK(made.may_write(here + name, any) == bool(made.open(here + name, true, any)));
        const OpenedFile file = made.open(here + name, append, any);
        return file && ::write(file.descriptor(), &letter, 1) == 1;
    }
};

}  // namespace

TEST_CASE("a scene writes to files that it has made, and to no others", "[file_access]") {
    const MadePlace place;
    place.folder.put("old.txt", "o");
    MadeFiles made("");
    CHECK(place.write(made, "new.txt", 'a'));
    CHECK(place.write(made, "new.txt", 'b'));
    CHECK(place.write(made, "new.txt", 'c', true));
    CHECK(place.folder.get("new.txt") == "bc");
    CHECK_FALSE(place.write(made, "old.txt", 'a'));
    CHECK_FALSE(place.write(made, "old.txt", 'a', true));
    CHECK(place.folder.get("old.txt") == "o");
    CHECK(place.write(made, "old.txt", 'a', true, true));
    CHECK(place.folder.get("old.txt") == "oa");
}

TEST_CASE("files of a scene are known in its next run, and by no other scene", "[file_access]") {
    const MadePlace place;
    place.folder.put("one.pov", "");
    place.folder.put("two.pov", "");
    MadeFiles first(place.folder / "one.pov");
    REQUIRE(place.write(first, "a.txt", 'a'));
    MadeFiles again(place.folder / "one"), other(place.folder / "two.pov"), nobody("");
    // Where the file system keeps no attributes, each run knows only its own files.
    if (place.write(again, "a.txt", 'b')) CHECK(place.folder.get("a.txt") == "b");
    CHECK_FALSE(place.write(other, "a.txt", 'c'));
    CHECK_FALSE(place.write(nobody, "a.txt", 'c'));
}

TEST_CASE("the mark of another scene is known", "[file_access]") {
    const MadePlace place;
    place.folder.put("one.pov", "");
    place.folder.put("two.pov", "");
    place.folder.put("plain.inc", "");
    MadeFiles one(place.folder / "one.pov"), two(place.folder / "two.pov"), nobody("");
    REQUIRE(place.write(one, "a.inc", 'a'));
    CHECK_FALSE(one.made_by_another(place.here + "a.inc"));
    CHECK_FALSE(one.made_by_another(place.here + "plain.inc"));
    CHECK_FALSE(one.made_by_another(place.here + "none.inc"));
    MadeFiles again(place.folder / "one.pov");
    if (!place.write(again, "a.inc", 'b')) return;  // the file system keeps no attributes
    CHECK(two.made_by_another(place.here + "a.inc"));
    CHECK(nobody.made_by_another(place.here + "a.inc"));
    REQUIRE(place.write(nobody, "b.inc", 'b'));
    CHECK_FALSE(nobody.made_by_another(place.here + "b.inc"));
    CHECK(one.made_by_another(place.here + "b.inc"));
}

TEST_CASE("links and what has two names are not written to", "[file_access]") {
    const MadePlace place;
    place.folder.put("victim.txt", "v");
    MadeFiles made("");
    REQUIRE(place.write(made, "a.txt", 'a'));
    fs::create_hard_link(place.folder / "a.txt", place.folder / "b.txt");
    CHECK_FALSE(place.write(made, "b.txt", 'b'));
    fs::create_hard_link(place.folder / "victim.txt", place.folder / "hard.txt");
    CHECK_FALSE(place.write(made, "hard.txt", 'b', false, true));
    fs::create_symlink("victim.txt", place.folder / "soft.txt");
    CHECK_FALSE(place.write(made, "soft.txt", 'b', false, true));
    fs::create_symlink("nowhere.txt", place.folder / "loose.txt");
    CHECK_FALSE(place.write(made, "loose.txt", 'b', false, true));
    CHECK_FALSE(fs::exists(place.folder / "nowhere.txt"));
    CHECK(place.folder.get("victim.txt") == "v");
}

TEST_CASE("what ends in .tmp belongs to all scenes", "[file_access]") {
    const MadePlace place;
    place.folder.put("one.pov", "");
    place.folder.put("two.pov", "");
    place.folder.put("mine.tmp", "m");
    MadeFiles one(place.folder / "one.pov"), two(place.folder / "two.pov"), nobody("");
    REQUIRE(place.write(one, "a.tmp", 'a'));
    REQUIRE(place.write(nobody, "b.tmp", 'b'));
    if (place.write(two, "a.tmp", 'c')) {  // the file system keeps attributes
        CHECK(place.write(nobody, "a.tmp", 'c'));
        CHECK(place.write(two, "b.tmp", 'c'));
    }
    CHECK_FALSE(place.write(one, "mine.tmp", 'a'));
    CHECK(place.folder.get("mine.tmp") == "m");
}

}  // namespace candelabra
