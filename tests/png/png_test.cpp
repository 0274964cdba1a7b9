// SPDX-License-Identifier: GPL-3.0-or-later
#include "png/png.h"

#include "support/picture_formats.h"

namespace candelabra {

namespace {

/// Returns five by three pixels with varied values.
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
                StoredPicture here, there;
                REQUIRE(read_png(bytes, 100, here) == "");
                REQUIRE(formats().read(bytes, 100, there) == "");
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

TEST_CASE("the chunks of PNG files stand in the same order with each libpng", "[png]") {
    RawPicture picture = picture_of<std::uint8_t>(3);
    for (const double gamma : {-1.0, 2.0}) {
        picture.gamma = gamma;
        std::string bytes, names;
        REQUIRE(write_png(picture, bytes) == "");
        for (std::size_t at = 8; at + 12 <= bytes.size();) {
            std::size_t length = 0;
            for (std::size_t i = 0; i < 4; ++i)
                length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
            names += bytes.substr(at + 4, 4) + " ";
            at += length + 12;
        }
        CHECK(names == (gamma > 0 ? "IHDR gAMA tEXt tEXt IDAT IEND "
                                  : "IHDR gAMA sRGB cHRM tEXt tEXt IDAT IEND "));
    }
}

TEST_CASE("damaged PNG files are refused", "[png]") {
    std::string bytes;
    REQUIRE(write_png(picture_of<std::uint8_t>(3), bytes) == "");
    StoredPicture stored;
    CHECK(read_png(bytes, 14, stored) == "its header has 5 by 3 pixels");
    for (std::size_t length = 0; length + 12 < bytes.size(); ++length) {
        CAPTURE(length);
        CHECK(read_png(std::string_view(bytes).substr(0, length), 100, stored) != "");
    }
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string wrong = bytes;
        wrong[i] = static_cast<char>(~wrong[i]);
        read_png(wrong, 100, stored);  // some changes do no harm
    }
    CHECK_FALSE(is_png("GIF89a"));
}

TEST_CASE("numbers with a point are no PNG file", "[png]") {
    std::string bytes;
    CHECK(write_png({1, 1, 3, std::vector<float>{0, 0, 0}, "png", {}}, bytes) != "");
}

TEST_CASE("a PNG file that says it is large must have bytes enough", "[png]") {
    const RawPicture small{2, 1, 3, std::vector<std::uint8_t>(6, 9), "png", {}};
    std::string bytes;
    REQUIRE(write_png(small, bytes) == "");
    // 16384 pixels in each direction, with a matching checksum.
    std::string head("IHDR\0\0\x40\0\0\0\x40\0\x8\2\0\0\0", 17);
    std::uint32_t sum = 0xffffffff;
    for (const char c : head) {
        sum ^= static_cast<unsigned char>(c);
        for (int i = 0; i < 8; ++i) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
    }
    for (int i = 3; i >= 0; --i) head += static_cast<char>(~sum >> (8 * i) & 0xff);
    bytes.replace(12, head.size(), head);
    StoredPicture picture;
    CHECK(read_png(bytes, std::int64_t{1} << 28, picture) ==
          "its header is for a larger picture than its " + std::to_string(bytes.size()) +
              " bytes can hold");
    CHECK(picture.width == 0);
    CHECK(picture.values.empty());
}

}  // namespace candelabra
