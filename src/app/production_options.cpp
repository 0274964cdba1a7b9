// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/production_options.h"

#include "app/progress.h"
#include "text/message.h"
#include "text/printable.h"

#include <array>

namespace candelabra {

namespace {

/// A unit after a number. Ignores case.
struct Unit {
    char ending;
    double factor;
};

std::optional<double> with_unit(const std::string& text, std::span<const Unit> units) {
    for (const Unit& unit : units)
        if (!text.empty() && same_letters(text.substr(text.size() - 1), {&unit.ending, 1})) {
            const auto value = number(std::string_view(text).substr(0, text.size() - 1));
            return value ? std::optional(*value * unit.factor) : std::nullopt;
        }
    return number(text);
}

std::optional<double> seconds(const Given& given, Diagnostics& diagnostics) {
    static constexpr auto units = std::array{Unit{'s', 1}, Unit{'m', 60}, Unit{'h', 3600}};
    const auto value = with_unit(*given.value, units);
    if (value && *value >= 0 && *value <= 1e9) return value;
    refuse(given, diagnostics, "a time is a number of seconds, or has one of the endings s, m, h");
    return std::nullopt;
}

void row_or_column(std::optional<double>& place, const Given& given, Diagnostics& diagnostics) {
    place = number(*given.value);
    if (!place || *place < 0)
        refuse(given, diagnostics, "rows and columns are numbers from 1 on, or fractions below 1");
}

}  // namespace

void store::layers(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (const auto layers = read_layer_list(*given.value)) {
        options.layers = *layers;
        return;
    }
    std::string known;
    for (const LayerInfo& info : all_layers()) known += message(info.name, ", ");
    refuse(given, diagnostics, "a layer has none of these names", known + "all");
}

void store::alpha(Options& options, const Given& given, Diagnostics&) { options.alpha = given.on; }

void store::denoise(Options& options, const Given&, Diagnostics&) { options.denoise = true; }

void store::grey(Options& options, const Given& given, Diagnostics&) { options.grey = given.on; }

void store::time(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.time = seconds(given, diagnostics);
    if (options.time == 0.0) refuse(given, diagnostics, "a picture needs a time above 0");
}

void store::start_row(Options& options, const Given& given, Diagnostics& diagnostics) {
    row_or_column(options.start_row, given, diagnostics);
}

void store::end_row(Options& options, const Given& given, Diagnostics& diagnostics) {
    row_or_column(options.end_row, given, diagnostics);
}

void store::start_column(Options& options, const Given& given, Diagnostics& diagnostics) {
    row_or_column(options.start_column, given, diagnostics);
}

void store::end_column(Options& options, const Given& given, Diagnostics& diagnostics) {
    row_or_column(options.end_column, given, diagnostics);
}

void store::frames(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (auto numbers = frame_list(*given.value))
        options.animation.chosen = std::move(*numbers);
    else
        refuse(given, diagnostics, "needs numbers of frames, and ranges of them", "3,7,12-20,9-5");
}

void store::go_on(Options& options, const Given& given, Diagnostics&) { options.go_on = given.on; }

void store::checkpoint(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.checkpoint_interval = seconds(given, diagnostics).value_or(0);
}

void store::keep_state(Options& options, const Given&, Diagnostics&) { options.keep_state = true; }

void store::shard(Options& options, const Given& given, Diagnostics&) {
    options.shard = *given.value;
}

void store::shard_by(Options& options, const Given& given, Diagnostics& diagnostics) {
    static constexpr auto kinds =
        std::array{std::pair{"samples", ShardBy::samples}, std::pair{"tiles", ShardBy::tiles},
                   std::pair{"frames", ShardBy::frames}};
    for (const auto& [name, kind] : kinds)
        if (*given.value == name) options.shard_by = kind;
    if (!options.shard_by)
        refuse(given, diagnostics,
               message("there are no parts called `", printable(*given.value), "`"),
               "samples, tiles or frames");
}

void store::depfile(Options& options, const Given& given, Diagnostics&) {
    options.depfile = *given.value;
}

void store::preview(Options& options, const Given& given, Diagnostics& diagnostics) {
    const auto port = number(*given.value);
    if (!port || *port < 0 || *port > 65535 || *port != static_cast<int>(*port))
        return refuse(given, diagnostics, "a port is a number from 0 to 65535");
    if (options.task != Task::render) return refuse(given, diagnostics, shown_only);
    options.preview_port = static_cast<int>(*port);
}

void store::progress(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.progress = *given.value;
    if (options.progress != "auto" && !progress_style(options.progress))
        refuse(given, diagnostics,
               message("there is no such form of progress as `", printable(*given.value), "`"),
               "auto, plain, json, alf, openjd or none");
}

void store::memory(Options& options, const Given& given, Diagnostics& diagnostics) {
    static constexpr auto units =
        std::array{Unit{'k', 0x1p10}, Unit{'m', 0x1p20}, Unit{'g', 0x1p30}, Unit{'t', 0x1p40}};
    const auto bytes = with_unit(*given.value, units);
    if (!bytes || *bytes < 0x1p20 || *bytes > 0x1p60)
        return refuse(given, diagnostics, "a size of memory is a number with K, M, G or T", "8G");
    options.memory_bytes = static_cast<std::uint64_t>(*bytes);
}

void store::sandbox(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (*given.value != "on" && *given.value != "off")
        refuse(given, diagnostics,
               message("a sandbox is `on` or `off`, not `", printable(*given.value), "`"),
               "--sandbox off");
    else
        options.sandbox = *given.value == "on";
}

}  // namespace candelabra
