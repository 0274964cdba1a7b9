// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_store.h"

#include "base/video_gamma.h"
#include "options/completion.h"
#include "options/declared_values.h"
#include "text/ascii.h"
#include "text/decimal.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"
#include "vocabulary/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace candelabra {

bool is_given(const Options& options, std::string_view word) {
    const std::string name = message("--", word), with_value = name + "=";
    return std::ranges::any_of(options.given, [&](const GivenOption& each) {
        return each.line == name || each.line.starts_with(with_value);
    });
}

std::optional<double> number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    return finite_number(text);
}

std::optional<bool> truth(std::string_view text) {
    for (const std::string_view word : {"on", "true", "yes", "1"})
        if (same_letters(text, word)) return true;
    for (const std::string_view word : {"off", "false", "no", "0"})
        if (same_letters(text, word)) return false;
    return std::nullopt;
}

std::string shown(const Given& given) {
    const std::string place =
        given.where.empty() ? "" : message(printable(std::string(given.where)), ": ");
    return message(place, "`", printable(given.argument), "`");
}

void refuse(const Given& given, Diagnostics& diagnostics, const std::string& rule,
            const std::string& help) {
    diagnostics.add(error(Fault::option, {}, message(shown(given), ": ", rule)).with_help(help));
}

Setting find_setting(std::string_view name) {
    for (const ItemInfo* item : {&RenderSettings::vocabulary, &AnimationSettings::vocabulary}) {
        const auto found = std::ranges::find(item->fields, name, &FieldInfo::name);
        if (found != item->fields.end())
            return {item, static_cast<std::size_t>(found - item->fields.begin())};
    }
    return {};
}

void store::field(std::string_view name, Options& options, const Given& given,
                  Diagnostics& diagnostics) {
    const Setting setting = find_setting(name);
    const FieldInfo& info = setting.info();
    void* const item = setting.item == &RenderSettings::vocabulary
                           ? static_cast<void*>(&options.render)
                           : static_cast<void*>(&options.animation);
    if (info.type == FieldType::boolean) {
        setting.item->set(item, setting.field, given.on ? 1.0 : 0.0);
        if (given.value)
            field(setting.item->fields[setting.field + 1].name, options, given, diagnostics);
        return;
    }
    const std::optional<double> value = number(given.value.value_or(""));
    const double given_number = value.value_or(0);
    const bool integer = info.type == FieldType::integer, in_file = !given.where.empty();
    const double counts = integer ? std::trunc(given_number) : given_number;
    // Fractions are accepted since programs write computed sizes into INI files.
    if (counts != given_number && in_file)
        diagnostics.add(warning(Fault::option, {}, message(shown(given), " counts as ", counts)));
    constexpr double max_whole = std::numeric_limits<int>::max();
    const bool has_place = !integer || std::abs(counts) <= max_whole;
    if (value && (counts == given_number || in_file) && info.range.contains(counts) && has_place)
        return setting.item->set(item, setting.field, counts);
    const std::string got = given.value && !given.value->empty()
                                ? message(", but it is `", printable(*given.value), "`")
                                : "";
    refuse(given, diagnostics, message(info.name, " must be a ", takes(info), got));
}

void store::scene(Options& options, const Given& given, Diagnostics&) {
    options.scene = *given.value;
}

void store::bits(Options& options, const Given& given, Diagnostics& diagnostics) {
    const std::optional<double> bits = number(*given.value);
    if (bits != 8.0 && bits != 16.0)
        return refuse(given, diagnostics, "a channel can have 8 or 16 bits");
    options.bits = static_cast<int>(*bits);
}

void store::type(Options& options, const Given& given, Diagnostics& diagnostics) {
    const std::string& text = *given.value;
    const char asked = text.empty() ? ' ' : lower_case(text[0]);
    // POV-Ray's S is the format of the system, and C a compressed Targa file.
    const char letter = asked == 's' ? 'n' : asked == 'c' ? 't' : asked;
    const auto found = std::ranges::find_if(picture_types(), [&](const PictureTypeInfo& each) {
        return lower_case(each.letter) == letter;
    });
    if (found == picture_types().end()) {
        std::string all;
        for (const PictureTypeInfo& each : picture_types())
            all += message(each.letter, ' ', each.name, ", ");
        return refuse(given, diagnostics, message("`", printable(text), "` is no picture format"),
                      all + "C compressed tga");
    }
    options.type = found->type;
    options.compressed = asked == 'c';
    std::string rest = text.substr(1);
    options.grey |= std::erase_if(rest, [](char c) { return c == 'g' || c == 'G'; }) > 0;
    // The number after J is the quality of JPEG files.
    if (options.type == PictureType::jpeg && number(rest))
        return diagnostics.add(warning(Fault::option, {},
                                       message(shown(given),
                                               ": the number is ignored: JPEG files "
                                               "are written in one quality")));
    if (!rest.empty()) store::bits(options, {given.argument, true, rest}, diagnostics);
}

void store::to_file(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.to_file = given.on;
    if (given.on && given.value) store::type(options, given, diagnostics);
}

void store::declare(Options& options, const Given& given, Diagnostics& diagnostics) {
    const std::string& text = *given.value;
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const std::string problem = problem_with_name(equals == text.npos ? "" : name);
    if (!problem.empty())
        return refuse(given, diagnostics, problem, "Declare=Depth=5, 'Declare=Title=\"text\"'");
    const auto value = declared_value(std::string_view(text).substr(equals + 1));
    if (!value)
        return refuse(given, diagnostics,
                      message("the value of `", name,
                              "` must be a number, a string in quotes, or a vector"),
                      message("for a string: 'Declare=", name, "=\"text\"'"));
    options.declares.emplace_back(name, *value);
}

void store::preset(Options&, const Given&, Diagnostics&) {}

void store::clock(Options& options, const Given& given, Diagnostics& diagnostics) {
    const auto value = number(*given.value);
    if (!value) return refuse(given, diagnostics, "clock must be a number");
    options.facts.clock = *value;
    options.facts.clock_given = true;
}

void store::header(Options& options, const Given& given, Diagnostics&) {
    options.facts.header = *given.value;
}

void store::include_ini(Options&, const Given&, Diagnostics&) {}

void store::create_ini(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.ini_file.reset();
    const std::optional<bool> on = given.value ? truth(*given.value) : given.on;
    if (!given.on || on == false) return;
    if (on) return refuse(given, diagnostics, "needs the name of a file", "+GIall.ini");
    options.ini_file = *given.value;
}

void store::gamma(Options& options, const Given& given, Diagnostics& diagnostics) {
    const std::optional<double> gamma = number(*given.value);
    if (const auto curve = gamma_called(lower_case(*given.value)))
        options.file_gamma = *curve;
    else if (gamma && *gamma >= 0.1 && *gamma <= 10)
        options.file_gamma = *gamma;
    else
        refuse(given, diagnostics, "needs sRGB, bt709, bt2020 or a number from 0.1 to 10");
}

/// Handles comma-separated names of warnings; each name applies to the names after it.
void store::warn(Options&, const Given& given, Diagnostics& diagnostics) {
    std::vector<std::string_view> names = {"all", "none", "error"};
    for (const FaultInfo& fault : all_faults())
        if (!fault.warns_of.empty()) names.push_back(fault.name);
    std::string_view rest = *given.value;
    while (!rest.empty()) {
        const std::string_view word = take_until(rest, ",");
        const bool on = !word.starts_with("no-") || std::ranges::count(names, word) > 0;
        const std::string_view wanted = on ? word : word.substr(3);
        if (std::ranges::find(names, wanted) == names.end()) {
            const std::string meant = nearest(wanted, names);
            return refuse(given, diagnostics,
                          message("there is no warning `", printable(wanted), "`"),
                          meant.empty() ? "--help warn names all"
                                        : message("did you mean `", on ? "" : "no-", meant, "`?"));
        }
        if (wanted == "error") diagnostics.make_warnings_errors();
        for (const FaultInfo& fault : all_faults())
            if (wanted == "all" || wanted == "none" || wanted == fault.name)
                diagnostics.set_warning(fault.fault, on && wanted != "none");
    }
}

void store::warning_level(Options&, const Given& given, Diagnostics& diagnostics) {
    const auto level = number(*given.value);
    if (!level || *level < 0 || *level > 10)
        return refuse(given, diagnostics, "a warning level is a number from 0 (none) to 10");
    for (const FaultInfo& fault : all_faults()) diagnostics.set_warning(fault.fault, *level > 0);
}

namespace {

/// Reports an option that asks for another thing than one before it.
bool is_second_task(const Options& options, const Given& given, Diagnostics& diagnostics,
                    std::initializer_list<Task> same) {
    using enum Task;
    if (options.preview_port) {
        refuse(given, diagnostics, shown_only);
        return true;
    }
    static constexpr auto exclusive =
        std::array{check,      check_syntax, dump_tokens, dump_tree, dump_scene,
                   dump_world, dump_index,   export_mesh, measure,   balance,   pick};
    if (std::ranges::find(exclusive, options.task) == exclusive.end() ||
        std::ranges::find(same, options.task) != same.end())
        return false;
    refuse(given, diagnostics,
           "a run checks, dumps, picks, exports, measures or balances a scene, one of them only");
    return true;
}

}  // namespace

void store::check(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (is_second_task(options, given, diagnostics, {Task::check, Task::check_syntax})) return;
    options.task = given.value ? Task::check_syntax : Task::check;
    if (given.value && *given.value != "syntax")
        refuse(given, diagnostics, "only --check and --check=syntax are offered");
}

void store::dump(Options& options, const Given& given, Diagnostics& diagnostics) {
    static constexpr auto stages =
        std::array{std::pair{"tokens", Task::dump_tokens}, std::pair{"tree", Task::dump_tree},
                   std::pair{"scene", Task::dump_scene}, std::pair{"world", Task::dump_world},
                   std::pair{"index", Task::dump_index}};
    using enum Task;
    if (is_second_task(options, given, diagnostics,
                       {dump_tokens, dump_tree, dump_scene, dump_world, dump_index}))
        return;
    for (const auto& [name, task] : stages)
        if (*given.value == name) {
            options.task = task;
            return;
        }
    refuse(given, diagnostics, message("there is no stage `", printable(*given.value), "`"),
           "tokens, tree, scene, world or index");
}

void store::pick(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (is_second_task(options, given, diagnostics, {Task::pick})) return;
    options.task = Task::pick;
    std::string_view rest = *given.value;
    const auto column = number(take_until(rest, ",")), row = number(rest);
    constexpr double most = 65534;
    const auto usable = [](const std::optional<double>& each) {
        return each && *each >= 0 && *each <= most && *each == std::floor(*each);
    };
    if (!usable(column) || !usable(row))
        return refuse(given, diagnostics,
                      "needs the column and the row of a pixel, counted from 0 at the upper left",
                      "--pick 120,80");
    options.picked = {static_cast<int>(*column), static_cast<int>(*row)};
}

void store::export_mesh(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (is_second_task(options, given, diagnostics, {Task::export_mesh})) return;
    options.task = Task::export_mesh;
    options.mesh_file = *given.value;
}

void store::measure(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (is_second_task(options, given, diagnostics, {Task::measure})) return;
    options.task = Task::measure;
    options.readings_file = *given.value;
}

void store::light_balance(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (is_second_task(options, given, diagnostics, {Task::balance})) return;
    options.task = Task::balance;
    options.readings_file = *given.value;
}

void store::until(Options& options, const Given& given, Diagnostics& diagnostics) {
    const auto goal = read_meter_goal(*given.value);
    if (goal)
        options.meter_goal = *goal;
    else
        refuse(given, diagnostics,
               message("`", printable(*given.value), "` is no error of 0.001 to 100 per cent"),
               "--until 'lux 2%', 'nit 1%' or '2%', or the name of a quantity");
}

void store::help(Options& options, const Given& given, Diagnostics&) {
    options.task = Task::help;
    options.topic = given.value.value_or("");
}

void store::completion(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.task = Task::completion;
    options.topic = *given.value;
    if (!candelabra::completion(options.topic))
        refuse(given, diagnostics, "there is none for this shell", "bash, zsh or fish");
}

/// Handles the words after --describe, in any order: a form and a part.
void store::describe(Options& options, const Given& given, Diagnostics&) {
    options.task = Task::describe;
    std::string_view rest = given.value ? std::string_view(*given.value) : std::string_view();
    while (!rest.empty()) {
        const std::string_view word = take_until(rest, " ");
        if (word == "text")
            options.form = ManualForm::text;
        else if (word == "roff")
            options.form = ManualForm::roff;
        else if (word == "json")
            options.form = ManualForm::json;
        else
            options.topic = word;
    }
}

void store::version(Options& options, const Given&, Diagnostics&) { options.task = Task::version; }

void store::layers(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (const auto layers = read_layer_list(*given.value)) {
        options.layers = *layers;
        return;
    }
    std::string known;
    for (const LayerInfo& info : all_layers()) known += message(info.name, ", ");
    refuse(given, diagnostics, "a layer has none of these names", known + "all");
}

void store::frames(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (auto numbers = frame_list(*given.value))
        options.animation.chosen = std::move(*numbers);
    else
        refuse(given, diagnostics, "needs numbers of frames, and ranges of them", "3,7,12-20,9-5");
}

void store::preview(Options& options, const Given& given, Diagnostics& diagnostics) {
    const auto port = number(*given.value);
    if (!port || *port < 0 || *port > 65535 || *port != static_cast<int>(*port))
        return refuse(given, diagnostics, "a port is a number from 0 to 65535");
    if (options.task != Task::render) return refuse(given, diagnostics, shown_only);
    options.preview_port = static_cast<int>(*port);
}

}  // namespace candelabra
