// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/channels.h"

#include "base/elementary.h"
#include "interpret/csv.h"
#include "text/ascii.h"
#include "text/decimal.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

constexpr std::uint8_t no_channel = 0xFF;

/// The places of red, green, blue and white in an order such as GRB. Nothing if it is none.
std::optional<std::array<std::uint8_t, 4>> places_in(std::string_view order) {
    constexpr std::string_view colours = "rgbw";
    std::array<std::uint8_t, 4> places = {no_channel, no_channel, no_channel, no_channel};
    const std::string letters = lower_case(std::string(order));
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const std::size_t colour = colours.find(letters[i]);
        if (colour == colours.npos || places[colour] != no_channel) return std::nullopt;
        places[colour] = static_cast<std::uint8_t>(i);
    }
    const bool all = letters.size() >= 3 && places[0] != no_channel && places[1] != no_channel &&
                     places[2] != no_channel;
    return all || letters == "w" ? std::optional(places) : std::nullopt;
}

/// Reads the rows of a patch.
class PatchReader {
public:
    PatchReader(const CsvTable& table, const std::string& path, const LampNames& names,
                Diagnostics& diagnostics)
        : table_(table), path_(path), names_(names), diagnostics_(diagnostics) {}

    std::optional<std::vector<PatchedLamp>> read() {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const auto found = std::ranges::find_if(table_.names, [&](const std::string& name) {
                return lower_case(name) == columns[i];
            });
            if (found == table_.names.end()) return fail("has no column `", columns[i], "`");
            column_[i] = static_cast<std::size_t>(found - table_.names.begin());
        }
        for (std::size_t row = 0; row < table_.rows; ++row)
            if (!add(row)) return std::nullopt;
        return std::move(made_);
    }

private:
    static constexpr std::array<std::string_view, 3> columns = {"lamp", "channel", "order"};

    const std::string& cell(std::size_t row, std::size_t which) const {
        return table_.cells[row * table_.columns + column_[which]];
    }

    template <class... Parts>
    std::nullopt_t fail(const Parts&... parts) {
        diagnostics_.add(error(Fault::option, {}, message("`", printable(path_), "` ", parts...))
                             .with_help("lamp,channel,order, and rows such as Bulb[0..99],1,GRB"));
        return std::nullopt;
    }

    bool add(std::size_t row) {
        const auto lamps = names_.chosen(cell(row, 0), diagnostics_);
        if (!lamps) return false;
        const auto channel = finite_number(cell(row, 1));
        constexpr double most = 1 << 24;
        const auto places = places_in(cell(row, 2));
        if (!channel || *channel < 1 || *channel > most || *channel != std::floor(*channel))
            fail("has the channel `", printable(cell(row, 1)), "` in row ", row + 1);
        else if (!places)
            fail("has the order `", printable(cell(row, 2)), "` in row ", row + 1);
        if (diagnostics_.failed()) return false;
        const auto count = static_cast<std::uint32_t>(cell(row, 2).size());
        auto first = static_cast<std::uint32_t>(*channel) - 1;
        for (const std::uint32_t lamp : *lamps) {
            made_.push_back({lamp, first, *places});
            first += count;
        }
        return true;
    }

    const CsvTable& table_;
    const std::string& path_;
    const LampNames& names_;
    Diagnostics& diagnostics_;
    std::array<std::size_t, 3> column_{};
    std::vector<PatchedLamp> made_;
};

class ChannelFrames final : public ShowFrames {
public:
    ChannelFrames(ChannelData data, const std::vector<PatchedLamp>& patch,
                  const ChannelCurve& curve)
        : data_(std::move(data)) {
        constexpr double full = 255;
        for (std::size_t i = 0; i < light_.size(); ++i)
            light_[i] = math::pow(static_cast<double>(i) / full, curve.exponent);
        light_[0] = 0;
        for (const PatchedLamp& lamp : patch) {
            Wire wire{lamp.lamp, {}};
            for (std::size_t c = 0; c < wire.at.size(); ++c)
                wire.at[c] =
                    lamp.place[c] == no_channel ? unwired : stored(lamp.channel + lamp.place[c]);
            const bool there = std::ranges::any_of(wire.at, [](auto at) { return at != unwired; });
            if (there) wires_.push_back(wire);
        }
    }

    std::size_t count() const override { return data_.frames(); }

    void set(std::size_t frame, std::vector<Rgb>& factors) const override {
        const char* const values = data_.bytes.data() + frame * data_.channels;
        const auto light = [&](std::uint32_t at) {
            return at == unwired ? 0.0 : light_[static_cast<unsigned char>(values[at])];
        };
        for (const Wire& wire : wires_)
            factors[wire.lamp] = Rgb(light(wire.at[0]), light(wire.at[1]), light(wire.at[2])) +
                                 Rgb(light(wire.at[3]));
    }

private:
    static constexpr std::uint32_t unwired = ~std::uint32_t{0};

    /// A lamp, and where the values of its red, green, blue and white stand in a frame.
    struct Wire {
        std::uint32_t lamp;
        std::array<std::uint32_t, 4> at;
    };

    /// Where a channel stands in a frame.
    std::uint32_t stored(std::uint32_t channel) const {
        if (data_.ranges.empty()) return channel < data_.channels ? channel : unwired;
        std::uint32_t before = 0;
        for (const auto& [first, count] : data_.ranges) {
            if (first <= channel && channel - first < count) return before + channel - first;
            before += count;
        }
        return unwired;
    }

    ChannelData data_;
    std::array<double, 256> light_{};
    std::vector<Wire> wires_;
};

}  // namespace

std::optional<ChannelCurve> ChannelCurve::of(std::string_view text) {
    if (text == "linear") return ChannelCurve{1};
    if (text == "square") return ChannelCurve{2};
    constexpr double least = 0.1, most = 10;
    const auto exponent = finite_number(text);
    if (!exponent || *exponent < least || *exponent > most) return std::nullopt;
    return ChannelCurve{*exponent};
}

std::optional<std::vector<PatchedLamp>> usual_patch(const LampList& lamps, std::uint32_t channels) {
    // Programs fill a frame up to a multiple of four channels.
    const auto fits = [&](std::uint64_t wanted) {
        return wanted > 0 && (channels == wanted || channels == (wanted + 3) / 4 * 4);
    };
    const std::uint64_t count = lamps.size();
    const bool coloured = channels != count && fits(3 * count);
    if (!coloured && !fits(count)) return std::nullopt;
    const auto places = *places_in(coloured ? "rgb" : "w");
    const std::uint32_t each = coloured ? 3 : 1;
    std::vector<PatchedLamp> patch;
    std::uint32_t channel = 0;
    for (std::size_t group = 0; group < lamps.groups().size(); ++group)
        for (std::uint32_t i = 0; i < lamps.groups()[group].lamps; ++i) {
            patch.push_back({lamps.place_of(group, i), channel, places});
            channel += each;
        }
    return patch;
}

std::optional<std::vector<PatchedLamp>> patch_of_table(std::string_view text,
                                                       const std::string& path,
                                                       const LampNames& names,
                                                       Diagnostics& diagnostics) {
    CsvForm form;
    form.header = CsvForm::Header::there;
    form.text = true;
    CsvProblem problem;
    constexpr std::size_t most_cells = 10'000'000;
    const auto table = read_csv(text, form, most_cells, problem);
    if (table) return PatchReader(*table, path, names, diagnostics).read();
    diagnostics.add(error(Fault::option, {},
                          message("`", printable(path), "` ",
                                  problem.too_many ? "has too many cells" : problem.message))
                        .with_help("lamp,channel,order, and rows such as Bulb[0..99],1,GRB"));
    return std::nullopt;
}

std::unique_ptr<ShowFrames> channel_frames(ChannelData data, const std::vector<PatchedLamp>& patch,
                                           const ChannelCurve& curve) {
    return std::make_unique<ChannelFrames>(std::move(data), patch, curve);
}

}  // namespace candelabra
