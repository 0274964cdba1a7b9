// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what a dump has elsewhere than in its place: functions, for which written() has left
// marks, and textures of several layers in maps, whose entries have room for one.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

namespace candelabra {

class Formula;

class FunctionWriter {
public:
    /// What stands around a texture that is to be declared.
    static constexpr std::string_view texture_begin = "\3<", texture_end = "\3>";

    /// The text with each mark of a function replaced by `function { ... }`; literally so if the
    /// function has not kept its text. Textures are replaced by their names. Precondition: the
    /// functions still exist.
    std::string replaced(std::string_view text);
    /// Declarations of the textures, and of the functions that functions call, one on each line.
    const std::string& declarations() const { return declarations_; }

private:
    std::string written(const Formula&);
    std::string name_of(const Formula&);
    std::string with_functions(std::string_view text);
    std::string texture_name(std::string_view texture);

    std::unordered_map<const Formula*, std::string> names_;
    std::unordered_map<std::string, std::string> textures_;  ///< names by content
    std::string declarations_;
};

}  // namespace candelabra
