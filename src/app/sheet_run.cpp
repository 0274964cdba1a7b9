// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sheet_run.h"

#include "app/movie.h"
#include "tasks/scene_run.h"
#include "options/animation.h"
#include "options/command_line.h"
#include "options/declared_values.h"
#include "options/output.h"
#include "picture/file.h"
#include "picture/read.h"
#include "production/version.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/shell_word.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

/// Radiance between the pictures: dark, and lighter than a night.
const Rgb backing(0.03);

/// Pixels between two pictures.
int gap(int width) { return std::max(width / 64, 2); }

/// Files that are removed in the end.
class PassingFiles {
public:
    PassingFiles() = default;
    PassingFiles(const PassingFiles&) = delete;
    PassingFiles& operator=(const PassingFiles&) = delete;
    ~PassingFiles() {
        std::error_code none;
        for (const std::string& each : paths_) fs::remove(each, none);
    }
    void add(const std::string& path) { paths_.push_back(path); }

private:
    std::vector<std::string> paths_;
};

std::string text_of(const std::vector<Declaration>& values) {
    std::string text;
    for (const auto& [name, value] : values)
        text += message(text.empty() ? "" : ", ", name, " = ", candelabra::text_of(value));
    return text;
}

class SheetRun {
public:
    SheetRun(const Options& options, const Sheet& sheet, const Console& console,
             Diagnostics& diagnostics)
        : options_(options), sheet_(sheet), console_(console), diagnostics_(diagnostics) {}

    int execute() {
        output_ = output_of(options_, diagnostics_);
        if (diagnostics_.failed()) return end_with_errors(exit_status::usage);
        if (const std::string problem = problem_with_output(options_, output_.path);
            !problem.empty()) {
            diagnostics_.add(error(Fault::io, {}, problem));
            return end_with_errors(exit_status::file);
        }
        whole_ = blank();
        for (int i = 0; i < sheet_.pictures(); ++i)
            if (const int status = add_picture(i); status != exit_status::done) return status;
        output_.format.description = message(program_name(), "; made by: ", command_line(options_),
                                             " --sheet ", shell_word(options_.sheet));
        // Files of the pictures have linear values, or the values that are shown.
        if (!write_picture(whole_, output_.path, output_.format, diagnostics_))
            return end_with_errors(exit_status::file);
        if (talks(options_))
            say(console_, Stream::statistics,
                message(printable(output_.path), ": ", sheet_.pictures(), " pictures\n"));
        return exit_status::done;
    }

private:
    int end_with_errors(int status) {
        say_errors(console_, options_, diagnostics_);
        return status;
    }

    Image blank() const {
        const int wide = options_.render.width, high = options_.render.height, between = gap(wide);
        Image image(sheet_.columns * (wide + between) - between,
                    sheet_.rows * (high + between) - between);
        std::ranges::fill(image.pixels, backing);
        return image;
    }

    Options picture_options(int i) const {
        Options options = with_values(options_, sheet_.values_in(i));
        options.sheet.clear();
        options.verbose = false;
        options.leaves_state = false;  // the sheet could not go on from it
        const bool linear = info(output_.format.type).linear;
        options.type = linear ? PictureType::exr : PictureType::png;
        options.bits = linear ? options.bits : 16;
        options.file_gamma = -1;
        options.output =
            hidden_part(output_.path, static_cast<std::size_t>(i) + 1, linear ? ".exr" : ".png");
        for (std::string* each : files_beside(options))
            if (!each->empty() && *each != "-")
                *each = numbered(*each, i + 1,
                                 static_cast<int>(std::to_string(sheet_.pictures()).size()));
        const double count = sheet_.pictures();
        options.share = {i / count, (i + 1) / count};
        return options;
    }

    /// Renders a picture and copies it to its place. Returns the exit status.
    int add_picture(int i) {
        const Options options = picture_options(i);
        if (talks(options_))
            say(console_, Stream::render,
                message("picture ", i + 1, " of ", sheet_.pictures(), ": ",
                        text_of(sheet_.values_in(i)), "\n"));
        Diagnostics problems = std::exchange(said_, true) ? diagnostics_.fresh() : diagnostics_;
        const std::string path = output_of(options, problems).path;
        PassingFiles files;
        files.add(path);
        Console console = console_;
        console.sorted = [this](Stream stream, std::string_view text, std::string_view plain) {
            if (stream != Stream::warning || warned_.insert(std::string(plain)).second)
                say(console_, stream, text, plain);
        };
        if (const int status = run_scene(options, console, problems); status != exit_status::done)
            return status;
        const auto picture = read_picture(path, diagnostics_);
        if (!picture) return end_with_errors(exit_status::file);
        const int between = gap(options_.render.width);
        const int left = sheet_.column_of(i) * (picture->width + between);
        const int top = sheet_.row_of(i) * (picture->height + between);
        for (int y = 0; y < picture->height; ++y)
            for (int x = 0; x < picture->width; ++x)
                whole_.at(left + x, top + y) = picture->at(x, y);
        return exit_status::done;
    }

    const Options& options_;
    const Sheet& sheet_;
    const Console& console_;
    Diagnostics& diagnostics_;
    Output output_;
    Image whole_;
    bool said_ = false;             ///< problems with the command line have been reported
    std::set<std::string> warned_;  ///< warnings that pictures before have had
};

}  // namespace

std::optional<Sheet> plan_sheet(const Options& options, Diagnostics& diagnostics) {
    if (options.sheet.empty()) return {};
    const auto refuse = [&](std::string text, std::string help = {}) {
        diagnostics.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
    };
    std::string problem;
    std::optional<Sheet> sheet = sheet_of(options.sheet, problem);
    if (!sheet) refuse(message("--sheet: ", problem), "--sheet 4x3 Seed=1..12");
    const AnimationSettings& frames = options.animation;
    if (frames.initial_frame || frames.final_frame || !frames.chosen.empty())
        refuse("a contact sheet shows values of names and no frames of an animation",
               "--sheet 4x3 clock=0..1");
    if (options.preview_port || options.task != Task::render)
        refuse(
            "--sheet makes a picture, which no preview, check, dump, export or measurement does");
    if (!options.shard.empty() || options.go_on || options.keep_state)
        refuse(
            "a contact sheet has no state, so it goes with neither --shard, +C nor --keep-state");
    if (!options.layers.empty() || options.alpha || options.denoise)
        refuse("a contact sheet is one file without layers, alpha channel and denoised copy",
               options.denoise ? "--draft" : "Declare=NAME=VALUE makes one of its pictures");
    Diagnostics said_elsewhere = diagnostics.fresh();
    if (!options.to_file || is_stream(output_of(options, said_elsewhere).path))
        refuse("a contact sheet is a file: it goes neither with -F nor with standard output");
    return sheet;
}

int run_sheet(const Options& options, const Sheet& sheet, const Console& console,
              Diagnostics& diagnostics) {
    return SheetRun(options, sheet, console, diagnostics).execute();
}

}  // namespace candelabra
