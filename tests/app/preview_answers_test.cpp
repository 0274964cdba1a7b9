// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview_answers.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

WebAnswer get(PreviewDesk& desk, const std::string& path, const PreviewFacts& facts = {}) {
    return answer_of({false, path, ""}, facts, desk);
}

}  // namespace

TEST_CASE("each address is asked by its own method", "[app]") {
    PreviewDesk desk([] {});
    for (const char* path : {"/turn", "/develop", "/dim", "/look", "/orbit", "/point", "/pause"}) {
        CAPTURE(path);
        CHECK(answer_of({false, path, "on=yes"}, {}, desk).status == 405);
        CHECK(answer_of({true, path, "on=yes"}, {}, desk).status != 405);
    }
    for (const char* path :
         {"/", "/status", "/picture", "/save.exr", "/camera", "/manual/", "/none"})
        CHECK(answer_of({true, path, ""}, {}, desk).status == 405);
    CHECK(get(desk, "/none").status == 404);
    CHECK(get(desk, "/picture").status == 404);
    CHECK(get(desk, "/save.png").status == 404);
    CHECK(get(desk, "/page.js").body.find("\"use strict\"") != std::string::npos);
    CHECK(get(desk, "/style.css").type == "text/css; charset=utf-8");
    CHECK(get(desk, "/icon.svg").type == "image/svg+xml");
    CHECK(get(desk, "/favicon.ico").body == get(desk, "/icon.svg").body);
}

TEST_CASE("the status waits for what is new", "[app]") {
    PreviewDesk desk([] {});
    CHECK_FALSE(answer_of({false, "/status", ""}, {}, desk).later);
    CHECK(answer_of({false, "/status", "since=0"}, {}, desk).later);
    desk.pause(true);
    CHECK_FALSE(answer_of({false, "/status", "since=0"}, {}, desk).later);
    CHECK_FALSE(answer_of({false, "/status", "since=x"}, {}, desk).later);
}

TEST_CASE("the page has its token, and a scene's name that is no markup", "[app]") {
    const std::string page = page_with("0123", "/a/b<script>.pov");
    CHECK(page.find("content=\"0123\"") != page.npos);
    CHECK(page.find("b_script_.pov") != page.npos);
    CHECK(page.find("<script>") == page.npos);
    CHECK(page.find("OF-THIS-RUN") == page.npos);
}

TEST_CASE("the manual is served where it is built, and else a page says how to build it", "[app]") {
    PreviewDesk desk([] {});
    CHECK(get(desk, "/manual").status == 404);
    CHECK(get(desk, "/manual/a.html").body.find("--target book") != std::string::npos);
    const Folder folder;
    CHECK(manual_folder(folder.path().string()).empty());
    folder.put("manual/index.html", "<p>entrance");
    folder.put("secret.html", "secret");
    PreviewFacts facts;
    facts.manual = manual_folder(folder.path().string());
    REQUIRE_FALSE(facts.manual.empty());
    CHECK(get(desk, "/manual", facts).body.find("/manual/") != std::string::npos);
    CHECK(get(desk, "/manual/", facts).body == "<p>entrance");
    CHECK(get(desk, "/manual/../secret.html", facts).status == 404);
    CHECK(get(desk, "/manualsecret.html", facts).status == 404);
    CHECK(get(desk, "/manual/none.html", facts).status == 404);
}

}  // namespace candelabra
