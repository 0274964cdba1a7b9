// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/diagnostic.h"

#include <catch2/catch.hpp>

#include <set>
#include <string>
#include <string_view>

namespace candelabra {

TEST_CASE("each fault is listed once, in order, and has a name of its own") {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < all_faults().size(); ++i) {
        CHECK(static_cast<std::size_t>(all_faults()[i].fault) == i);
        CHECK_FALSE(all_faults()[i].name.empty());
        names.insert(all_faults()[i].name);
    }
    CHECK(names.size() == all_faults().size());
    CHECK(name(Fault::out_of_range) == "out-of-range");
}

TEST_CASE("a diagnostic is made in one expression") {
    const Diagnostic made = error(Fault::out_of_range, {0, 1, 2}, "too big")
                                .with_label("this is 7")
                                .with_help("at most 5")
                                .with_note("one")
                                .with_note("two")
                                .pointing({0, 5, 6}, "set here");
    CHECK(made.severity == Severity::error);
    CHECK(made.fault == Fault::out_of_range);
    CHECK(made.message == "too big");
    CHECK(made.span == Span{0, 1, 2});
    CHECK(made.label == "this is 7");
    CHECK(made.help == "at most 5");
    CHECK(made.notes == std::vector<std::string>{"one", "two"});
    REQUIRE(made.labels.size() == 1);
    CHECK(made.labels[0].span == Span{0, 5, 6});
    CHECK(made.labels[0].text == "set here");
    CHECK(warning(Fault::deprecated, {}, "old").severity == Severity::warning);
    CHECK(note(Fault::io, {}, "written").severity == Severity::note);
}

TEST_CASE("only errors fail") {
    Diagnostics diagnostics;
    CHECK_FALSE(diagnostics.failed());
    diagnostics.add(warning(Fault::deprecated, {}, "old"));
    diagnostics.add(note(Fault::io, {}, "written"));
    CHECK_FALSE(diagnostics.failed());
    diagnostics.add(error(Fault::syntax, {}, "wrong"));
    CHECK(diagnostics.failed());
    CHECK(diagnostics.error_count() == 1);
    CHECK(diagnostics.all().size() == 3);
}

TEST_CASE("the same message at the same place is kept once") {
    Diagnostics diagnostics;
    diagnostics.add(error(Fault::syntax, {0, 1, 2}, "wrong"));
    diagnostics.add(error(Fault::syntax, {0, 1, 2}, "wrong"));
    CHECK(diagnostics.all().size() == 1);
    CHECK(diagnostics.error_count() == 1);
    diagnostics.add(error(Fault::syntax, {0, 1, 3}, "wrong"));
    diagnostics.add(error(Fault::syntax, {1, 1, 2}, "wrong"));
    diagnostics.add(error(Fault::syntax, {0, 1, 2}, "false"));
    CHECK(diagnostics.all().size() == 4);
}

TEST_CASE("errors beyond the twentieth are not kept, warnings are") {
    Diagnostics diagnostics;
    for (std::uint32_t i = 0; i < Diagnostics::max_errors; ++i) {
        CHECK_FALSE(diagnostics.full());
        diagnostics.add(error(Fault::syntax, {0, i, i}, "wrong"));
    }
    CHECK(diagnostics.full());
    diagnostics.add(error(Fault::syntax, {0, 90, 90}, "wrong"));
    CHECK(diagnostics.error_count() == 20);
    diagnostics.add(warning(Fault::user_warning, {}, "mind"));
    CHECK(diagnostics.all().size() == 21);
}

TEST_CASE("frames come from the provider unless the diagnostic has its own") {
    Diagnostics diagnostics;
    int asked = 0;
    diagnostics.set_frames([&] {
        ++asked;
        return std::vector<Frame>{{Frame::macro, "Washer", {0, 1, 2}}};
    });
    diagnostics.add(error(Fault::syntax, {}, "one"));
    diagnostics.add(error(Fault::syntax, {}, "one"));
    CHECK(asked == 1);
    Diagnostic own = error(Fault::syntax, {}, "two");
    own.frames = {{Frame::loop, "#while", {}}, {Frame::macro, "Own", {}}};
    diagnostics.add(own);
    diagnostics.set_frames({});
    diagnostics.add(error(Fault::syntax, {}, "three"));
    REQUIRE(diagnostics.all().size() == 3);
    CHECK(diagnostics.all()[0].frames.at(0).name == "Washer");
    CHECK(diagnostics.all()[1].frames.size() == 2);
    CHECK(diagnostics.all()[2].frames.empty());
}

TEST_CASE("of warnings of one kind the first twenty are kept, and the others counted") {
    Diagnostics diagnostics;
    for (std::uint32_t i = 0; i < 25; ++i) {
        diagnostics.add(warning(Fault::domain, {0, i, i}, "outside"));
        diagnostics.add(warning(Fault::domain, {0, i, i}, "outside"));
        if (i < 3) diagnostics.add(warning(Fault::deprecated, {0, i, i}, "old"));
    }
    diagnostics.add(note(Fault::io, {}, "written"));
    REQUIRE(diagnostics.all().size() == 20 + 1 + 3 + 1);
    CHECK(diagnostics.count() == 25 + 3 + 1);
    const Diagnostic& rest = diagnostics.all()[diagnostics.all().size() - 2];
    CHECK(rest.message == "and 5 more of this kind");
    CHECK(rest.fault == Fault::domain);
    CHECK(rest.severity == Severity::warning);
    CHECK(rest.help == "--warn no-domain switches all of them off");
    CHECK(diagnostics.last().first == Fault::io);
}

TEST_CASE("a diagnostic can be pointed at a better place before it is compared") {
    Diagnostics diagnostics;
    std::uint32_t place = 0;
    diagnostics.set_frames({}, [&](Diagnostic& each) { each.span = {1, place, place}; });
    diagnostics.add(error(Fault::syntax, {0, 1, 2}, "wrong"));
    diagnostics.add(error(Fault::syntax, {0, 3, 4}, "wrong"));
    place = 5;
    diagnostics.add(error(Fault::syntax, {0, 1, 2}, "wrong"));
    REQUIRE(diagnostics.all().size() == 2);
    CHECK(diagnostics.all()[1].span == Span{1, 5, 5});
}

TEST_CASE("what one collector has counted another one counts on") {
    Diagnostics part, whole;
    for (std::uint32_t i = 0; i < 25; ++i) part.add(warning(Fault::domain, {0, i, i}, "outside"));
    part.add(error(Fault::syntax, {}, "wrong"));
    whole.add_all(part);
    REQUIRE(whole.all().size() == 22);
    CHECK(whole.all()[20].message == "and 5 more of this kind");
    CHECK(whole.error_count() == 1);
    whole.add(warning(Fault::domain, {1, 0, 0}, "outside"));
    CHECK(whole.all()[20].message == "and 6 more of this kind");
    Diagnostics muted;
    muted.set_warning(Fault::domain, false);
    muted.add_all(part);
    REQUIRE(muted.all().size() == 1);
    CHECK(muted.all()[0].message == "wrong");
}

}  // namespace candelabra
