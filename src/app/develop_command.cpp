// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/develop_command.h"

#include "app/movie.h"
#include "app/sandbox.h"
#include "film/develop.h"
#include "film/false_colour.h"
#include "options/command_line.h"
#include "options/option_store.h"
#include "options/option_table.h"
#include "options/output.h"
#include "options/subcommands.h"
#include "output/layers.h"
#include "output/light_file.h"
#include "output/light_weights.h"
#include "picture/file.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

namespace candelabra {

namespace {

struct DevelopRequest {
    Options options;
    std::vector<std::string> files;
    std::string layer;         ///< empty: the picture itself
    LightWeights weights;      ///< of options `--light`, and of the file once it is read
    std::string weights_file;  ///< of `--lights`; empty: none
    std::optional<FalseColours> false_colours;  ///< instead of the film
};

/// A picture that is made of a file.
struct LitFrame {
    std::string file, output;
    LightFactors factors;
};

/// Whether an option, written as in an INI file, can change the result of develop.
bool matters_to_develop(std::string_view given) {
    static constexpr auto all = std::to_array<std::string_view>(
        {"Output_File_Name=", "Output_File_Type=", "+F",
         "Bits_Per_Color=", "Grayscale_Output=", "File_Gamma=", "Verbose=", "--diagnostics=",
         "--warn=", "Warning_Level=", "Work_Threads=", "--sandbox=", "--movie=", "--frame-rate="});
    const auto of_film = [&](const OptionRow& row) {
        return row.group == OptionGroup::film && given.starts_with(message("--", row.word, '='));
    };
    return std::ranges::any_of(option_table(), of_film) ||
           std::ranges::any_of(all, [&](std::string_view each) { return given.starts_with(each); });
}

bool names_exr(std::string_view argument) {
    return !argument.starts_with('-') && !argument.starts_with('+') &&
           type_of_name(argument) == PictureType::exr;
}

/// What false colours show: the word of the option, the layer, and the unit of its numbers.
struct ShownQuantity {
    std::string_view word, layer, unit;
};
constexpr auto shown_quantities =
    std::to_array<ShownQuantity>({{"lux", "illuminance", "lx"}, {"nit", "luminance", "cd/m2"}});

/// Reads the value of `--false-colour` or `--scale`.
void read_false_colour(std::string_view option, std::string_view value, DevelopRequest& request,
                       Diagnostics& diagnostics) {
    FalseColours& wanted =
        request.false_colours ? *request.false_colours : request.false_colours.emplace();
    if (option == "--scale") {
        const auto most = number(value);
        if (most && *most > 0 && *most <= 1e12)
            wanted.most = *most;
        else
            diagnostics.add(error(Fault::option, {}, "`--scale` needs a number above 0"));
        return;
    }
    const auto found = std::ranges::find(shown_quantities, value, &ShownQuantity::word);
    if (found == shown_quantities.end()) {
        diagnostics.add(error(Fault::option, {},
                              message("`", printable(value), "` cannot be shown in false colours"))
                            .with_help("--false-colour lux, or nit"));
        return;
    }
    wanted.unit = found->unit;
    request.layer = found->layer;
}

DevelopRequest read_develop_request(std::span<const std::string_view> arguments,
                                    Diagnostics& diagnostics) {
    DevelopRequest request;
    bool isolines = false;
    const auto take = [&](std::string_view name, std::string value) {
        if (name == "--layer")
            request.layer = std::move(value);
        else if (name == "--light")
            request.weights.add(value, diagnostics);
        else if (name == "--lights")
            request.weights_file = std::move(value);
        else if (name == "--isolines")
            isolines = true;
        else
            read_false_colour(name, value, request, diagnostics);
    };
    const std::vector<std::string> words = take_options("develop", arguments, take, diagnostics);
    std::vector<std::string_view> others;
    for (const std::string& word : words)
        if (names_exr(word))
            request.files.push_back(word);
        else
            others.push_back(word);
    if (request.false_colours) request.false_colours->isolines = isolines;
    if (!diagnostics.failed() && (isolines || request.false_colours) &&
        (!request.false_colours || request.false_colours->unit.empty()))
        diagnostics.add(error(Fault::option, {}, "a scale and isolines belong to false colours")
                            .with_help("--false-colour lux"));
    request.options = read_options(others, diagnostics);
    warn_of_options_of_rendering(request.options, diagnostics);
    if (request.options.scene)
        diagnostics.add(error(
            Fault::option, {},
            message("`", printable(*request.options.scene), "` is no OpenEXR file by its name")));
    else if (request.options.task != Task::render)
        diagnostics.add(error(Fault::option, {}, "develop makes pictures and nothing else")
                            .with_help("man candelabra-develop"));
    else if (request.files.empty())
        diagnostics.add(error(Fault::option, {}, "develop needs a picture that has kept its light")
                            .with_help("candelabra develop picture.exr -o picture.png"));
    return request;
}

/// Whether `--output` names a file rather than a folder.
bool names_one_file(const DevelopRequest& request) {
    const std::string& said = request.options.output;
    std::error_code none;
    return !said.empty() && !said.ends_with('/') && !std::filesystem::is_directory(said, none);
}

class Developer {
public:
    Developer(const DevelopRequest& request, Diagnostics& diagnostics)
        : request_(request), diagnostics_(diagnostics) {}

    /// Develops one file. Returns false after an error has been reported.
    bool file(const LitFrame& frame) {
        const std::string& path = frame.file;
        const auto file = LightFile::read(path, diagnostics_);
        if (!file) return false;
        const auto film = film_of(*file, request_.options, diagnostics_);
        if (!film) return false;
        FilmFiles files;
        files.film = *film;
        if (request_.false_colours) return false_colours(*file, files, frame);
        Negative negative;
        if (!negative_of_file(*file, files.film, negative) || !relit_by(frame, *file, negative))
            return false;
        Options options = request_.options;
        options.alpha = !negative.alpha.empty();
        options.output = frame.output;
        Output output = output_of(options, diagnostics_);
        if (diagnostics_.failed()) return false;
        if (const std::string& text = file->description(); !text.empty())
            output.format.description = command_for(text, output.format);
        files.path = output.path;
        files.format = output.format;
        files.threads = options.render.threads;
        if (!is_developed(files))
            return fail(
                "an OpenEXR or Radiance HDR file keeps the light, "
                "which develop is to end",
                "-o picture.png");
        return write_developed(negative, files, diagnostics_);
    }

private:
    bool fail(std::string text, std::string help = {}) {
        diagnostics_.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
        return false;
    }

    /// Shows the numbers of a layer by colours. The film changes nothing of them.
    bool false_colours(const LightFile& file, FilmFiles files, const LitFrame& frame) {
        const auto values = file.image(request_.layer);
        if (!values)
            return fail(
                message("`", printable(file.path()), "` has no layer `", request_.layer, "`"),
                message("render it with --layers ", request_.layer));
        if (!frame.factors.empty())
            return fail("weights of lamps change no layer in false colours");
        Options options = request_.options;
        options.output = frame.output;
        const Output output = output_of(options, diagnostics_);
        if (diagnostics_.failed()) return false;
        files.path = output.path;
        files.format = output.format;
        files.film.on = true;
        if (!is_developed(files))
            return fail("false colours are for eyes: a file for programs keeps the numbers",
                        "-o picture.png");
        PictureFormat format = files.format;
        format.gamma = 1;
        format.encoded = true;
        return write_picture(false_coloured(*values, *request_.false_colours), files.path, format,
                             diagnostics_);
    }

    bool negative_of_file(const LightFile& file, const FilmSettings& film, Negative& negative) {
        const std::string& path = file.path();
        std::string layer = request_.layer;
        auto light = file.image(layer);
        const std::vector<std::string> names = file.layers();
        if (!light && layer.empty() && !names.empty()) {
            // Files of other programs may have no picture besides their layers.
            layer = names.front();
            light = file.image(layer);
        }
        if (!light) {
            const std::string meant =
                nearest(layer, std::vector<std::string_view>(names.begin(), names.end()));
            std::string known;
            for (const std::string& name : names)
                if (!name.empty()) known += message(known.empty() ? "" : ", ", printable(name));
            return fail(layer.empty() ? message("`", printable(path), "` has no colours")
                                      : message("`", printable(path), "` has no layer `",
                                                printable(layer), "` of colours"),
                        !meant.empty()   ? message("did you mean `", meant, "`?")
                        : !known.empty() ? message("there are ", known)
                                         : "");
        }
        const bool quiet = layer == denoised_layer;
        negative.light = std::move(*light);
        negative.alpha = file.alpha(quiet ? std::string() : layer);
        if (film.smooths_edges() && (quiet || layer.empty()))
            negative.smooth = file.image(quiet ? message(denoised_layer, '.', smooth_layer)
                                               : std::string(smooth_layer))
                                  .value_or(Image());
        return true;
    }

    /// Lights the negative anew. Its smooth edges have been made with the old light.
    bool relit_by(const LitFrame& frame, const LightFile& file, Negative& negative) {
        if (frame.factors.empty()) return true;
        if (!request_.layer.empty() && request_.layer != denoised_layer)
            return fail(message("weights change the picture, or the layer `", denoised_layer,
                                "`, and not `", printable(request_.layer), "`"));
        const std::string before =
            request_.layer.empty() ? "light." : message(denoised_layer, ".light.");
        const auto known = lamps_of(file, before, negative.light, diagnostics_);
        if (!known) return false;
        std::vector<LampLight> lamps;
        for (const auto& [name, factor] : frame.factors) {
            if (std::ranges::find(*known, name) == known->end()) return unknown_lamp(name, *known);
            lamps.push_back({*file.image(before + name), factor});
        }
        relight(negative.light, lamps);
        if (std::ranges::any_of(lamps, [](const auto& lamp) { return lamp.factor != Rgb(1); }))
            negative.smooth = Image();
        return true;
    }

    bool unknown_lamp(const std::string& name, const std::vector<std::string>& known) {
        const std::string meant =
            nearest(name, std::vector<std::string_view>(known.begin(), known.end()));
        std::string all;
        for (const std::string& each : known)
            all += message(all.empty() ? "" : ", ", printable(each));
        return fail(message("there is no light of `", printable(name), "` in the file"),
                    message(meant.empty() ? "" : message("did you mean `", printable(meant), "`? "),
                            "there are ", all));
    }

    const DevelopRequest& request_;
    Diagnostics& diagnostics_;
};

/// Returns the path of a picture: beside its file, unless the options say otherwise. `number`: of
/// the pictures of one file, with leading zeros; empty if it has one.
std::string output_for(const DevelopRequest& request, const std::string& file,
                       const std::string& number) {
    namespace fs = std::filesystem;
    const std::string& said = request.options.output;
    if (names_one_file(request)) return said;
    fs::path made(file);
    if (!said.empty()) made = fs::path(said) / made.filename();
    made.replace_filename(made.stem().string() + number);
    const PictureType type = request.options.type.value_or(PictureType::png);
    return made.concat(".").concat(extension(type)).string();
}

/// Returns the pictures that are to be made. Reports weights of other numbers of frames.
std::vector<LitFrame> frames_of(const DevelopRequest& request, Diagnostics& diagnostics) {
    const std::size_t rows = request.weights.frames(), files = request.files.size();
    if (rows > 0 && files > 1 && rows != files)
        diagnostics.add(
            error(Fault::option, {},
                  message("`", printable(request.weights_file), "` has ", rows,
                          rows == 1 ? " frame" : " frames", ", and there are ", files, " files"))
                .with_help("one file, or one for each frame"));
    const std::size_t count = std::max(files, rows);
    const bool hidden = !request.options.movie.empty() && request.options.output.empty();
    std::vector<LitFrame> lit;
    for (std::size_t i = 0; i < count && !diagnostics.failed(); ++i) {
        const std::string& file = request.files[files == 1 ? 0 : i];
        std::string number;
        if (files == 1 && count > 1) {
            number = std::to_string(i + 1);
            number.insert(0, std::to_string(count).size() - number.size(), '0');
        }
        lit.push_back(
            {file,
             hidden ? hidden_part(request.options.movie, i, ".png")
                    : output_for(request, file, number),
             request.weights.of(i)});
    }
    // Two pictures must not go to the same file.
    if (lit.size() > 1 && names_one_file(request))
        diagnostics.add(error(Fault::option, {}, "several pictures cannot go to one file")
                            .with_help("-o a folder, with a / at its end"));
    return lit;
}

/// Develops all pictures, and joins them to a movie if one is wanted.
bool develop_frames(const DevelopRequest& request, std::span<const LitFrame> lit,
                    Diagnostics& diagnostics) {
    const Options& options = request.options;
    Developer developer(request, diagnostics);
    std::vector<std::string> frames;
    bool good = true;
    for (const LitFrame& frame : lit) {
        good = good && developer.file(frame);
        frames.push_back(frame.output);
    }
    if (options.movie.empty()) return good;
    good = good && make_movie(frames, options.frame_rate, options.movie, diagnostics);
    std::error_code none;
    if (options.output.empty())
        for (const std::string& frame : frames) std::filesystem::remove(frame, none);
    return good;
}

}  // namespace

void check_movie(const Options& options, Diagnostics& diagnostics) {
    if (options.movie.empty()) return;
    const std::string problem = problem_with_destination(options.movie);
    if (!problem.empty())
        diagnostics.add(error(Fault::io, {}, problem));
    else
        can_make_movie(options.frame_rate, options.movie, diagnostics);
}

void warn_of_options_of_rendering(const Options& options, Diagnostics& diagnostics) {
    for (const auto& [row, given] : options.given)
        if (!matters_to_develop(given))
            diagnostics.add(warning(
                Fault::option, {},
                message("`", printable(given), "` is ignored: nothing is rendered any more")));
}

bool develop_file(const std::string& exr, std::string_view layer, const std::string& picture,
                  Diagnostics& diagnostics) {
    DevelopRequest request;
    request.options.output = picture;
    request.layer = layer;
    return Developer(request, diagnostics).file({exr, picture, {}});
}

int run_develop(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    DevelopRequest request = read_develop_request(arguments, diagnostics);
    const auto end = [&](int status) {
        say_errors(console, request.options, diagnostics);
        return status;
    };
    SandboxRules rules = sandbox_rules(request.options, console.library, request.files);
    if (!request.weights_file.empty()) rules.readable.push_back(request.weights_file);
    if (!diagnostics.failed()) confined(request.options, rules, console, diagnostics);
    if (diagnostics.failed()) return end(exit_status::usage);
    // The frames of a movie that are not kept are hidden files of one format.
    if (!request.options.movie.empty() && request.options.output.empty())
        request.options.type = PictureType::png;
    if (!request.weights_file.empty()) request.weights.read(request.weights_file, diagnostics);
    const std::vector<LitFrame> lit = frames_of(request, diagnostics);
    check_movie(request.options, diagnostics);
    if (diagnostics.failed()) return end(exit_status::usage);
    if (!develop_frames(request, lit, diagnostics)) return end(exit_status::file);
    return end(exit_status::done);
}

}  // namespace candelabra
