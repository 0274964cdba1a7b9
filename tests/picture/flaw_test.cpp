// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/flaw.h"

#include "picture/layers.h"
#include "picture/write.h"
#include "support/folder.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a whole picture has no flaw, and one that ends early has, in every format",
          "[picture]") {
    const Folder folder;
    Image image(20, 15);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] =
            Rgb(0.01 * static_cast<double>(i % 97), 0.3, 0.002 * static_cast<double>(i));
    for (const PictureTypeInfo& row : picture_types())
        for (const bool compressed : {false, true}) {
            const PictureType type = row.type;
            if (compressed && type != PictureType::tga) continue;
            PictureFormat format;
            format.type = type;
            format.compressed = compressed;
            const std::string name = "a." + std::string(extension(type)), path = folder / name;
            CAPTURE(name, compressed);
            Diagnostics diagnostics;
            REQUIRE(write_picture(image, path, format, diagnostics));
            const std::string whole = folder.get(name);
            CHECK(flaw_of_picture(path, 20, 15).empty());
            CHECK(flaw_of_picture(path, 20, 16) == "it has 20x15 pixels and not 20x16");
            for (const std::size_t part :
                 {std::size_t{1}, std::size_t{17}, whole.size() / 2, whole.size() * 9 / 10}) {
                CAPTURE(part, whole.size());
                folder.put(name, whole.substr(0, part));
                CHECK_FALSE(flaw_of_picture(path, 20, 15).empty());
            }
            folder.put(name, "");
            CHECK(flaw_of_picture(path, 20, 15) == "it is empty");
            folder.put(name, "ffconcat version 1.0\nfile /etc/passwd\n");
            CHECK_FALSE(flaw_of_picture(path, 20, 15).empty());
        }
    CHECK(flaw_of_picture(folder / "none.png", 20, 15) == "it cannot be read");
}

TEST_CASE("a PNG file without its last bytes is not whole, nor is one with more", "[picture]") {
    const Folder folder;
    Diagnostics diagnostics;
    REQUIRE(write_picture(Image(8, 8), folder / "a.png", {}, diagnostics));
    const std::string whole = folder.get("a.png");
    for (std::size_t less = 1; less <= 12; ++less) {
        folder.put("a.png", whole.substr(0, whole.size() - less));
        CHECK_FALSE(flaw_of_picture(folder / "a.png", 8, 8).empty());
    }
    folder.put("a.png", whole + whole);
    CHECK_FALSE(flaw_of_picture(folder / "a.png", 8, 8).empty());
}

TEST_CASE("files of layers are whole or not as pictures are", "[picture]") {
    const Folder folder;
    LayeredPicture picture{4, 3, {}, {}};
    picture.planes = {{"R", false, std::vector<std::uint32_t>(12)},
                      {"depth", false, std::vector<std::uint32_t>(12)}};
    Diagnostics diagnostics;
    const auto bytes = encode(picture, diagnostics);
    REQUIRE(bytes);
    folder.put("a.layers.exr", *bytes);
    CHECK(flaw_of_picture(folder / "a.layers.exr", 4, 3).empty());
    folder.put("a.layers.exr", bytes->substr(0, bytes->size() - 9));
    CHECK_FALSE(flaw_of_picture(folder / "a.layers.exr", 4, 3).empty());
}

}  // namespace candelabra
