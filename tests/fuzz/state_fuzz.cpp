// SPDX-License-Identifier: GPL-3.0-or-later
// A state whose bytes are changed: any bytes as a file, or changes (place and value, three bytes
// each) of a sound one. No crash; what is read fits together.
#include "fuzz/target.h"
#include "fuzz/written_file.h"
#include "production/checkpoint.h"

#include <cstdlib>

using namespace candelabra;

namespace {

const std::string& sound() {
    static const std::string bytes = [] {
        RenderSettings settings;
        settings.width = 5;
        settings.height = 3;
        Checkpoint checkpoint{
            {{"program", "x"}, {"file a.pov", "12"}}, begin_picture(settings, 1), 3, 9, true};
        for (PixelSum& pixel : checkpoint.state.film.pixels()) pixel.add(Rgb(0.25, 1, 7));
        Diagnostics diagnostics;
        const auto made = encode(checkpoint, diagnostics);
        if (!made) std::abort();
        return *made;
    }();
    return bytes;
}

std::string changed(const std::uint8_t* data, std::size_t size) {
    std::string bytes = sound();
    for (; size >= 3; data += 3, size -= 3)
        bytes[(data[0] + 256u * data[1]) % bytes.size()] = static_cast<char>(data[2]);
    return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string bytes = data[0] % 2
                                  ? changed(data + 1, size - 1)
                                  : std::string(reinterpret_cast<const char*>(data) + 1, size - 1);
    const WrittenFile file(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(),
                           std::string(state_ending));
    Diagnostics diagnostics;
    const auto read = read_checkpoint(file.path(), diagnostics);
    if (!read) return 0;
    const Film& film = read->state.film;
    const auto pixels =
        static_cast<std::size_t>(film.width()) * static_cast<std::size_t>(film.height());
    if (film.pixels().size() != pixels) std::abort();
    film.image();
    return 0;
}
