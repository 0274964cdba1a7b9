// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/answers.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

WebAnswer get(PreviewState& state, const std::string& path, const PreviewFacts& facts = {}) {
    return answer_of({false, path, ""}, facts, state);
}

}  // namespace

TEST_CASE("each address is asked by its own method", "[preview]") {
    PreviewState state([] {});
    for (const char* path : {"/turn", "/develop", "/dim", "/look", "/orbit", "/point", "/pause"}) {
        CAPTURE(path);
        CHECK(answer_of({false, path, "on=yes"}, {}, state).status == 405);
        CHECK(answer_of({true, path, "on=yes"}, {}, state).status != 405);
    }
    for (const char* path :
         {"/", "/status", "/picture", "/save.exr", "/camera", "/manual/", "/none"})
        CHECK(answer_of({true, path, ""}, {}, state).status == 405);
    CHECK(get(state, "/none").status == 404);
    CHECK(get(state, "/picture").status == 404);
    CHECK(get(state, "/save.png").status == 404);
    CHECK(get(state, "/page.js").body.find("\"use strict\"") != std::string::npos);
    CHECK(get(state, "/style.css").type == "text/css; charset=utf-8");
    CHECK(get(state, "/icon.svg").type == "image/svg+xml");
    CHECK(get(state, "/favicon.ico").body == get(state, "/icon.svg").body);
}

TEST_CASE("the status waits for what is new", "[preview]") {
    PreviewState state([] {});
    CHECK_FALSE(answer_of({false, "/status", ""}, {}, state).later);
    CHECK(answer_of({false, "/status", "since=0"}, {}, state).later);
    state.pause(true);
    CHECK_FALSE(answer_of({false, "/status", "since=0"}, {}, state).later);
    CHECK_FALSE(answer_of({false, "/status", "since=x"}, {}, state).later);
}

TEST_CASE("the page has its token, and a scene's name that is no markup", "[preview]") {
    const std::string page = page_with("0123", "/a/b<script>.pov");
    CHECK(page.find("content=\"0123\"") != page.npos);
    CHECK(page.find("b_script_.pov") != page.npos);
    CHECK(page.find("<script>") == page.npos);
    CHECK(page.find("OF-THIS-RUN") == page.npos);
}

TEST_CASE("the manual is served where it is built, and else a page says how to build it", "[preview]") {
    PreviewState state([] {});
    CHECK(get(state, "/manual").status == 404);
    CHECK(get(state, "/manual/a.html").body.find("--target book") != std::string::npos);
    const Folder folder;
    CHECK(manual_folder(folder.path().string()).empty());
    folder.put("manual/index.html", "<p>entrance");
    folder.put("secret.html", "secret");
    PreviewFacts facts;
    facts.manual = manual_folder(folder.path().string());
    REQUIRE_FALSE(facts.manual.empty());
    CHECK(get(state, "/manual", facts).body.find("/manual/") != std::string::npos);
    CHECK(get(state, "/manual/", facts).body == "<p>entrance");
    CHECK(get(state, "/manual/../secret.html", facts).status == 404);
    CHECK(get(state, "/manualsecret.html", facts).status == 404);
    CHECK(get(state, "/manual/none.html", facts).status == 404);
}

}  // namespace candelabra
