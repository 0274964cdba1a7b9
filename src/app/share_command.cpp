// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/share_command.h"

#include "app/commands.h"
#include "app/develop_command.h"
#include "app/sandbox.h"
#include "app/share_show.h"
#include "app/show_files.h"
#include "film/develop.h"
#include "film/glare.h"
#include "options/subcommands.h"
#include "output/layers.h"
#include "output/light_file.h"
#include "picture/file.h"
#include "preview/share_page.h"
#include "text/ascii.h"
#include "text/loader.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

struct ShareRequest {
    Options options;
    std::string page;   ///< as given; empty: named after the scene or the file
    std::string light;  ///< the file that has the light; empty: a scene is rendered
    ShowFiles show;     ///< of a file that keeps the light of lamps
};

bool ends_as(std::string_view path, std::string_view ending) {
    return lower_case(fs::path(path).extension().string()) == ending;
}

/// Whether a file keeps the light of lamps, by its name.
bool keeps_lamps(std::string_view path) { return ends_as(path, ".lights"); }

ShareRequest read_share_request(std::span<const std::string_view> arguments,
                                Diagnostics& diagnostics, const std::string& settings) {
    ShareRequest request;
    std::vector<std::string_view> others;
    std::vector<std::string> files;
    const auto take = [&](std::string_view name, std::string value) {
        if (name == "--output")
            request.page = std::move(value);
        else
            take_show_option(name, std::move(value), request.show);
    };
    const std::vector<std::string> words = take_options("share", arguments, take, diagnostics);
    for (const std::string& word : words)
        if (!word.starts_with('-') && !word.starts_with('+') &&
            (ends_as(word, ".exr") || keeps_lamps(word)))
            files.push_back(word);
        else
            others.push_back(word);
    if (!files.empty()) request.light = files.front();
    request.options = files.empty() ? read_options(others, diagnostics, disk_reader(), settings)
                                    : read_options(others, diagnostics);
    const auto fail = [&](std::string text, std::string help = {}) {
        diagnostics.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
    };
    const Options& options = request.options;
    const bool has_show = !request.show.paths().empty() || !request.show.settings.empty();
    if (files.size() + (options.scene ? 1 : 0) > 1)
        fail("a page has one picture, of a scene or of a file with light");
    else if (files.empty() && !options.scene)
        fail("share needs a scene, an OpenEXR file with layers of light, or kept lights",
             "candelabra share scene.pov -o page.html");
    else if (has_show && !keeps_lamps(request.light))
        fail("a show needs the light that --keep-lights has kept",
             "candelabra share scene.lights --csv frames.csv -o page.html");
    else if (options.task != Task::render || options.preview_port)
        fail("share makes a page and nothing else");
    else if (options.animation.final_frame || options.animation.initial_frame)
        fail("a page has one picture, and there are frames");
    else if (!options.shard.empty())
        fail("a page is made of a whole picture", "merge the shards to an OpenEXR file first");
    return request;
}

/// Returns the path of the page, with its ending.
std::string page_path(const ShareRequest& request) {
    fs::path made(request.page);
    std::error_code none;
    const bool folder = request.page.ends_with('/') || fs::is_directory(made, none);
    if (request.page.empty() || folder) {
        const fs::path source(request.light.empty() ? request.options.scene.value_or("")
                                                    : request.light);
        const std::string stem = source == "-" ? "stdin" : source.stem().string();
        made = folder ? made : request.light.empty() ? fs::path() : source.parent_path();
        return (made / stem).concat(".html").string();
    }
    if (!ends_as(request.page, ".html") && !ends_as(request.page, ".htm")) made += ".html";
    return made.string();
}

/// Returns the path of the picture of which the page is made: a hidden file beside it.
std::string hidden_picture(const std::string& page) {
    const fs::path path(page);
    fs::path hidden = path.parent_path() / ("." + path.stem().string());
    return hidden.concat(".share.exr").string();
}

class PageMaker {
public:
    PageMaker(const LightFile& file, const Options& options, Diagnostics& diagnostics)
        : file_(file), options_(options), diagnostics_(diagnostics) {}

    /// Returns nothing after an error has been reported.
    std::optional<SharedPicture> picture(const std::string& name) {
        const auto film = film_of(file_, options_, diagnostics_);
        if (!film) return std::nullopt;
        made_.film = *film;
        const std::string quiet(denoised_layer);
        const bool denoised = file_.image(quiet) && has_lamps(quiet + ".light.");
        auto whole = file_.image(denoised ? quiet : std::string());
        if (!whole) return fail(message("`", printable(file_.path()), "` has no colours"));
        if (!take_lamps(denoised ? quiet + ".light." : "light.", *whole)) return std::nullopt;
        made_.width = whole->width;
        made_.height = whole->height;
        made_.title = made_.name = name;
        made_.exposure = exposure_of({*whole, {}, {}}, made_.film);
        for (Image& light : lights_) light = on_film(std::move(light));
        const std::size_t room = room_for_light(made_, most_bytes_of_page(*whole));
        made_.light = light_code_within(lights_, room, options_.render.threads);
        return std::move(made_);
    }

private:
    std::nullopt_t fail(std::string text, std::string help = {}) {
        diagnostics_.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
        return std::nullopt;
    }

    bool has_lamps(const std::string& before) const {
        return std::ranges::any_of(file_.layers(),
                                   [&](const auto& name) { return name.starts_with(before); });
    }

    /// Takes the light of each lamp, and behind it what is left of the picture.
    bool take_lamps(const std::string& before, const Image& whole) {
        const auto names = lamps_of(file_, before, whole, diagnostics_);
        if (!names) return false;
        Image rest = whole;
        for (const std::string& name : *names) {
            if (name == "rest") continue;
            made_.lamps.push_back(name);
            lights_.push_back(*file_.image(before + name));
            for (std::size_t i = 0; i < rest.pixels.size(); ++i)
                rest.pixels[i] -= lights_.back().pixels[i];
        }
        if (made_.lamps.size() > most_page_lamps) {
            fail(
                message("a page has up to ", most_page_lamps, " lamps, and there are ",
                        made_.lamps.size()),
                "light_name gives several lamps one name, and Light_Groups one for each value of a "
                "column");
            return false;
        }
        made_.lamps.emplace_back("rest");
        lights_.push_back(std::move(rest));
        return true;
    }

    /// Light as it falls on the film: with glare and vignette, sums of what lamps give.
    Image on_film(Image light) const {
        const FilmSettings& film = made_.film;
        if (film.glares && film.glare.share() > 0)
            light = spread(
                light, GlareKernel(film.glare, light.width, light.height, options_.render.threads),
                options_.render.threads);
        for (int y = 0; film.vignette > 0 && y < light.height; ++y)
            for (int x = 0; x < light.width; ++x)
                light.at(x, y) *= vignetted_at(film.vignette, light.width, light.height, x, y);
        return light;
    }

    const LightFile& file_;
    const Options& options_;
    Diagnostics& diagnostics_;
    SharedPicture made_;
    std::vector<Image> lights_;
};

std::optional<SharedPicture> picture_of(const std::string& light, const ShowFiles& show,
                                        const std::string& page, const Options& options,
                                        Diagnostics& diagnostics) {
    const std::string name = fs::path(page).stem().string();
    if (keeps_lamps(light)) return shared_show(light, show, name, options, diagnostics);
    const auto file = LightFile::read(light, diagnostics);
    if (!file) return std::nullopt;
    return PageMaker(*file, options, diagnostics).picture(name);
}

/// Makes the page. Returns false after an error has been reported.
bool make_page(const std::string& light, const ShowFiles& show, const std::string& page,
               const Options& options, const Console& console, Diagnostics& diagnostics) {
    const auto picture = picture_of(light, show, page, options, diagnostics);
    if (!picture) return false;
    const std::string text = share_page(*picture);
    if (!write_file(page, text, diagnostics)) return false;
    constexpr double megabyte = 1e6;
    if (talks(options))
        console.err(message(printable(page), ": ", picture->lamps.size() - 1,
                            picture->lamps.size() == 2 ? " lamp, " : " lamps, ",
                            std::round(static_cast<double>(text.size()) / megabyte * 10) / 10,
                            " MB\n"));
    return true;
}

int share_file(const ShareRequest& request, const std::string& page, const Console& console,
               Diagnostics& diagnostics) {
    Options options = request.options;
    options.output = page;
    std::vector<std::string> files = request.show.paths();
    files.push_back(request.light);
    const SandboxRules rules = sandbox_rules(options, console.library, files);
    if (!confined(options, rules, console, diagnostics)) return exit_status::usage;
    return make_page(request.light, request.show, page, options, console, diagnostics)
               ? exit_status::done
               : exit_status::file;
}

/// Renders the scene with the light of its lamps, and makes the page of it.
int share_scene(const ShareRequest& request, const std::string& page, const Console& console,
                Diagnostics& diagnostics) {
    Options options = request.options;
    options.page = page;
    options.output = hidden_picture(page);
    options.type = PictureType::exr;
    options.to_file = true;
    // The page needs the light of each lamp, which the layers have.
    options.denoise |= std::exchange(options.draft, false);
    if (std::ranges::find(options.layers, PictureLayer::lights) == options.layers.end())
        options.layers.push_back(PictureLayer::lights);
    const int status = run_with(options, console, diagnostics.fresh());
    if (status != exit_status::done) return status;
    const bool made = make_page(options.output, {}, page, request.options, console, diagnostics);
    if (!made) {
        console.err(message("the light of the scene is kept in `", printable(options.output),
                            "`, from which share makes a page as well\n"));
        return exit_status::file;
    }
    std::error_code none;
    fs::remove(options.output, none);
    return exit_status::done;
}

}  // namespace

int run_share(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    const ShareRequest request = read_share_request(arguments, diagnostics, console.settings);
    int status = exit_status::usage;
    const std::string page = page_path(request);
    if (!diagnostics.failed())
        if (const std::string problem = problem_with_destination(page); !problem.empty())
            diagnostics.add(error(Fault::io, {}, problem));
    if (!request.light.empty()) warn_of_options_of_rendering(request.options, diagnostics);
    if (!diagnostics.failed())
        status = request.light.empty() ? share_scene(request, page, console, diagnostics)
                                       : share_file(request, page, console, diagnostics);
    say_errors(console, request.options, diagnostics);
    return status;
}

}  // namespace candelabra
