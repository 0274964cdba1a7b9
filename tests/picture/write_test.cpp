// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/write.h"

#include "base/colour.h"
#include "picture/formats.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace candelabra {

namespace {

Image ramp(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = Rgb(x * 0.01, y * 0.02, -0.5 + x * y);
    return image;
}

constexpr PictureFormat formats[] = {
    {PictureType::png, 8},       {PictureType::png, 16},  {PictureType::exr, 8},
    {PictureType::hdr, 8},       {PictureType::ppm, 8},   {PictureType::tga, 8},
    {PictureType::tga, 8, true}, {PictureType::jpeg, 8},  {PictureType::bmp, 8},
    {PictureType::tiff, 8},      {PictureType::tiff, 16}, {PictureType::webp, 8},
};

}  // namespace

TEST_CASE("values are clipped, encoded as sRGB and rounded") {
    struct Case {
        double linear;
        unsigned most;
        unsigned expected;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    const Case cases[] = {
        {0, 255, 0},
        {1, 255, 255},
        {0.5, 255, 188},
        {0.2141, 255, 128},
        {-3, 255, 0},
        {7, 255, 255},
        {nan, 255, 0},
        {infinite, 255, 255},
        {-infinite, 255, 0},
        {0.001, 255, 3},
        {0.5, 65535, 48192},
        {1, 65535, 65535},
        // 12.92 v = 0.5/255 is the border between 0 and 1
        {0.5 / 255 / 12.92 * 0.999, 255, 0},
        {0.5 / 255 / 12.92 * 1.001, 255, 1},
    };
    for (const Case& each : cases) {
        CAPTURE(each.linear, each.most);
        CHECK(quantised(each.linear, each.most) == each.expected);
    }
}

TEST_CASE("values of another gamma are made linear first, and old scenes' are left as they are") {
    PictureFormat squared;
    squared.gamma = 2;
    PictureFormat srgb;
    srgb.gamma = -1;
    PictureFormat plain;
    plain.gamma = 2;
    plain.encoded = false;
    for (const double value : {0.0, 0.1, 0.5, 0.9, 1.0, 3.0}) {
        CAPTURE(value);
        CHECK(quantised(value, 255, squared) == quantised(value * value, 255));
        CHECK(quantised(value, 255, plain) == std::floor(std::min(value, 1.0) * 255 + 0.5));
        CHECK(quantised(value, 255, srgb) == quantised(value, 255, plain));
    }
}

TEST_CASE("a file may have another gamma than sRGB") {
    PictureFormat linear, rooted, plain;
    linear.file_gamma = 1;
    rooted.file_gamma = plain.file_gamma = 2;
    plain.encoded = false;
    for (const double value : {0.0, 0.1, 0.5, 0.9, 1.0, 3.0}) {
        CAPTURE(value);
        const double clipped = std::min(value, 1.0);
        CHECK(quantised(value, 65535, linear) == std::floor(clipped * 65535 + 0.5));
        CHECK(quantised(value, 255, rooted) == std::floor(std::sqrt(clipped) * 255 + 0.5));
        CHECK(quantised(value, 255, plain) == std::floor(clipped * 255 + 0.5));
    }
}

TEST_CASE("no file has infinity or what is no number", "[picture]") {
    constexpr double most = std::numeric_limits<float>::max(), endless = INFINITY;
    CHECK(finite_float(endless) == most);
    CHECK(finite_float(-endless) == -most);
    CHECK(finite_float(1e300) == most);
    CHECK(finite_float(NAN) == 0);
    CHECK(finite_float(0.25) == 0.25f);
    Image image(4, 1);
    image.pixels = {Rgb(endless, -endless, NAN), Rgb(1e300), Rgb(5), Rgb(1e39, 0.5, 0)};
    for (const PictureTypeInfo& row : picture_types()) {
        const PictureType type = row.type;
        PictureFormat format;
        format.type = type;
        format.gamma = 10;
        CAPTURE(std::string(extension(type)));
        Diagnostics diagnostics;
        const auto bytes = encode(image, format, diagnostics);
        REQUIRE(bytes);
        const auto read =
            read_stored({"a." + std::string(extension(type)), *bytes}, diagnostics, {});
        REQUIRE(read);
        for (const float value : read->values) CHECK(std::isfinite(value));
    }
}

TEST_CASE("a picture that is made row by row has the bytes of one in memory") {
    const int width = 5, height = 4;
    Image image(width, height);
    std::vector<double> alpha;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        alpha.push_back(i % 3 == 0 ? 1 : 0.5);
        image.pixels[i] = alpha[i] * Rgb(0.01 * static_cast<double>(i), 0.3, 0.9);
    }
    int rows = 0;
    const auto row = [&](int y, std::span<Rgb> pixels, std::span<double> opaque) {
        CHECK(y == rows++);
        for (int x = 0; x < width; ++x) {
            const auto place = static_cast<std::size_t>(x);
            pixels[place] = image.at(x, y);
            if (!opaque.empty()) opaque[place] = alpha[static_cast<std::size_t>(y * width + x)];
        }
    };
    for (const PictureTypeInfo& each : picture_types())
        for (const bool clear : {false, true}) {
            if (clear && !each.alpha) continue;
            CAPTURE(std::string(each.extension), clear);
            PictureFormat format;
            format.type = each.type;
            Diagnostics diagnostics;
            rows = 0;
            const auto made = encode(PictureRows{width, height, clear, row}, format, diagnostics);
            REQUIRE(made);
            CHECK(rows == height);
            CHECK(made ==
                  encode(image, format, diagnostics,
                         clear ? std::span<const double>(alpha) : std::span<const double>()));
        }
}

TEST_CASE("the bytes of a picture are those of a file") {
    const Image image = ramp(7, 5);
    const auto row = [&](int y, std::span<Rgb> pixels, std::span<double>) {
        for (int x = 0; x < 7; ++x) pixels[static_cast<std::size_t>(x)] = image.at(x, y);
    };
    const PictureFormat format{PictureType::ppm, 8};
    const std::vector<std::uint8_t> bytes = bytes_of(PictureRows{7, 5, false, row}, format);
    REQUIRE(bytes.size() == 7 * 5 * 3);
    Diagnostics diagnostics;
    const auto file = encode(image, format, diagnostics);
    REQUIRE(file);
    CHECK(file->ends_with(std::string(bytes.begin(), bytes.end())));
}

TEST_CASE("the type of a picture is known by the end of its name") {
    struct Case {
        const char* name;
        std::optional<PictureType> expected;
    };
    const Case cases[] = {
        {"a.png", PictureType::png},   {"dir.x/A.PNG", PictureType::png},
        {"a.exr", PictureType::exr},   {"a.hdr", PictureType::hdr},
        {"a.ppm", PictureType::ppm},   {"a.tga", PictureType::tga},
        {"a.jpg", PictureType::jpeg},  {"a.jpeg", PictureType::jpeg},
        {"a.bmp", PictureType::bmp},   {"a.tif", PictureType::tiff},
        {"a.TIFF", PictureType::tiff}, {"a.webp", PictureType::webp},
        {"a.gif", std::nullopt},       {"png", std::nullopt},
        {"dir.png/a", std::nullopt},   {"", std::nullopt},
        {"-", std::nullopt},           {"a.b.exr", PictureType::exr},
    };
    for (const Case& each : cases) {
        CAPTURE(each.name);
        CHECK(type_of_name(each.name) == each.expected);
    }
    for (const PictureFormat& format : formats)
        CHECK(type_of_name("a." + std::string(extension(format.type))) == format.type);
}

TEST_CASE("the same picture gives the same bytes in every format") {
    const Image image = ramp(19, 11);
    for (const PictureFormat& format : formats) {
        CAPTURE(extension(format.type), format.bits);
        Diagnostics diagnostics;
        const auto once = encode(image, format, diagnostics);
        REQUIRE(once);
        CHECK(once->size() > 50);
        CHECK(encode(image, format, diagnostics) == once);
        CHECK(diagnostics.all().empty());
    }
}

TEST_CASE("a compressed tga file is smaller") {
    Diagnostics diagnostics;
    const Image black(64, 64);
    const auto plain = encode(black, {PictureType::tga, 8, false}, diagnostics);
    const auto packed = encode(black, {PictureType::tga, 8, true}, diagnostics);
    REQUIRE((plain && packed));
    CHECK(plain->size() >= 64 * 64 * 3);
    CHECK(packed->size() < 1000);
}

TEST_CASE("a picture that cannot be encoded is an error, not a crash") {
    Diagnostics diagnostics;
    CHECK_FALSE(encode(Image(), {PictureType::png, 8}, diagnostics));
    REQUIRE(diagnostics.error_count() == 1);
    CHECK(diagnostics.all()[0].fault == Fault::io);
    CHECK(diagnostics.all()[0].message.starts_with("cannot make a png file of 0 by 0 pixels"));
}

TEST_CASE("a grey picture has one channel of the brightness") {
    Image image(1, 1);
    image.at(0, 0) = Rgb(1, 0.5, 0);
    Diagnostics diagnostics;
    PictureFormat format{PictureType::ppm};
    format.grey = true;
    const auto bytes = encode(image, format, diagnostics);
    REQUIRE(bytes);
    CHECK(bytes->starts_with("P5\n"));
    CHECK(static_cast<unsigned char>(bytes->back()) == quantised(grey(Rgb(1, 0.5, 0)), 255));
}

TEST_CASE("many values are rounded as each of them is") {
    Image image(300, 200);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        // Include the borders between two bytes and the values next to them.
        const double border = srgb_decode((static_cast<double>(i % 255) + 0.5) / 255);
        image.pixels[i] = Rgb(static_cast<double>(i) / 54000 - 0.05, border,
                              std::nextafter(border, i % 2 == 0 ? 0.0 : 1.0));
    }
    for (const double gamma : {-1.0, 1.0, 2.2}) {
        Diagnostics diagnostics;
        PictureFormat format{PictureType::ppm};
        format.file_gamma = gamma;
        const auto bytes = encode(image, format, diagnostics);
        REQUIRE(bytes);
        const std::size_t head = bytes->size() - 3 * image.pixels.size();
        bool same = true;
        for (std::size_t i = 0; i < 3 * image.pixels.size(); ++i) {
            const double value = image.pixels[i / 3][static_cast<int>(i % 3)];
            same = same &&
                   static_cast<unsigned char>((*bytes)[head + i]) == quantised(value, 255, format);
        }
        CHECK(same);
    }
}

TEST_CASE("what is brighter than its alpha has more alpha") {
    Image image(2, 1);
    image.at(0, 0) = Rgb(0.2);
    image.at(1, 0) = Rgb(0.9);
    Diagnostics diagnostics;
    const PictureFormat format{PictureType::tga};
    const auto bytes = encode(image, format, diagnostics, std::array{0.5, 0.5});
    REQUIRE(bytes);
    const std::size_t head = 18;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>((*bytes)[head + i]); };
    CHECK(byte(0) == quantised(0.4, 255));
    CHECK(byte(3) == 128);
    CHECK(byte(4) == 255);
    CHECK(byte(7) == 230);
}

TEST_CASE("alpha beyond its range is clipped, and is nothing where it is no number") {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::array alpha = {infinite, 3.0, -infinite, std::nan(""), -0.5};
    const Image image(static_cast<int>(alpha.size()), 1);
    Diagnostics diagnostics;
    const auto bytes = encode(image, {PictureType::tga}, diagnostics, alpha);
    REQUIRE(bytes);
    const std::size_t head = 18;
    std::vector<int> made;
    for (std::size_t i = 0; i < alpha.size(); ++i)
        made.push_back(static_cast<unsigned char>((*bytes)[head + 4 * i + 3]));
    CHECK(made == std::vector{255, 255, 0, 0, 0});
}

}  // namespace candelabra
