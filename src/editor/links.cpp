// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/links.h"

#include "appearance/pictures.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

/// Words before the name of a file that is not a picture.
constexpr auto data_words = std::to_array<std::string_view>({"df3", "density_file", "file", "ttf"});
/// Blocks whose first string is the name of a picture.
constexpr auto picture_blocks = std::to_array<std::string_view>(
    {"bump_map", "height_field", "image_map", "image_pattern", "material_map"});
constexpr auto reading_functions =
    std::to_array<std::string_view>({"file_exists", "read_csv", "read_json"});

/// The kind of a file name, and the extensions that it may omit.
struct WrittenFile {
    FileKind kind = FileKind::data;
    std::span<const std::string_view> endings = {};
};

class Links {
public:
    Links(Workspace& workspace, const EditedFile& file) : file_(file) {
        // An include file's strings are looked up as by the open scenes that may include it.
        if (!file.path.ends_with(".pov"))
            for (const std::string& other : workspace.open_files())
                if (other.ends_with(".pov")) add_scene(workspace, other);
        add_scene(workspace, file.path);
    }

    std::vector<Link> operator()() const {
        std::vector<Link> found;
        for (std::size_t i = 1; i < file_.tokens.size(); ++i) {
            const Token& token = file_.tokens[i];
            if (token.kind != TokenKind::text || token.last - token.first < 3) continue;
            const auto written = written_file(i);
            auto path = written ? located(file_.values.texts[token.value], *written) : std::nullopt;
            if (path) found.push_back({{token.first + 1, token.last - 1}, std::move(*path)});
        }
        return found;
    }

private:
    void add_scene(Workspace& workspace, const std::string& scene) {
        const std::string folder = directory_of(scene);
        FileAccess access({workspace.library()}, {});
        access.reads(scene_folders(folder, {}));
        loaders_.push_back(workspace.loader(folder, access));
    }

    TokenKind kind(std::size_t i) const { return file_.tokens[i].kind; }
    std::string_view word(std::size_t i) const {
        return file_.part({file_.tokens[i].first, file_.tokens[i].last});
    }
    static bool is_one_of(std::span<const std::string_view> words, std::string_view word) {
        return std::ranges::find(words, word) != words.end();
    }

    /// Determines from the preceding tokens whether a string is a file name; returns nothing if
    /// not.
    std::optional<WrittenFile> written_file(std::size_t text) const {
        const TokenKind before = kind(text - 1);
        if (before == TokenKind::hash_include) return WrittenFile{FileKind::include};
        if (before == TokenKind::word || before == TokenKind::name) {
            const std::string_view name = word(text - 1);
            if (is_one_of(data_words, name)) return WrittenFile{};
            if (const auto endings = picture_endings(name); !endings.empty() || name == "sys")
                return WrittenFile{FileKind::data, endings};
        }
        if (text < 2) return std::nullopt;
        if (before == TokenKind::open_brace && is_one_of(picture_blocks, word(text - 2)))
            return WrittenFile{FileKind::data, picture_endings("")};
        if (before == TokenKind::open_parenthesis && is_one_of(reading_functions, word(text - 2)))
            return WrittenFile{};
        if (before == TokenKind::name && kind(text - 2) == TokenKind::hash_fopen)
            return WrittenFile{};
        return std::nullopt;
    }

    std::optional<std::string> located(const std::string& name, const WrittenFile& written) const {
        const std::string folder = directory_of(file_.path);
        for (const Loader& loader : loaders_) {
            if (auto path = loader.located(name, folder, written.kind)) return path;
            for (const std::string_view ending : written.endings)
                if (auto path = loader.located(name + std::string(ending), folder, written.kind))
                    return path;
        }
        return std::nullopt;
    }

    const EditedFile& file_;
    std::vector<Loader> loaders_;
};

}  // namespace

std::vector<Link> links(Workspace& workspace, const std::string& path) {
    const FileHandle file = workspace.file(path);
    return file ? Links(workspace, *file)() : std::vector<Link>();
}

}  // namespace candelabra
