// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra develop` with any options of films, on any bytes as an OpenEXR file or on a sound file
// with any numbers in it: no crash, and a picture where the program says that it has made one.
#include "app/develop_command.h"
#include "fuzz/target.h"
#include "fuzz/written_file.h"
#include "picture/layers.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

using namespace candelabra;

namespace {

/// Options that name no file and no number of threads.
bool is_harmless(std::string_view word) {
    static constexpr auto prefixes = std::to_array<std::string_view>(
        {"--film", "--exposure", "--white", "--response", "--pixel", "--smooth", "--glare",
         "--vignette", "--grain", "--layer", "+F",
         "Bits_Per_Color=", "Grayscale_Output=", "File_Gamma="});
    return (word.find('=') != word.npos || word.starts_with("+F")) &&
           std::ranges::any_of(prefixes, [&](auto each) { return word.starts_with(each); });
}

std::string_view take(std::string_view& rest, char mark) {
    const std::size_t end = std::min(rest.find(mark), rest.size());
    const std::string_view taken = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return taken;
}

/// The bytes as the numbers of pixels, in as many planes as there are for.
std::string sound_file(std::string_view film, std::string_view numbers) {
    static constexpr std::array names = {"R", "G", "B", "A", "film.R", "film.G", "film.B", "Y"};
    LayeredPicture picture;
    const auto byte = [&](std::size_t i) {
        return i < numbers.size() ? static_cast<unsigned char>(numbers[i]) : 0;
    };
    picture.width = 1 + byte(0) % 16;
    picture.height = 1 + byte(1) % 16;
    picture.texts.emplace_back("candelabraFilm", film);
    const auto pixels =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    std::vector<std::uint32_t> bits(pixels);
    constexpr std::size_t head = 3;
    for (std::size_t plane = 0; plane < names.size(); ++plane) {
        if (plane >= 3 && (byte(2) >> plane & 1) == 0) continue;
        for (std::size_t i = 0; i < pixels && numbers.size() > head + 4; ++i) {
            const std::size_t at = (plane * pixels + i) * 4 % (numbers.size() - head - 4);
            std::memcpy(&bits[i], numbers.data() + head + at, 4);
        }
        picture.planes.push_back({names[plane], false, bits});
    }
    Diagnostics diagnostics;
    return encode(picture, diagnostics).value_or("");
}

/// Whether there was one beside the light.
bool remove_pictures(const std::string& exr) {
    bool any = false;
    for (const PictureType type : {PictureType::png, PictureType::ppm, PictureType::tga,
                                   PictureType::jpeg, PictureType::bmp}) {
        auto path = std::filesystem::path(exr).replace_extension(extension(type));
        any |= std::filesystem::remove(path);
    }
    return any;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
    std::string_view lines = take(rest, '\0');
    std::string bytes;
    if (data[0] % 2 == 1) {
        const std::string_view film = take(rest, '\0');
        bytes = sound_file(film, rest);
    } else {
        bytes = rest;
    }
    const WrittenFile file(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(),
                           ".exr");
    std::vector<std::string_view> words = {file.path()};
    while (!lines.empty())
        if (const auto word = take(lines, '\n'); is_harmless(word)) words.push_back(word);
    Console console;
    console.out = console.err = [](std::string_view) {};
    const int status = run_develop(words, console);
    if (remove_pictures(file.path()) != (status == exit_status::done)) std::abort();
    return 0;
}
