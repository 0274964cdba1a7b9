// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/show_files.h"

#include "options/option_store.h"
#include "relight/channels.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

constexpr auto most_show_bytes = static_cast<std::size_t>(std::min(
    std::uint64_t{1} << 33, std::uint64_t{std::numeric_limits<std::size_t>::max()}));

/// Reads shows of channels.
class ChannelReader {
public:
    ChannelReader(const ShowFiles& files, Options& options, Diagnostics& diagnostics)
        : files_(files), options_(options), diagnostics_(diagnostics) {}

    /// Returns null after an error has been reported.
    std::unique_ptr<ShowFrames> frames(const LampNames& names) {
        const auto curve = ChannelCurve::of(files_.curve.empty() ? "linear" : files_.curve);
        if (!curve)
            return fail(message("`--curve ", printable(files_.curve), "` is no curve"),
                        "--curve linear, square, or an exponent such as 2.2");
        auto data = files_.fseq.empty() ? raw() : fseq();
        if (!data) return nullptr;
        const auto patch = patch_for(names, data->channels);
        return patch ? channel_frames(std::move(*data), *patch, *curve) : nullptr;
    }

private:
    std::nullptr_t fail(std::string text, std::string help = {}) {
        diagnostics_.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
        return nullptr;
    }

    std::optional<std::string> content(const std::string& path) {
        auto bytes = content_of_file(path, most_show_bytes);
        if (!bytes) fail(message("`", printable(path), "` cannot be read"));
        return bytes;
    }

    std::optional<ChannelData> fseq() {
        const auto bytes = content(files_.fseq);
        if (!bytes) return std::nullopt;
        std::string problem, way_out;
        auto data = read_fseq(*bytes, problem, way_out);
        if (!data) fail(message("`", printable(files_.fseq), "` ", problem), way_out);
        constexpr double second = 1000;
        if (data && data->step > 0 && !is_given(options_, "frame-rate"))
            options_.frame_rate = second / data->step;
        return data;
    }

    std::optional<ChannelData> raw() {
        constexpr double most = 1 << 24;
        const auto channels = number(files_.channels);
        if (!channels || *channels < 1 || *channels > most || *channels != std::floor(*channels)) {
            fail("`--raw` needs the number of channels in a frame", "--channels 512");
            return std::nullopt;
        }
        auto bytes = content(files_.raw);
        if (!bytes) return std::nullopt;
        ChannelData data;
        data.channels = static_cast<std::uint32_t>(*channels);
        const std::size_t frames = bytes->size() / data.channels;
        if (frames == 0 || bytes->size() % data.channels != 0 || frames > most_show_frames) {
            fail(message("`", printable(files_.raw), "` has ", bytes->size(),
                         " bytes, which are no frames of ", data.channels, " channels"));
            return std::nullopt;
        }
        data.bytes = std::move(*bytes);
        return data;
    }

    std::optional<std::vector<PatchedLamp>> patch_for(const LampNames& names,
                                                      std::uint32_t channels) {
        if (!files_.patch.empty()) {
            const auto text = content(files_.patch);
            if (!text) return std::nullopt;
            return patch_of_table(*text, files_.patch, names, diagnostics_);
        }
        auto patch = usual_patch(names.lamps(), channels);
        if (!patch)
            fail(message("a frame has ", channels, channels == 1 ? " channel" : " channels",
                         ", which is neither one nor three for each of ", names.lamps().size(),
                         names.lamps().size() == 1 ? " lamp" : " lamps"),
                 "--patch patch.csv says which lamps hang on which channels");
        return patch;
    }

    const ShowFiles& files_;
    Options& options_;
    Diagnostics& diagnostics_;
};

}  // namespace

std::vector<std::string> ShowFiles::paths() const {
    std::vector<std::string> made;
    for (const std::string& file : {table, fseq, raw, patch})
        if (!file.empty()) made.push_back(file);
    return made;
}

bool take_show_option(std::string_view option, std::string value, ShowFiles& files) {
    if (option == "--set") {
        files.settings.push_back(std::move(value));
        return true;
    }
    const std::array<std::pair<std::string_view, std::string*>, 6> all = {{
        {"--csv", &files.table},
        {"--fseq", &files.fseq},
        {"--raw", &files.raw},
        {"--channels", &files.channels},
        {"--patch", &files.patch},
        {"--curve", &files.curve},
    }};
    const auto found =
        std::ranges::find(all, option, &std::pair<std::string_view, std::string*>::first);
    if (found == all.end()) return false;
    *found->second = std::move(value);
    return true;
}

bool read_show(const ShowFiles& files, LightShow& show, Options& options,
               Diagnostics& diagnostics) {
    const auto fail = [&](const char* text, const char* help) {
        diagnostics.add(error(Fault::option, {}, text).with_help(help));
        return false;
    };
    for (const std::string& setting : files.settings)
        if (!show.set(setting, diagnostics)) return false;
    const int shows =
        (files.table.empty() ? 0 : 1) + (files.fseq.empty() ? 0 : 1) + (files.raw.empty() ? 0 : 1);
    if (shows > 1) return fail("a show comes from one file", "--csv, --fseq or --raw");
    const bool of_channels = !files.fseq.empty() || !files.raw.empty();
    if (!of_channels && (!files.patch.empty() || !files.curve.empty()))
        return fail("a patch and a curve belong to channels", "--fseq show.fseq, or --raw bytes");
    if (files.raw.empty() && !files.channels.empty())
        return fail("`--channels` belongs to bare bytes", "--raw show.bin --channels 512");
    if (shows == 0) return true;
    auto frames = of_channels
                      ? ChannelReader(files, options, diagnostics).frames(show.names())
                      : read_show_table(files.table, show.names(), options.frame_rate, diagnostics);
    if (!frames) return false;
    show.set(std::move(frames));
    return true;
}

}  // namespace candelabra
