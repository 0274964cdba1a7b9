// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/relight_command.h"

#include "app/develop_command.h"
#include "app/movie.h"
#include "app/sandbox.h"
#include "app/show_files.h"
#include "app/show_preview.h"
#include "film/develop.h"
#include "options/animation.h"
#include "options/command_line.h"
#include "options/option_store.h"
#include "options/output.h"
#include "options/subcommands.h"
#include "output/layers.h"
#include "output/light_file.h"
#include "picture/file.h"
#include "relight/light_show.h"
#include "relight/meter_table.h"
#include "relight/record_file.h"
#include "relight/relighting.h"
#include "text/message.h"
#include "text/printable.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

struct RelightRequest {
    Options options;
    ShowFiles show;
    std::string smooth = "4";  ///< of --smooth
    bool lists = false;        ///< names the lamps, and nothing else
};

RelightRequest read_relight_request(std::span<const std::string_view> arguments,
                                    Diagnostics& diagnostics) {
    RelightRequest request;
    std::string readings;
    const std::vector<std::string> others = take_options(
        "relight", arguments,
        [&](std::string_view name, std::string value) {
            if (name == "--smooth")
                request.smooth = std::move(value);
            else if (name == "--meters")
                readings = std::move(value);
            else if (name == "--lamps")
                request.lists = true;
            else
                take_show_option(name, std::move(value), request.show);
        },
        diagnostics);
    request.options =
        read_options(std::vector<std::string_view>(others.begin(), others.end()), diagnostics);
    Options& options = request.options;
    options.readings_file = readings;
    // The file stands where a run has its scene.
    const std::size_t files = std::erase_if(options.given, [](const GivenOption& each) {
        return each.line.starts_with("Input_File_Name=");
    });
    std::erase_if(options.given,
                  [](const GivenOption& each) { return each.line.starts_with("--preview"); });
    warn_of_options_of_rendering(options, diagnostics);
    const auto fail = [&](const char* text, const char* help) {
        diagnostics.add(error(Fault::option, {}, text).with_help(help));
    };
    if (diagnostics.failed()) return request;
    if (options.task != Task::render)
        fail("relight makes pictures and nothing else", "man candelabra-relight");
    else if (options.preview_port &&
             !(options.output.empty() && options.movie.empty() && readings.empty()))
        fail("a preview of a show writes no pictures, films and readings", "without --preview");
    else if (files != 1)
        fail("relight needs one file that keeps the light of lamps",
             "candelabra scene.pov --keep-lights scene.lights, then candelabra relight "
             "scene.lights --set Lamp=0.5");
    return request;
}

/// Returns the options of the picture: beside the file, unless they say otherwise.
Options with_place(const RelightRequest& request) {
    Options options = request.options;
    const std::filesystem::path file(*options.scene);
    if (options.output.empty() && options.movie.empty() && file.has_parent_path())
        options.output = file.parent_path().string() + "/";
    return options;
}

class Relighter {
public:
    Relighter(const RelightRequest& request, const LightRecords& records, Diagnostics& diagnostics)
        : options_(with_place(request)),
          records_(records),
          show_(records.lamps),
          diagnostics_(diagnostics) {}

    /// Reads what the lamps do, and where the pictures go. Returns false after an error has been
    /// reported.
    bool prepare(const RelightRequest& request) {
        if (!read_show(request.show, show_, options_, diagnostics_)) return false;
        constexpr double most = 100;
        const auto smooth = number(request.smooth);
        if (!smooth || *smooth < 0 || *smooth > most || *smooth != std::floor(*smooth)) {
            diagnostics_.add(error(Fault::option, {},
                                   message("`--smooth ", printable(request.smooth),
                                           "` is no number of pixels from 0 to ", most))
                                 .with_help("--smooth 4"));
            return false;
        }
        relighting_.emplace(records_, static_cast<int>(*smooth), options_.render.threads);
        const auto film = film_of(records_.film, *options_.scene, options_, diagnostics_);
        if (!film) return false;
        options_.alpha = !records_.alpha.empty();
        hidden_ = !options_.movie.empty() && options_.output.empty();
        if (hidden_) options_.type = PictureType::png;
        const Output output = output_of(options_, diagnostics_);
        files_.film = *film;
        files_.path = output.path;
        files_.format = output.format;
        files_.threads = options_.render.threads;
        if (!options_.movie.empty() && show_.frames() == 0)
            diagnostics_.add(error(Fault::option, {}, "a film needs the frames of a show")
                                 .with_help("--csv frames.csv"));
        return !diagnostics_.failed();
    }

    /// Writes the readings of the meters in all frames. Returns false after an error has been
    /// reported.
    bool measure(const Console& console) {
        if (records_.meters.meters.empty())
            return fail(message("`", printable(*options_.scene),
                                "` keeps no readings: its scene had no meter of lux or cd/m2"),
                        "meter { \"Street\" corner <0, 0, 0> along 30*x across 7*z }");
        std::string table = show_.frames() > 0 ? "frame," : "";
        table += relit_readings_head;
        for (std::size_t i = 0; i < std::max<std::size_t>(show_.frames(), 1); ++i) {
            const std::string begin = show_.frames() > 0 ? message(i + 1, ",") : std::string();
            table += relit_readings(records_, show_.factors(i), begin);
        }
        if (options_.readings_file != "-")
            return write_file(options_.readings_file, table, diagnostics_);
        console.out(table);
        return true;
    }

    /// Makes all pictures, and joins them to a movie if one is wanted.
    bool make() {
        const std::size_t frames = show_.frames();
        const int digits = static_cast<int>(std::to_string(frames).size());
        std::vector<std::string> made;
        bool good = true;
        for (std::size_t i = 0; good && i < std::max<std::size_t>(frames, 1); ++i) {
            FilmFiles files = files_;
            if (hidden_)
                files.path = hidden_part(options_.movie, i, ".png");
            else if (frames > 0 && !is_stream(files.path))
                files.path = numbered(files.path, static_cast<int>(i) + 1, digits);
            good = write(i, files);
            made.push_back(files.path);
        }
        if (options_.movie.empty()) return good;
        good = good && make_movie(made, options_.frame_rate, options_.movie, diagnostics_);
        std::error_code none;
        if (hidden_)
            for (const std::string& frame : made) std::filesystem::remove(frame, none);
        return good;
    }

private:
    bool fail(std::string text, std::string help) {
        diagnostics_.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
        return false;
    }

    bool write(std::size_t frame, FilmFiles& files) {
        Negative negative;
        negative.light = relighting_->picture(show_.factors(frame));
        negative.alpha.assign(records_.alpha.begin(), records_.alpha.end());
        if (!is_developed(files))
            return write_picture(negative.light, files.path, files.format, diagnostics_,
                                 negative.alpha);
        if (files.film.grain > 0) {
            constexpr std::size_t most = (std::size_t{1} << 30) - 1;
            files.film.grain_seed =
                static_cast<int>((static_cast<std::size_t>(files.film.grain_seed) + frame) & most);
        }
        return write_developed(negative, files, diagnostics_);
    }

    Options options_;
    const LightRecords& records_;
    LightShow show_;
    std::optional<Relighting> relighting_;
    Diagnostics& diagnostics_;
    FilmFiles files_;
    bool hidden_ = false;  ///< frames are kept only until they are in the movie
};

/// Lists the lamps of a file, group by group.
std::string list_of_lamps(const LampList& lamps) {
    std::string text;
    for (const LampGroup& group : lamps.groups())
        text +=
            message(printable(group.name),
                    group.lamps == 1 ? std::string() : message("[0..", group.lamps - 1, "]"), "\n");
    return text;
}

/// Does what is asked for. Returns the exit status.
int relight_as_asked(const RelightRequest& request, const Console& console,
                     Diagnostics& diagnostics) {
    if (request.options.preview_port && !request.lists)
        return preview_show(*request.options.scene, request.show, request.options, console,
                            diagnostics);
    const auto records = read_records(*request.options.scene, diagnostics);
    if (!records) return exit_status::file;
    if (request.lists) {
        console.out(list_of_lamps(records->lamps));
        return exit_status::done;
    }
    Relighter relighter(request, *records, diagnostics);
    if (!relighter.prepare(request)) return exit_status::usage;
    check_movie(request.options, diagnostics);
    if (diagnostics.failed()) return exit_status::usage;
    const Options& options = request.options;
    if (!options.readings_file.empty() && !relighter.measure(console)) return exit_status::file;
    // Who asks for a table alone gets no picture.
    const bool pictures =
        options.readings_file.empty() || !options.output.empty() || !options.movie.empty();
    return !pictures || relighter.make() ? exit_status::done : exit_status::file;
}

}  // namespace

int run_relight(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    const RelightRequest request = read_relight_request(arguments, diagnostics);
    const std::vector<std::string> shows = request.show.paths();
    std::vector<std::string> files = {request.options.scene.value_or("")};
    if (request.options.preview_port) files.insert(files.end(), shows.begin(), shows.end());
    SandboxRules rules = sandbox_rules(request.options, console.library, files);
    rules.readable.insert(rules.readable.end(), shows.begin(), shows.end());
    if (!diagnostics.failed()) confined(request.options, rules, console, diagnostics);
    const int status =
        diagnostics.failed() ? exit_status::usage : relight_as_asked(request, console, diagnostics);
    say_errors(console, request.options, diagnostics);
    return status;
}

}  // namespace candelabra
