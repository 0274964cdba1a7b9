// SPDX-License-Identifier: GPL-3.0-or-later
// How the rows of the table of options are written. Only the table and its parts include it.
#pragma once

#include "options/command_settings.h"
#include "options/console_options.h"
#include "options/option_row.h"
#include "options/stream_settings.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra::option_rows {

using enum Takes;
using enum Changes;

using Store = void (*)(Options&, const Given&, Diagnostics&);
using Values = std::vector<std::string> (*)(const Options&);
using Term = std::string_view;

/// The rows behind this one belong to the group. It is no option.
constexpr OptionRow begin(OptionGroup group) {
    OptionRow row{};
    row.group = group;
    return row;
}

/// An option that the short help lists.
constexpr OptionRow basic(OptionRow row) {
    row.basic = true;
    return row;
}

/// Returns a row whose value is stored in the setting with that name and documented by it.
constexpr OptionRow setting(Changes changes, Term letters, Term keyword, Term word, Term field) {
    return {letters, keyword, word, "n", value, {}, changes, field};
}

/// Returns a row for a setting that is on or off.
constexpr OptionRow option_field(Changes changes, Term letters, Term keyword, Term word,
                                 Takes takes, Term field) {
    return {letters, keyword, word, "", takes, {}, changes, field};
}

/// Returns a row for a switch that may be followed by a number, stored in the next setting.
constexpr OptionRow switched(Changes changes, Term letters, Term keyword, Term parameter,
                             Term field) {
    return {letters, keyword, "", parameter, sign_and_value, {}, changes, field};
}

/// `values`: what is in force, of an option that changes something.
constexpr OptionRow option(Changes changes, Term letters, Term keyword, Term word, Takes takes,
                           Term parameter, Store store, Term help, Values values = nullptr) {
    return {letters, keyword, word, parameter, takes, help, changes, {}, {}, store, values};
}

/// `values`: what is in force, if that is not simply the value that was given.
constexpr OptionRow option(Changes changes, Term letters, Term keyword, Term word, Takes takes,
                           Term parameter, OptionField own, Term help, Values values = nullptr) {
    return {letters, keyword, word, parameter, takes, help, changes, {}, own, nullptr, values};
}

/// A limit of the scene or the run. `then` adapts what depends on it.
constexpr OptionRow limit(Term word, Term parameter, OptionField own, Term help,
                          void (*then)(Options&) = nullptr) {
    own.then = then;
    return option(none, "", "", word, value, parameter, own, help);
}

constexpr OptionRow that(Touches touches, OptionRow row) {
    row.touches = touches;
    return row;
}

template <Stream which>
constexpr OptionRow stream(Term letters, Term keyword, Term help) {
    return that(Touches::writes, option(none, letters, keyword, "", sign_and_value, "file",
                                        store::stream_switch<which>, help));
}

template <Stream which>
constexpr OptionRow stream_file(Term keyword, Term help) {
    return that(Touches::writes,
                option(none, "", keyword, "", value, "file", store::stream_file<which>, help));
}

/// The keyword of each command that an action may follow.
template <Moment moment>
inline constexpr std::string_view command_keyword = [] {
    switch (moment) {
        case Moment::pre_scene:
            return "Pre_Scene_Command";
        case Moment::pre_frame:
            return "Pre_Frame_Command";
        case Moment::post_frame:
            return "Post_Frame_Command";
        case Moment::post_scene:
            return "Post_Scene_Command";
        case Moment::user_abort:
            return "User_Abort_Command";
        case Moment::fatal_error:
            return "Fatal_Error_Command";
    }
    return "";
}();

/// The help on the action after a command.
template <Moment moment>
struct ReturnHelp {
    static constexpr std::string_view before = "action after a failed ";
    static constexpr std::string_view behind =
        ": I none, S skips the picture, A skips all pictures, Q ends the run, U aborts the run, F "
        "ends the run with an error; with a minus, as in -S: action after a success";
    static constexpr std::string_view keyword = command_keyword<moment>;
    static constexpr auto text = [] {
        std::array<char, before.size() + keyword.size() + behind.size()> all{};
        char* const end = std::ranges::copy(before, all.data()).out;
        std::ranges::copy(behind, std::ranges::copy(keyword, end).out);
        return all;
    }();
};

template <Moment moment>
constexpr OptionRow command(Term help) {
    return option(none, "", command_keyword<moment>, "", value, "command", store::command<moment>,
                  help);
}

template <Moment moment>
constexpr OptionRow command_return(Term keyword) {
    constexpr auto& text = ReturnHelp<moment>::text;
    return option(none, "", keyword, "", value, "action", store::command_return<moment>,
                  {text.data(), text.size()});
}

}  // namespace candelabra::option_rows
