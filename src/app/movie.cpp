// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/movie.h"

#include "app/child.h"
#include "picture/file.h"
#include "text/harmless.h"
#include "text/message.h"

#include <filesystem>

namespace {

namespace fs = std::filesystem;

}  // namespace

std::string find_ffmpeg(Diagnostics& diagnostics) {
    std::string program = find_program("ffmpeg");
    if (program.empty())
        diagnostics.add(
            error(Fault::io, {}, "a film needs the program ffmpeg, which is not installed"));
    return program;
}

std::string movie_list(const std::vector<std::string>& frames, double frame_rate) {
    std::string text = "ffconcat version 1.0\n";
    for (const std::string& frame : frames) {
        text += message("file ", shell_quoted(fs::absolute(frame).string()), "\nduration ",
                        1 / frame_rate, "\n");
    }
    return text;
}

std::vector<std::string> movie_arguments(const std::string& list, const std::string& film) {
    std::vector<std::string> words = {"ffmpeg", "-y",    "-loglevel", "error", "-f",
                                      "concat", "-safe", "0",         "-i",    list};
    // Most players want even sizes and this form of colour.
    if (!film.ends_with(".gif"))
        words.insert(words.end(), {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"});
    words.push_back(fs::path(film).is_absolute() ? film : "./" + film);
    return words;
}

bool make_movie(const std::vector<std::string>& frames, double frame_rate, const std::string& film,
                Diagnostics& diagnostics) {
    const auto fail = [&](std::string text) {
        diagnostics.add(error(Fault::io, {}, std::move(text)));
        return false;
    };
    const std::string program = find_ffmpeg(diagnostics);
    if (program.empty()) return false;
    const std::string list = film + ".frames";
    if (!write_file(list, movie_list(frames, frame_rate), diagnostics)) return false;
    std::vector<std::string> words = movie_arguments(list, film);
    words[0] = program;
    const int status = run_program(words);
    std::error_code none;
    fs::remove(list, none);
    return status == 0 || fail(message("ffmpeg could not make `", harmless(film), "`"));
}
