// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command_line.h"

#include "options/option_table.h"
#include "options/option_values.h"
#include "text/message.h"
#include "text/shell_word.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace candelabra {

namespace {

/// A name that looks like an option needs the switch +I.
std::string scene_word(const std::string& scene) {
    const std::string name = std::filesystem::path(scene).filename().string();
    const bool plain = scene == "-" || (name.find('=') == name.npos && !name.starts_with('-') &&
                                        !name.starts_with('+'));
    return message(plain ? "" : "+I", name);
}

/// Whether the option has a part in what is made.
bool counts(const OptionRow& row, const Options& options) {
    // A command names the size even if it is the usual one.
    if (row.field == "width" || row.field == "height") return true;
    return is_changed(row, options) &&
           (row.changes != Changes::adaptive || samples_are_adaptive(options));
}

template <class Wanted>
std::string words(const Options& options, const Wanted& wanted) {
    std::string text;
    for (const OptionRow& row : option_table()) {
        if (!wanted(row.changes) || !counts(row, options)) continue;
        for (const std::string& value : values_in_force(row, options))
            for (const std::string& word : words_of(row, value))
                text += message(' ', shell_word(word));
    }
    return text;
}

/// Whether a word of a command says the format of the file.
bool says_format(std::string_view word) {
    return std::ranges::any_of(option_table(), [&](const OptionRow& row) {
        if (row.changes != Changes::format) return false;
        return (!row.letters.empty() && word.starts_with(message('+', row.letters))) ||
               (!row.keyword.empty() && word.starts_with(message(row.keyword, '=')));
    });
}

}  // namespace

bool samples_are_adaptive(const Options& options) {
    const RenderSettings& settings = options.render;
    return settings.antialias && settings.samples == 0 && settings.noise == 0 && !options.time;
}

std::string command_line(const Options& options) {
    std::string text = message("candelabra ", shell_word(scene_word(options.scene.value_or("-"))),
                               words(options, [](Changes changes) {
                                   return changes != Changes::none && changes != Changes::format;
                               }));
    const RunFacts& facts = options.facts;
    if (facts.initial_frame != 0 || facts.final_frame != 0)
        text += message(" --frames ", facts.frame_number);
    return text;
}

std::string command_for(std::string command, const PictureFormat& format) {
    for (std::size_t blank; (blank = command.rfind(' ')) != command.npos &&
                            says_format(std::string_view(command).substr(blank + 1));)
        command.erase(blank);
    return command + format_options(format);
}

std::string format_options(const PictureFormat& format) {
    Options options;
    options.type = format.type;
    options.bits = format.bits;
    options.compressed = format.compressed;
    options.grey = format.grey;
    return words(options, [](Changes changes) { return changes == Changes::format; });
}

}  // namespace candelabra
