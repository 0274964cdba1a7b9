// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/tiff.h"

#include "raster/same.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace candelabra {

namespace {

/// Reads a file of tests/raster/files/: bytes or words with each compression, a palette, alpha, the
/// other byte order, and long words of LZW.
std::string tiff_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::filesystem::path> tiff_files() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry :
         std::filesystem::directory_iterator(CANDELABRA_SOURCE_DIR "/tests/raster/files"))
        if (entry.path().extension() == ".tif") paths.push_back(entry.path());
    return paths;
}

}  // namespace

TEST_CASE("TIFF files of each usual kind are read as by the library", "[raster]") {
    REQUIRE(tiff_files().size() > 12);
    for (const std::filesystem::path& path : tiff_files()) {
        INFO(path);
        check_same(tiff_file(path));
    }
}

TEST_CASE("TIFF files that are damaged are left to the library, or read to their end", "[raster]") {
    for (const std::filesystem::path& path : tiff_files()) {
        INFO(path);
        const std::string bytes = tiff_file(path);
        const auto whole = [](const StoredPicture& picture) {
            return picture.values.size() == static_cast<std::size_t>(picture.width) *
                                                static_cast<std::size_t>(picture.height) *
                                                static_cast<std::size_t>(picture.channels);
        };
        const std::size_t step = 1 + bytes.size() / 1500;
        for (std::size_t at = 4; at < bytes.size(); at += step) {
            StoredPicture picture;
            if (read_raster(bytes.substr(0, at), raster_limit, picture)) CHECK(whole(picture));
            std::string other = bytes;
            other[at] = static_cast<char>(other[at] ^ 0x55);
            if (read_raster(other, raster_limit, picture)) CHECK(whole(picture));
        }
    }
}

TEST_CASE("TIFF files of more pixels than may be are left to the library", "[raster]") {
    const std::string bytes = tiff_file(CANDELABRA_SOURCE_DIR "/tests/raster/files/bytes_none.tif");
    CHECK(read_tiff(bytes, 23 * 17));
    CHECK(!read_tiff(bytes, 23 * 17 - 1));
}

}  // namespace candelabra
