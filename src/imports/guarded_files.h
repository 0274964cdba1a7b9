// SPDX-License-Identifier: GPL-3.0-or-later
// The files that Assimp sees: the model itself, and what lies beside it, through a function of the
// program. It opens no file by itself and writes none. Called by importer.cpp.
#pragma once

#include "imports/imported_model.h"

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include <algorithm>
#include <functional>
#include <map>

namespace candelabra {

class GuardedFiles : public Assimp::IOSystem {
public:
    /// `bytes` and `beside` outlive the object.
    GuardedFiles(std::string_view name, std::string_view bytes, const BesideModel& beside)
        : name_(name), bytes_(bytes), beside_(beside) {}

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* file) override { delete file; }
    bool ComparePaths(const char* one, const char* second) const override;

    /// Whether the model has asked for a file that is not there.
    bool misses() const {
        return std::ranges::any_of(files_, [](const auto& each) { return !each.second.is_there; });
    }

private:
    /// The bytes of a file; null if there is none. Each file is asked for once.
    const std::string_view* find(const char* name) const;

    std::string name_;
    std::string_view bytes_;
    const BesideModel& beside_;
    struct File {
        bool is_there = false;
        std::string text;
        std::string_view bytes;
    };
    mutable std::map<std::string, File, std::less<>> files_;
};

}  // namespace candelabra
