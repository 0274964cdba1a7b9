// SPDX-License-Identifier: GPL-3.0-or-later
// The values of options in force, written as on a command line. The table of options refers to
// these functions. What identifies a picture, the command that makes it again, and an INI file of
// all options are made from them.
#pragma once

#include "options/film_options.h"
#include "options/options.h"

#include <string>
#include <vector>

namespace candelabra {

struct OptionRow;

/// Returns the values of a supported option in force, also if they are the usual ones. Empty: the
/// option is not given and has no usual value, or another row says its value.
std::vector<std::string> values_in_force(const OptionRow&, const Options&);

/// Whether the values differ from those of a run without options.
bool is_changed(const OptionRow&, const Options&);

/// Returns the option with a value as words of the command line: {"+W640"}, {"--seed", "5"}, {"-J"}
/// or {"Declare=A=1"}.
std::vector<std::string> words_of(const OptionRow&, const std::string& value);

/// Returns the option with a value as a line of an INI file: "Width=640", "--seed=5".
std::string ini_option(const OptionRow&, const std::string& value);

namespace in_force {

/// Nothing: the option has no part in the command, though it changes the file.
std::vector<std::string> unsaid(const Options&);
std::vector<std::string> type(const Options&);
std::vector<std::string> bits(const Options&);
std::vector<std::string> layers(const Options&);
std::vector<std::string> start_row(const Options&);
std::vector<std::string> end_row(const Options&);
std::vector<std::string> start_column(const Options&);
std::vector<std::string> end_column(const Options&);
std::vector<std::string> sampler(const Options&);
std::vector<std::string> integrator(const Options&);
/// The last change of that field of the film. Of a film that is off in the end, only that is in
/// force.
std::vector<std::string> film(const Options&, std::string_view field);
template <FilmField field>
std::vector<std::string> film(const Options& options) {
    return film(options, field.text.data());
}
std::vector<std::string> glare(const Options&);
/// Files and folders are named as from the folder of the scene, where the command is to be given.
std::vector<std::string> library(const Options&);
std::vector<std::string> first_libraries(const Options&);
std::vector<std::string> header(const Options&);
std::vector<std::string> declares(const Options&);
std::vector<std::string> clock(const Options&);
std::vector<std::string> luminaires(const Options&);
std::vector<std::string> gamma(const Options&);

}  // namespace in_force

}  // namespace candelabra
