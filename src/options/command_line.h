// SPDX-License-Identifier: GPL-3.0-or-later
// The command that makes a picture again, as pictures record it. It is made from the effective
// options, so it is the same whether they were given in INI files, or as shards of a farm.
#pragma once

#include "options/options.h"

#include <string>

namespace candelabra {

/// Whether the picture decides how many samples each pixel gets, by the options of antialiasing.
bool samples_are_adaptive(const Options&);

/// Returns one line for the shell, with the scene's name without its folder. It has all options
/// that change the light of the pixels, by the table of options. So it lacks threads, names of
/// outputs, limits, permissions and parts of a farm.
std::string command_line(const Options&);

/// Returns the options with which the command makes a file of this format, each after a blank.
std::string format_options(const PictureFormat&);

/// Returns a text that ends in a command of a picture, so that the command makes a file of this
/// format.
std::string command_for(std::string command, const PictureFormat&);

}  // namespace candelabra
