// SPDX-License-Identifier: GPL-3.0-or-later
#include "png/png.h"

#include "support/folder.h"
#include "support/picture_formats.h"

namespace {

/// Five by three pixels, each value another.
template <class Value>
RawPicture picture_of(int channels) {
    std::vector<Value> values;
    for (int i = 0; i < 15 * channels; ++i)
        values.push_back(static_cast<Value>((i * 40503u) >> (sizeof(Value) == 1 ? 4 : 0)));
    return {5, 3, channels, values, "png", {}, "made by a test"};
}

void check_same(const StoredPicture& ours, const StoredPicture& theirs) {
    CHECK(ours.width == theirs.width);
    CHECK(ours.height == theirs.height);
    CHECK(ours.channels == theirs.channels);
    CHECK(ours.bits == theirs.bits);
    CHECK(ours.linear == theirs.linear);
    CHECK(ours.gamma == Approx(theirs.gamma));
    CHECK(ours.format == theirs.format);
    CHECK_THAT(ours.values, Catch::Matchers::Approx(theirs.values).margin(1e-7));
    CHECK(ours.alpha == theirs.alpha);
}

}  // namespace

TEST_CASE("PNG files are written and read as by the library of all formats", "[png]") {
    for (const int channels : {1, 2, 3, 4})
        for (const RawPicture& picture :
             {picture_of<std::uint8_t>(channels), picture_of<std::uint16_t>(channels)}) {
            CAPTURE(channels);
            std::string ours, theirs;
            REQUIRE(write_png(picture, ours) == "");
            REQUIRE(formats().write(picture, theirs) == "");
            CHECK(is_png(ours));
            CHECK(ours.find("made by a test") != ours.npos);
            for (const std::string& bytes : {ours, theirs}) {
                const Folder folder;
                folder.put("a.png", bytes);
                StoredPicture here, there;
                REQUIRE(read_png(bytes, 100, here) == "");
                REQUIRE(formats().read(folder / "a.png", 100, there) == "");
                check_same(here, there);
            }
        }
}

TEST_CASE("PNG files say which gamma they have", "[png]") {
    RawPicture picture = picture_of<std::uint8_t>(3);
    for (const double gamma : {1.0, 1.8, 2.2}) {
        picture.gamma = gamma;
        std::string bytes;
        StoredPicture stored;
        REQUIRE(write_png(picture, bytes) == "");
        REQUIRE(read_png(bytes, 100, stored) == "");
        CHECK(stored.gamma == Approx(gamma));
        CHECK(stored.linear == (gamma == 1));
    }
}

TEST_CASE("damaged PNG files are refused", "[png]") {
    std::string bytes;
    REQUIRE(write_png(picture_of<std::uint8_t>(3), bytes) == "");
    StoredPicture stored;
    CHECK(read_png(bytes, 14, stored) == "it says that it has 5 by 3 pixels");
    for (std::size_t length = 0; length + 12 < bytes.size(); ++length) {
        CAPTURE(length);
        CHECK(read_png(std::string_view(bytes).substr(0, length), 100, stored) != "");
    }
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string wrong = bytes;
        wrong[i] = static_cast<char>(~wrong[i]);
        read_png(wrong, 100, stored);  // some harm is none
    }
    CHECK_FALSE(is_png("GIF89a"));
}

TEST_CASE("numbers with a point are no PNG file", "[png]") {
    std::string bytes;
    CHECK(write_png({1, 1, 3, std::vector<float>{0, 0, 0}, "png", {}}, bytes) != "");
}
