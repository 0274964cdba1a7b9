// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/movie.h"

#include "app/child.h"
#include "picture/file.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/shell_word.h"

#include <filesystem>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

/// Returns the path of a hidden file beside a film or a picture.
std::string beside(const std::string& film, std::string_view ending) {
    const fs::path path(film);
    return (path.parent_path() / message(".", path.stem().string(), ".part", ending)).string();
}

/// Returns the path of the incomplete film. It has the same extension, by which ffmpeg selects the
/// format.
std::string draft_of(const std::string& film) {
    return beside(film, fs::path(film).extension().string());
}

/// Makes a film from frames and removes the temporary list.
bool run_ffmpeg(const std::vector<std::string>& frames, double frame_rate, const std::string& film,
                Diagnostics& diagnostics) {
    const std::string program = find_program("ffmpeg");
    if (program.empty()) {
        diagnostics.add(
            error(Fault::io, {}, "a film needs the program ffmpeg, which is not installed"));
        return false;
    }
    const std::string list = film + ".frames";
    // Removes a partial film of an earlier run, or a link that would lead elsewhere.
    std::error_code gone;
    for (const std::string& path : {film, list}) fs::remove(path, gone);
    if (!write_file(list, movie_list(frames, frame_rate), diagnostics)) return false;
    std::vector<std::string> words = movie_arguments(list, film);
    words[0] = program;
    const int status = run_program(words);
    std::error_code none;
    fs::remove(list, none);
    if (status != 0) fs::remove(film, none);
    return status == 0;
}

bool fail(std::string text, Diagnostics& diagnostics) {
    if (!diagnostics.failed())
        diagnostics.add(error(Fault::io, {}, std::move(text))
                            .with_help("the ending decides the kind of film: mp4, webm, gif, ..."));
    return false;
}

}  // namespace

std::string hidden_part(const std::string& whole, std::size_t number, std::string_view ending) {
    return beside(whole, message('.', number, ending));
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
    std::vector<std::string> words = {"ffmpeg", "-nostdin", "-y", "-loglevel", "error", "-f",
                                      "concat", "-safe",    "0",  "-i",        list};
    // A gif has 256 colours, chosen from the film. For other formats most players need even sizes
    // and this pixel format.
    if (lower_case(film).ends_with(".gif"))
        words.insert(words.end(),
                     {"-vf", "split[a][b];[a]palettegen[colours];[b][colours]paletteuse"});
    else
        words.insert(words.end(), {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"});
    words.push_back(fs::path(film).is_absolute() ? film : "./" + film);
    return words;
}

bool can_make_movie(double frame_rate, const std::string& film, Diagnostics& diagnostics) {
    constexpr int side = 64;
    const std::string draft = draft_of(film), frame = draft + ".ppm";
    const std::string black = message("P6 ", side, " ", side, " 255\n");
    std::error_code gone;
    fs::remove(frame, gone);
    if (!write_file(frame, black + std::string(3 * side * side, '\0'), diagnostics)) return false;
    const bool made = run_ffmpeg({frame}, frame_rate, draft, diagnostics);
    std::error_code none;
    fs::remove(frame, none);
    fs::remove(draft, none);
    return made || fail(message("ffmpeg makes no film `", printable(film), "`"), diagnostics);
}

bool make_movie(const std::vector<std::string>& frames, double frame_rate, const std::string& film,
                Diagnostics& diagnostics) {
    const std::string draft = draft_of(film);
    std::error_code problem;
    if (run_ffmpeg(frames, frame_rate, draft, diagnostics)) {
        fs::rename(draft, film, problem);
        if (!problem) return true;
    }
    return fail(message("ffmpeg could not make `", printable(film), "`"), diagnostics);
}

}  // namespace candelabra
