// SPDX-License-Identifier: GPL-3.0-or-later
#include "oiio/formats.h"

#include "support/picture_formats.h"

namespace candelabra {

namespace {

using namespace std::string_literals;

/// Returns the library's message for a file with these bytes.
std::string verdict(const std::string& bytes) {
    StoredPicture stored;
    const std::string problem = formats().read(bytes, 1 << 28, stored);
    CHECK((problem.empty() || stored.values.empty()));
    return problem;
}

std::string low(unsigned number, int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
    return bytes;
}

std::string too_small(const std::string& bytes) {
    return "its header is for a larger picture than its " + std::to_string(bytes.size()) +
           " bytes can hold";
}

}  // namespace

TEST_CASE("a picture is not larger than its file can fill", "[formats]") {
    const std::string wide = low(16000, 2);
    const std::string head(100, '\0');
    const std::vector<std::pair<const char*, std::string>> files = {
        {"gif", "GIF89a" + wide + wide + "\x80\0\0"s + head},
        {"bmp", "BM" + low(154, 4) + low(0, 4) + low(54, 4) + low(40, 4) + low(16000, 4) +
                    low(16000, 4) + low(1, 2) + low(24, 2) + low(0, 24) + head},
        {"packed bmp", "BM" + low(154, 4) + low(0, 4) + low(54, 4) + low(40, 4) + low(16000, 4) +
                           low(16000, 4) + low(1, 2) + low(8, 2) + low(1, 4) + low(0, 20) + head},
        {"targa", "\0\0\x2\0\0\0\0\0\0\0\0\0"s + wide + wide + "\x18\0"s + head},
        {"packed targa", "\0\0\xa\0\0\0\0\0\0\0\0\0"s + wide + wide + "\x20\0"s + head},
        {"jpeg", "\xff\xd8\xff\xc0\0\x11\x8\x3e\x80\x3e\x80\3\1\x11\0\2\x11\0\3\x11\0"s + head},
        {"webp",
         "RIFF" + low(112, 4) + "WEBPVP8L" + low(100, 4) + "\x2f" + low(0x0fffffff, 4) + head},
        {"webp of several parts", "RIFF" + low(112, 4) + "WEBPVP8X" + low(10, 4) + low(0, 4) +
                                      low(16000, 3) + low(16000, 3) + head},
        {"simple webp", "RIFF" + low(112, 4) + "WEBPVP8 " + low(100, 4) + low(0, 3) +
                            "\x9d\x01\x2a" + low(16000, 2) + low(16000, 2) + head},
        {"pnm", "P6\n16000 16000\n255\n" + head},
        {"hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16000 +X 16000\n" + head},
        {"tiff",
         "II*\0\x8\0\0\0\x8\0"s                    //
         "\0\1\3\0\1\0\0\0\x80\x3e\0\0"            // width
         "\1\1\3\0\1\0\0\0\x80\x3e\0\0"            // height
         "\2\1\3\0\1\0\0\0\x8\0\0\0"               // bits
         "\3\1\3\0\1\0\0\0\5\0\0\0"                // compression: LZW
         "\6\1\3\0\1\0\0\0\1\0\0\0"                // grey
         "\x11\1\4\0\1\0\0\0\x80\0\0\0"            // offsets
         "\x16\1\3\0\1\0\0\0\x80\x3e\0\0"          // rows
         "\x17\1\4\0\1\0\0\0\x8\0\0\0\0\0\0\0"s +  // bytes
             head},
        {"openexr",
         "\x76\x2f\x31\1\2\0\0\0"
         "channels\0chlist\0\x13\0\0\0G\0\1\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0\0"
         "compression\0compression\0\1\0\0\0\3"
         "dataWindow\0box2i\0\x10\0\0\0\0\0\0\0\0\0\0\0\x7f\x3e\0\0\x7f\x3e\0\0"
         "displayWindow\0box2i\0\x10\0\0\0\0\0\0\0\0\0\0\0\x7f\x3e\0\0\x7f\x3e\0\0"
         "lineOrder\0lineOrder\0\1\0\0\0\0"
         "pixelAspectRatio\0float\0\4\0\0\0\0\0\x80\x3f"
         "screenWindowCenter\0v2f\0\x8\0\0\0\0\0\0\0\0\0\0\0"
         "screenWindowWidth\0float\0\4\0\0\0\0\0\x80\x3f\0"s +
             head}};
    for (const auto& [name, bytes] : files) {
        CAPTURE(name);
        CHECK(verdict(bytes) == too_small(bytes));
    }
}

TEST_CASE("only formats that the language names are opened", "[formats]") {
    const std::string none = "it is of no format that the language names";
    CHECK(verdict("SDPX" + std::string(2048, '\0')) == none);                           // dpx
    CHECK(verdict("8BPS\0\1"s + std::string(100, '\0')) == none);                       // psd
    CHECK(verdict("SIMPLE  =                    T" + std::string(2880, ' ')) == none);  // fits
    CHECK(verdict("qoif" + std::string(30, '\0')) == none);
    // Not the language's IFF; its reader would end the program at such a header.
    CHECK(verdict("FOR4\0\0\0\x88"
                  "CIMGTBHD\0\0\0\x20\0\0\0\4\0\0\0\3\0\1\0\1"s) == none);
    CHECK(verdict("no picture") == none);
    CHECK(verdict("") == none);
    // A Targa file of palette indices has a reader of its own.
    CHECK(verdict("\0\1\1\0\0\1\0\x18\0\0\0\0\1\0\1\0\x8\0abc\0"s) == none);
}

TEST_CASE("an early end is a failure, whether its reader says so or not", "[formats]") {
    CHECK(verdict("P6\n4 4\n255\nabcdef") != "");
    CHECK(verdict("P5\n4 4\n255\nabc") != "");
    CHECK(verdict("P3\n4 4\n255\n1 2 3") != "");
    CHECK(verdict("P6") != "");
    CHECK(verdict("GIF89a") != "");
    CHECK(verdict("\xff\xd8\xff") == "it has no size");
    CHECK(verdict("\x76\x2f\x31\1") == "it ends in its head");
    CHECK(verdict("P6\n2 1\n255\nabcdef") == "");
}

}  // namespace candelabra
