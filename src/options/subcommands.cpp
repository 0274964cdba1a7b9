// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/subcommands.h"

#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace candelabra {

namespace {

using Option = SubcommandOption;

constexpr auto of_new =
    std::to_array<Option>({{"--template", "kind of scene to begin with", "name"}});
constexpr auto of_merge = std::to_array<Option>({
    {"--partial", "makes a picture of what there is"},
    {"--status", "says what is there, and makes nothing"},
});
constexpr auto of_develop = std::to_array<Option>({
    {"--layer", "layer of the file that is developed", "name"},
    {"--light", "weight of a lamp: Name=0.5, or a colour", "weight"},
    {"--lights", "weights of lamps, in one row for each frame", "file"},
    {"--false-colour", "shows numbers by colours: lux or nit", "quantity"},
    {"--scale", "end of the scale of false colours", "number"},
    {"--isolines", "draws lines of equal value"},
});
/// What lamps do in a show.
constexpr auto of_shows = std::to_array<Option>({
    {"--set", "power and colour of lamps in all pictures: Lamp=0.2,#ff8800", "lamp"},
    {"--csv", "table of frames or of cues", "file"},
    {"--fseq", "show of channels, as xLights saves it", "file"},
    {"--raw", "show as bare bytes of channels", "file"},
    {"--channels", "channels in a frame of bare bytes", "number"},
    {"--patch", "which lamps hang on which channels", "file"},
    {"--curve", "light that a channel gives: linear, square or an exponent", "curve"},
});
constexpr auto of_relight = std::to_array<Option>({
    {"--smooth", "pixels around each to which light of crowds is fitted (4)", "number"},
    {"--meters", "table of the meters' readings in each frame", "file"},
    {"--lamps", "prints the names of the lamps"},
});
constexpr auto of_solve = std::to_array<Option>({
    {"--on", "meter that the ranges behind it are for", "meter"},
    {"--lux", "range for each point of the meter: 20..50", "range"},
    {"--mean-lux", "range for the mean of its points", "range"},
    {"--lamps", "lamps whose powers are sought", "name"},
    {"--together", "gives the lamps of a name one power"},
    {"--max-power", "greatest power, in terms of that in the scene", "factor"},
    {"--output", "receives the powers", "file"},
});
constexpr auto of_share = std::to_array<Option>({{"--output", "receives the page", "file"}});
constexpr auto of_light = std::to_array<Option>({
    {"--json", "describes the files as JSON"},
    {"--set", "number of the set of lamps, from 1", "number"},
    {"--output", "receives the polar diagram, as SVG", "file"},
});
constexpr auto of_fmt =
    std::to_array<Option>({{"--check", "only names the files that it would change"}});

constexpr auto every_subcommand = std::to_array<Subcommand>({
    {"new", "writes a scene to begin with", "", false, of_new},
    {"merge", "joins the states of shards", "exr", true, of_merge},
    {"develop", "develops light in OpenEXR files", "exr", true, of_develop},
    {"relight", "lights a rendered scene with other powers of its lamps", "lights", true,
     of_relight, of_shows},
    {"solve", "finds powers of lamps with which meters read what they are to", "pov|ini", true,
     of_solve},
    {"share", "makes a page to share", "pov|exr|lights", true, of_share, of_shows},
    {"light", "describes the photometry of a luminaire", "ies|ldt", false, of_light},
    {"fmt", "lays out scene files", "pov|inc", false, of_fmt},
    {"describe", "lists what the language, the options and the library have", ""},
    {"lsp", "helps an editor with scenes", ""},
});

}  // namespace

std::vector<Option> options_of(const Subcommand& command) {
    std::vector<Option> options(command.options.begin(), command.options.end());
    options.insert(options.end(), command.shared.begin(), command.shared.end());
    return options;
}

std::span<const Subcommand> subcommands() { return every_subcommand; }

std::vector<std::string> take_options(
    std::string_view subcommand, std::span<const std::string_view> arguments,
    const std::function<void(std::string_view name, std::string value)>& take,
    Diagnostics& diagnostics) {
    const Subcommand& command =
        *std::ranges::find(every_subcommand, subcommand, &Subcommand::name);
    const std::vector<Option> options = options_of(command);
    const auto find = [&](std::string_view name) {
        return std::ranges::find(options, name, &Option::name);
    };
    const auto none = options.end();
    const bool has_output = find("--output") != none;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--") {
            others.insert(others.end(), arguments.begin() + static_cast<std::ptrdiff_t>(i),
                          arguments.end());
            break;
        }
        const std::size_t equals = argument.find('=');
        const std::string_view given = argument.substr(0, equals);
        const bool is_output =
            (given == "-o" || given == "--output") && (has_output || command.takes_run);
        const auto option = find(given == "-o" ? "--output" : given);
        if (has_output && argument.starts_with("+O")) {
            take("--output", std::string(argument.substr(2)));
        } else if (!is_output && option == none) {
            others.emplace_back(argument);
        } else if (!is_output && option->parameter.empty()) {
            if (equals == argument.npos)
                take(option->name, {});
            else
                others.emplace_back(argument);
        } else if (equals == argument.npos && i + 1 == arguments.size()) {
            diagnostics.add(
                error(Fault::option, {}, message("`", printable(given), "` needs a value")));
        } else {
            std::string value(equals == argument.npos ? arguments[++i]
                                                      : argument.substr(equals + 1));
            if (has_output || !is_output)
                take(option->name, std::move(value));
            else
                others.push_back(message("+O", value));
        }
    }
    return others;
}

}  // namespace candelabra
