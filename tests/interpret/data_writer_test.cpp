// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/data_writer.h"

#include "support/folder.h"
#include "text/made_files.h"

#include <catch2/catch.hpp>

#include <limits>

namespace candelabra {

namespace {

/// A name in a folder, with no link before it.
std::string real(const Folder& folder, const std::string& name) {
    return (std::filesystem::canonical(folder.path()) / name).string();
}

}  // namespace

TEST_CASE("values are written as text with six digits", "[files]") {
    const Folder folder;
    struct Case {
        Value value;
        const char* text;
    };
    const Case cases[] = {
        {1.0, "1"},
        {1.0 / 3, "0.333333"},
        {-0.5, "-0.5"},
        {1e10, "1e+10"},
        {1234567.0, "1.23457e+06"},
        {std::numeric_limits<double>::infinity(), "inf"},
        {std::string("a\n\"b\""), "a\n\"b\""},
        {Numbers{{1, 2}, 2}, "<1,2> "},
        {Numbers{{1, 0.5, 0, 0, 0}, 5}, "<1,0.5,0,0,0> "},
    };
    for (const Case& c : cases) {
        DataWriter writer(MadeFiles("").open(real(folder, "o.txt"), false, true));
        writer.write(c.value);
        CHECK(writer.bytes() == std::string(c.text).size());
        CHECK(writer.close());
        CHECK(folder.get("o.txt") == c.text);
    }
}

TEST_CASE("what is written into memory touches no file", "[files]") {
    const auto text = std::make_shared<std::string>("1,");
    DataWriter writer(text);
    writer.write(Numbers{{1, 2}, 2});
    CHECK(*text == "1,<1,2> ");
    CHECK(writer.good());
    CHECK(writer.bytes() == 6);
    CHECK(writer.close());
}

TEST_CASE("binary numbers are rounded and limited", "[files]") {
    const Folder folder;
    struct Case {
        const char* form;
        double value;
        std::string bytes;
    };
    const Case cases[] = {
        {"uint8", 1.5, "\x02"},
        {"uint8", -3, std::string(1, '\0')},
        {"uint8", 300, "\xff"},
        {"sint8", -200, "\x80"},
        {"uint16le", 258, "\x02\x01"},
        {"uint16be", 258, "\x01\x02"},
        {"sint16be", -2, "\xff\xfe"},
        {"sint16le", -2, "\xfe\xff"},
        {"sint32be", 65536, std::string("\0\1\0\0", 4)},
        {"sint32le", 1e12, "\xff\xff\xff\x7f"},
        {"uint8", std::numeric_limits<double>::quiet_NaN(), std::string(1, '\0')},
    };
    for (const Case& c : cases) {
        INFO(c.form << ' ' << c.value);
        DataWriter writer(MadeFiles("").open(real(folder, "o.bin"), false, true));
        writer.write(Numbers::scalar(c.value), *binary_form(c.form));
        CHECK(writer.close());
        CHECK(folder.get("o.bin") == c.bytes);
    }
    CHECK_FALSE(binary_form("uint64le"));
    CHECK_FALSE(binary_form(""));
}

TEST_CASE("a file is begun anew or continued", "[files]") {
    const Folder folder;
    for (const bool append : {false, true, true, false}) {
        DataWriter writer(MadeFiles("").open(real(folder, "o.txt"), append, true));
        writer.write(Value(std::string("x")));
        CHECK(writer.close());
        if (append) CHECK(folder.get("o.txt").size() > 1);
    }
    CHECK(folder.get("o.txt") == "x");
}

TEST_CASE("what is no plain file is not written", "[files]") {
    const Folder folder;
    std::filesystem::create_symlink(folder / "target", folder / "link");
    MadeFiles made("");
    for (const std::string& path : {real(folder, "link"), real(folder, "none/o.txt"),
                                    real(folder, ""), std::string("/dev/null")})
        CHECK_FALSE(DataWriter(made.open(path, false, true)).good());
    CHECK_FALSE(DataWriter(OpenedFile()).good());
    CHECK_FALSE(std::filesystem::exists(folder / "target"));
}

}  // namespace candelabra
