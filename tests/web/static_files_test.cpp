// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/static_files.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("files below a folder are served by what they are") {
    const Folder folder;
    folder.put("index.html", "<p>entrance");
    folder.put("book.css", "p { }");
    folder.put("shapes/index.html", "<p>shapes");
    folder.put("shapes/box-1.png", "PNG");
    const auto body = [&](std::string_view path) {
        return static_file(folder.path().string(), path).body;
    };
    CHECK(body("") == "<p>entrance");
    CHECK(body("index.html") == "<p>entrance");
    CHECK(body("shapes/") == "<p>shapes");
    CHECK(body("shapes/box-1.png") == "PNG");
    CHECK(static_file(folder.path().string(), "").type == "text/html; charset=utf-8");
    CHECK(static_file(folder.path().string(), "book.css").type == "text/css; charset=utf-8");
    CHECK(static_file(folder.path().string(), "shapes/box-1.png").type == "image/png");
    CHECK(static_file(folder.path().string(), "none.html").status == 404);
    CHECK(static_file((folder / "none"), "").status == 404);
}

TEST_CASE("no path leads out of the folder of static files") {
    const Folder outside;
    outside.put("secret.html", "secret");
    outside.put(".hidden.html", "secret");
    outside.put("secret", "secret");
    outside.put("scene.pov", "secret");
    namespace fs = std::filesystem;
    const std::string folder = outside / "manual";
    fs::create_directories(folder + "/.git");
    fs::create_directories(folder + "/directory.html");
    for (const char* name : {"/.git/config.html", "/.hidden.html", "/secret", "/scene.pov"})
        fs::copy_file(outside / "secret.html", folder + name);
    fs::create_symlink(outside / "secret.html", folder + "/link.html");
    fs::create_directory_symlink(outside.path(), folder + "/links");
    for (const std::string path : {"../secret.html",
                                   "..",
                                   "../",
                                   "/etc/passwd",
                                   "//secret.html",
                                   "./index.html",
                                   "a/../../secret.html",
                                   "%2e%2e/secret.html",
                                   "..%2fsecret.html",
                                   "..\\secret.html",
                                   ".git/config.html",
                                   ".hidden.html",
                                   "secret",
                                   "scene.pov",
                                   "link.html",
                                   "links/secret.html",
                                   "directory.html",
                                   "directory.html/",
                                   "index.html?x",
                                   "index.html#x",
                                   "~root/a.html",
                                   " index.html"}) {
        CAPTURE(path);
        const WebAnswer answer = static_file(folder, path);
        CHECK(answer.status == 404);
        CHECK(answer.body.find("secret") == std::string::npos);
    }
    CHECK(static_file(folder, std::string("a\0.html", 7)).status == 404);
    CHECK(static_file(folder, std::string("secret.html\0.png", 16)).status == 404);
    CHECK(static_file(folder, std::string(5000, 'a') + ".html").status == 404);
}

}  // namespace candelabra
