// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/movie.h"

#include "picture/file.h"
#include "text/harmless.h"
#include "text/message.h"

#include <cstdlib>
#include <filesystem>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

namespace {

namespace fs = std::filesystem;

/// The exit status of a program, or -1.
int run_program(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    // Signals that this program takes in its own way reach the other as usual.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    pid_t child = 0;
    const int failed =
        posix_spawn(&child, arguments[0], nullptr, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    if (failed) return -1;
    int status = 0;
    if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
}

}  // namespace

std::string find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::string folders = path ? path : "";
    while (!folders.empty()) {
        const std::size_t end = std::min(folders.find(':'), folders.size());
        const std::string file = (fs::path(folders.substr(0, end)) / name).string();
        if (end > 0 && ::access(file.c_str(), X_OK) == 0) return file;
        folders.erase(0, end + 1);
    }
    return {};
}

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
        std::string name;
        for (const char c : fs::absolute(frame).string())
            name += c == '\'' ? "'\\''" : std::string(1, c);
        text += message("file '", name, "'\nduration ", 1 / frame_rate, "\n");
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
