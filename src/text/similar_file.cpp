// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/similar_file.h"

#include "text/ascii.h"
#include "text/nearest.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

/// Returns the letters and digits of a name in lower case, the part that people remember.
std::string gist(std::string_view name) {
    std::string result;
    for (const char letter : name) {
        const char c = lower_case(letter);
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80)) result += c;
    }
    return result;
}

std::string stem(const std::string& name) { return name.substr(0, name.rfind('.')); }

/// Returns the part after the last point in lower case; empty for a name without one.
std::string extension(const std::string& name) {
    return name.find('.') == std::string::npos ? "" : gist(name.substr(name.rfind('.')));
}

std::string joined(const std::string& folder, const std::string& name) {
    const bool needs_slash = !folder.empty() && !folder.ends_with('/') && !name.empty();
    return needs_slash ? folder + '/' + name : folder + name;
}

/// The name in a folder that resembles the wanted one; the lower the rank the better, 0 is
/// equality.
struct Likeness {
    int rank = 5;
    std::string name;
};

Likeness max_like(const std::string& wanted, const std::vector<std::string>& names) {
    Likeness best;
    const auto offer = [&](int rank, const std::string& name) {
        if (rank < best.rank) best = {rank, name};
    };
    for (const std::string& name : names) {
        if (name == wanted) offer(0, name);
        if (gist(wanted).empty()) continue;
        if (gist(name) == gist(wanted)) offer(1, name);
        if (stem(name) == wanted) offer(2, name);
        if (gist(stem(name)) == gist(stem(wanted))) offer(3, name);
    }
    // A name that is only similar must have the wanted extension: a scene is not meant by a
    // picture's.
    std::vector<std::string> stems;
    std::vector<std::size_t> whose;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (extension(wanted).empty() || extension(names[i]) == extension(wanted)) {
            stems.push_back(stem(names[i]));
            whose.push_back(i);
        }
    const std::string near = nearest(stem(wanted), {stems.begin(), stems.end()});
    const auto found = std::find(stems.begin(), stems.end(), near);
    if (!near.empty()) offer(4, names[whose[static_cast<std::size_t>(found - stems.begin())]]);
    return best;
}

/// Returns the entries of one kind, folders without their `/`.
std::vector<std::string> entries(const std::string& folder, bool folders, const Lister& list) {
    std::vector<std::string> result;
    for (std::string& name : list(folder)) {
        if (name.ends_with('/') != folders) continue;
        if (folders) name.pop_back();
        result.push_back(std::move(name));
    }
    return result;
}

/// Returns the path below the folder whose parts resemble the wanted ones most, with the worst
/// rank.
Likeness follow(const std::string& folder, std::string wanted, const Lister& list) {
    std::string path;
    int worst = 0;
    for (std::size_t slash; (slash = wanted.find('/')) != std::string::npos;) {
        std::string part = wanted.substr(0, slash);
        wanted.erase(0, slash + 1);
        if (part.empty() || part == ".") continue;
        if (part != "..") {
            const std::vector<std::string> folders = entries(joined(folder, path), true, list);
            // A folder that cannot be listed may still lead to one that can.
            Likeness found = folders.empty() ? Likeness{0, part} : max_like(part, folders);
            worst = std::max(worst, found.rank);
            part = std::move(found.name);
            if (part.empty()) return {};
        }
        path = joined(path, part);
    }
    const Likeness found = max_like(wanted, entries(joined(folder, path), false, list));
    if (found.name.empty()) return {};
    return {std::max(worst, found.rank), joined(path, found.name)};
}

}  // namespace

Lister disk_lister() {
    return [](const std::string& folder) {
        std::vector<std::string> names;
        std::error_code failed;
        for (fs::directory_iterator entry(folder.empty() ? "." : folder, failed), end;
             !failed && entry != end; entry.increment(failed)) {
            std::error_code unknown;
            names.push_back(entry->path().filename().string() +
                            (entry->is_directory(unknown) ? "/" : ""));
        }
        std::sort(names.begin(), names.end());
        return names;
    };
}

std::string similar_file(const std::string& name, const std::vector<std::string>& folders,
                         const Lister& list) {
    std::string wanted = name;
    std::replace(wanted.begin(), wanted.end(), '\\', '/');
    if (wanted.starts_with('/')) {
        const std::string path = follow("/", wanted, list).name;
        return path.empty() ? path : '/' + path;
    }
    Likeness best;
    for (const std::string& folder : folders) {
        const Likeness found = follow(folder, wanted, list);
        if (found.rank < best.rank) best = found;
    }
    return best.name;
}

}  // namespace candelabra
