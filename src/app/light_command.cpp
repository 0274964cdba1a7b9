// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/light_command.h"

#include "options/subcommands.h"
#include "photometry/polar_diagram.h"
#include "picture/file.h"
#include "text/excerpt.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/printable.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

using Json = nlohmann::json;

constexpr std::string_view usage_of_light =
    "candelabra light [--json] [--set n] [-o diagram.svg] file.ies|file.ldt ...";
constexpr double half_of_maximum = 0.5, tenth_of_maximum = 0.1;

/// What the arguments ask for.
struct LightRequest {
    std::vector<std::string> files;
    std::string diagram;
    bool json = false;
    PhotometricChoice choice;
};

std::optional<std::size_t> set_number(std::string_view text) {
    if (text.empty() || text.size() > 3) return std::nullopt;
    std::size_t number = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') return std::nullopt;
        number = 10 * number + static_cast<std::size_t>(c - '0');
    }
    return number > 0 ? std::optional(number - 1) : std::nullopt;
}

std::optional<LightRequest> asked_by(std::span<const std::string_view> arguments,
                                     Diagnostics& diagnostics) {
    LightRequest request;
    const auto fail = [&](const std::string& text) {
        diagnostics.add(error(Fault::option, {}, text).with_help(std::string(usage_of_light)));
        return std::nullopt;
    };
    const auto take = [&](std::string_view name, std::string value) {
        if (name == "--json")
            request.json = true;
        else if (name == "--output")
            request.diagram = std::move(value);
        else if (const auto number = set_number(value))
            request.choice.set = *number;
        else
            fail("`--set` needs the number of a lamp set, from 1");
    };
    Diagnostics given;
    std::vector<std::string> words = take_options("light", arguments, take, given);
    if (given.failed()) return fail(given.all().front().message);
    for (std::string& word : words)
        if (word.starts_with('-') && word != "-")
            return fail(message("light has no option `", printable(word), "`"));
        else
            request.files.push_back(std::move(word));
    if (diagnostics.failed()) return std::nullopt;
    if (request.files.empty()) return fail("light needs a file");
    if (!request.diagram.empty() && request.files.size() > 1)
        return fail("`-o` is for the diagram of one file");
    if (!request.diagram.empty() && !request.diagram.ends_with(".svg"))
        return fail(message("a diagram is an SVG file, and `", printable(request.diagram),
                            "` does not end in .svg"));
    return request;
}

/// Returns the text of a file that is not too large; reports why there is none.
std::optional<std::string> photometric_text(const std::string& path, Diagnostics& diagnostics) {
    if (auto text = content_of_file(path, max_photometric_bytes)) return text;
    diagnostics.add(error(Fault::io, {}, message("`", printable(path), "` cannot be read"))
                        .with_help("files of up to 16 MiB are read"));
    return std::nullopt;
}

double tenths(double value) { return std::round(10 * value) / 10; }

std::string angles_text(const PhotometricWeb& web, const WebAngles& angles) {
    const double elevation = web.type() == WebType::c ? angles.vertical : -1;
    return message("at V ", angles.vertical, ", H ", angles.horizontal, " degrees",
                   elevation == 0     ? ", straight down"
                   : elevation == 180 ? ", straight up"
                                      : "");
}

std::string type_name(WebType type) {
    return type == WebType::c ? "C" : type == WebType::b ? "B" : "A";
}

std::string percent(double share) { return message(tenths(100 * share), " %"); }

std::string flux_text(const PhotometricFile& file) {
    const double flux = file.web.flux();
    std::string text = message(tenths(flux), " lm");
    if (const auto lamps = file.lamp_flux())
        text += message(", ", percent(flux / *lamps), " of the lamps' ", *lamps, " lm");
    else if (file.absolute)
        text += ", measured as a whole (absolute photometry)";
    if (file.web.type() == WebType::c && flux > 0)
        text += message("; ", percent(file.web.flux_down() / flux), " of it down");
    return text;
}

std::string opening_text(const LuminousOpening& opening) {
    if (opening.shape == "point") return "a point";
    return message(opening.shape, ", width ", std::abs(opening.width), " m, length ",
                   std::abs(opening.length), " m, height ", std::abs(opening.height), " m");
}

std::string tilt_text(const LampTilt& tilt) {
    return message("factors for ", tilt.angles.size(), " tilts, lamp geometry ", tilt.geometry,
                   "; not applied here",
                   tilt.follows_aim() ? ", and in a scene by the angle of `aim` to the vertical"
                                      : ", nor in a scene");
}

/// Describes one file. Returns the exit status.
int describe_file(const std::string& path, const LightRequest& request, const Console& console,
                  std::vector<Json>& made, Diagnostics& diagnostics) {
    const auto text = photometric_text(path, diagnostics);
    if (!text) return exit_status::file;
    PhotometricFile file;
    if (const std::string problem = read_photometric(*text, request.choice, file);
        !problem.empty()) {
        diagnostics.add(error(Fault::io, {}, message("`", printable(path), "`: ", problem)));
        return exit_status::file;
    }
    if (request.json)
        made.push_back(photometric_json(path, file));
    else
        console.out(photometric_summary(path, file) + polar_text(file));
    if (request.diagram.empty()) return exit_status::done;
    const std::string title = printable(std::filesystem::path(path).filename().string());
    return write_file(request.diagram, polar_diagram(file, title), diagnostics) ? exit_status::done
                                                                                : exit_status::file;
}

}  // namespace

std::string photometric_summary(const std::string& path, const PhotometricFile& file) {
    std::string text = message(printable(path), ": ", file.format, '\n');
    const auto row = [&](std::string_view name, const std::string& value) {
        constexpr std::size_t column = 11;
        text += message("  ", name, std::string(column - name.size(), ' '), value, '\n');
    };
    for (const auto& [keyword, name] : {std::pair{"MANUFAC", "maker"},
                                        {"LUMINAIRE", "luminaire"},
                                        {"LUMCAT", "number"},
                                        {"LAMP", "lamp"}})
        if (const auto label = file.label(keyword); !label.empty()) row(name, printable(label));
    const LampSet& lamps = file.sets[file.set];
    if (!lamps.type.empty())
        row("lamps",
            message(printable(lamps.type), ", ", printable(lamps.colour_temperature), " K"));
    row("flux", flux_text(file));
    row("maximum",
        message(tenths(file.web.greatest()), " cd ", angles_text(file.web, file.web.peak())));
    if (file.watts > 0)
        row("power", message(file.watts, " W, ", tenths(file.web.flux() / file.watts), " lm/W"));
    row("symmetry", message(file.symmetry, ", type ", type_name(file.web.type()), ", ",
                            file.web.vertical().size(), " angles in ",
                            file.web.horizontal().size() - 1, " planes when complete"));
    for (const WebSection& section : sections_of(file))
        row(section.solid ? "beam" : "",
            message(tenths(width_of_beam(file.web, section, half_of_maximum)),
                    " degrees to half of the maximum, ",
                    tenths(width_of_beam(file.web, section, tenth_of_maximum)), " to a tenth (",
                    section.name, ')'));
    row("opening", opening_text(file.opening));
    if (file.tilt) row("tilt", tilt_text(*file.tilt));
    for (const std::string& note : file.notes) row("note", note);
    return text;
}

Json photometric_json(const std::string& path, const PhotometricFile& file) {
    const WebAngles peak = file.web.peak();
    const double flux = file.web.flux();
    Json json = {{"file", std::filesystem::path(path).filename().string()},
                 {"format", file.format},
                 {"type", type_name(file.web.type())},
                 {"symmetry", file.symmetry},
                 {"flux_lm", flux},
                 {"max_cd", file.web.greatest()},
                 {"max_at", {{"vertical", peak.vertical}, {"horizontal", peak.horizontal}}},
                 {"watts", file.watts},
                 {"lamps", file.sets[file.set].count},
                 {"lumens_per_lamp", file.lumens_per_lamp},
                 {"absolute", file.absolute},
                 {"opening", file.opening.shape},
                 {"opening_m", {file.opening.width, file.opening.length, file.opening.height}},
                 {"notes", file.notes}};
    if (file.version > 0) json["version"] = file.version;
    if (file.watts > 0) json["efficacy_lm_per_w"] = flux / file.watts;
    if (const auto lamps = file.lamp_flux()) json["output_ratio"] = flux / *lamps;
    if (file.web.type() == WebType::c) {
        json["down_lm"] = file.web.flux_down();
        json["up_lm"] = flux - file.web.flux_down();
    }
    if (file.tilt)
        json["tilt"] = {{"geometry", file.tilt->geometry},
                        {"angles", file.tilt->angles},
                        {"factors", file.tilt->factors}};
    if (file.symmetry_number >= 0) {
        json["isym"] = file.symmetry_number;
        json["lorl_in_file"] = file.efficiency;
        for (const LampSet& each : file.sets)
            json["sets"].push_back({{"n", each.count},
                                    {"type", each.type},
                                    {"flux", each.flux},
                                    {"cct", each.colour_temperature},
                                    {"cri", each.colour_rendering},
                                    {"watt", each.watts}});
    }
    for (const auto& [keyword, text] : file.labels)
        if (!text.empty()) json["labels"][keyword] = text;
    return json;
}

int run_light(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    const std::optional<LightRequest> request = asked_by(arguments, diagnostics);
    int status = request ? exit_status::done : exit_status::usage;
    std::vector<Json> made;
    if (request)
        for (const std::string& path : request->files)
            status = std::max(status, describe_file(path, *request, console, made, diagnostics));
    constexpr int indent = 2;
    if (request && request->json && !made.empty())
        console.out((request->files.size() == 1 ? made.front() : Json(made))
                        .dump(indent, ' ', false, Json::error_handler_t::replace) +
                    "\n");
    for (const Diagnostic& each : diagnostics.all())
        console.err(format(each, SourceStore(), console.coloured));
    return status;
}

}  // namespace candelabra
