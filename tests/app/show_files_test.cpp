// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/show_files.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The number of frames and the red factors of the lamps in the last one, or what is wrong.
struct ShowReader {
    Folder folder;
    Options options;

    std::string operator()(const ShowFiles& files) {
        static const LampList lamps({{"Row", 2}}, {0, 1}, {1, 1});
        LightShow show(lamps);
        Diagnostics diagnostics;
        if (!read_show(files, show, options, diagnostics)) return diagnostics.all()[0].message;
        std::string text = std::to_string(show.frames());
        for (const Rgb& factor : show.factors(show.frames() - 1))
            text += " " + std::to_string(factor.r).substr(0, 4);
        return text;
    }
};

}  // namespace

TEST_CASE("shows come from tables, from FSEQ files or from bytes", "[app][relight]") {
    ShowReader read;
    read.folder.put("a.csv", "Row\n0.5\n0.25\n");
    read.folder.put("a.bin", std::string("\x00\xff\xff\x33", 4));
    read.folder.put("patch.csv", "lamp,channel,order\nRow[0],2,W\n");
    ShowFiles given;
    CHECK(take_show_option("--csv", "a.csv", given));
    CHECK(given.table == "a.csv");
    CHECK(take_show_option("--curve", "square", given));
    CHECK(given.curve == "square");
    CHECK(take_show_option("--set", "A=1", given));
    CHECK(given.settings == std::vector<std::string>{"A=1"});
    CHECK_FALSE(take_show_option("--smooth", "1", given));
    CHECK(given.paths() == std::vector<std::string>{"a.csv"});
    ShowFiles files;
    files.table = read.folder / "a.csv";
    CHECK(read(files) == "2 0.25 0.25");
    files.raw = read.folder / "a.bin";
    CHECK(read(files) == "a show comes from one file");
    files.table.clear();
    CHECK(read(files) == "`--raw` needs the number of channels in a frame");
    files.channels = "2";
    CHECK(read(files) == "2 1.00 0.20");
    files.curve = "square";
    CHECK(read(files) == "2 1.00 0.04");
    files.patch = read.folder / "patch.csv";
    CHECK(read(files) == "2 0.04 1.00");
    files.patch = read.folder / "none.csv";
    CHECK(read(files).find("none.csv` cannot be read") != std::string::npos);
    files.patch.clear();
    files.channels = "3";
    CHECK(read(files).find("has 4 bytes, which are no frames of 3 channels") != std::string::npos);
    files.channels = "1";
    CHECK(read(files) ==
          "a frame has 1 channel, which is neither one nor three for each of 2 lamps");
    files.curve = "cubic";
    CHECK(read(files) == "`--curve cubic` is no curve");
    files = {};
    files.curve = "square";
    CHECK(read(files) == "a patch and a curve belong to channels");
    files = {};
    files.channels = "2";
    CHECK(read(files) == "`--channels` belongs to bare bytes");
    files = {};
    files.fseq = read.folder / "a.bin";
    CHECK(read(files).find("is no FSEQ file") != std::string::npos);
}

TEST_CASE("an FSEQ file sets the rate of a movie", "[app][relight]") {
    ShowReader read;
    std::string bytes("PSEQ\x20\0\0\2\x20\0\2\0\0\0\1\0\0\0\x32", 19);
    bytes += std::string(13, '\0') + "\xff\x33";
    read.folder.put("a.fseq", bytes);
    ShowFiles files;
    files.fseq = read.folder / "a.fseq";
    CHECK(read(files) == "1 1.00 0.20");
    CHECK(read.options.frame_rate == 20);
    read.options.frame_rate = 30;
    read.options.given.push_back({nullptr, "--frame-rate=30"});
    CHECK(read(files) == "1 1.00 0.20");
    CHECK(read.options.frame_rate == 30);
}

}  // namespace candelabra
