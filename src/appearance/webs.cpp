// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/webs.h"

#include "appearance/model_files.h"
#include "photometry/photometric_file.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>

namespace candelabra {

namespace {

constexpr std::size_t most_named_repairs = 3;

/// Warns of what has been read otherwise than it is written.
void warn_of_repairs(OpenBlock& block, std::string_view name, const PhotometricFile& file) {
    std::vector<std::string> notes = file.notes;
    if (file.tilt && !file.tilt->follows_aim())
        notes.emplace_back(
            "its intensities change with the position of a horizontal lamp, which is not followed");
    if (notes.empty()) return;
    std::string all;
    for (std::size_t i = 0; i < notes.size() && i < most_named_repairs; ++i)
        all += message(i > 0 ? "; " : "", notes[i]);
    const std::size_t more = notes.size() - std::min(notes.size(), most_named_repairs);
    block.report(warning(Fault::no_effect, block.file_place(),
                         message("`", name, "`: ", all,
                                 more > 0 ? message("; and ", more, " more") : std::string()))
                     .with_help(message("candelabra light ", name, " describes it")));
}

}  // namespace

LoadedWeb read_web(OpenBlock& block, std::string_view name, std::string_view bytes, int lamp_set,
                   std::string& wrong) {
    PhotometricFile file;
    PhotometricChoice choice;
    choice.set = static_cast<std::size_t>(lamp_set - 1);
    wrong = read_photometric(bytes, choice, file);
    if (!wrong.empty()) return {};
    warn_of_repairs(block, name, file);
    LoadedWeb made{make_handle<PhotometricWeb>(std::move(file.web))};
    if (file.tilt) made.tilt = make_handle<LampTilt>(std::move(*file.tilt));
    return made;
}

void load_web(OpenBlock& block, WebPlace& place) {
    if (place.file().empty()) return;
    Evaluator& evaluator = block.binder.evaluator;
    const std::string name = printable(place.file());
    place.per_candela = evaluator.use_light_units().intensity(place.multiplier);
    const std::string key =
        place.profile ? message(place.file(), ", profile ", *place.profile) : place.file();
    auto& known = block.binder.webs[{key, place.lamp_set}];
    if (!known.web) {
        std::optional<std::string> bytes;
        if (!place.profile)
            bytes = evaluator.load_data(place.file(), block.file_place());
        else if (auto found = profile_of_model(block, place.file(), *place.profile))
            bytes = std::move(found->text);
        if (!bytes) {
            block.broken = true;
            return;
        }
        std::string wrong;
        known = read_web(block, name, *bytes, place.lamp_set, wrong);
        if (!known.web) {
            block.report(error(Fault::syntax, block.file_place(), message("`", name, "`: ", wrong))
                             .with_help(message("candelabra light ", name, " reads it alone")));
            return;
        }
    }
    static_cast<LoadedWeb&>(place) = known;
    if (!has_axes(place))
        block.report(error(Fault::degenerate, block.span,
                           "`aim` and `c0` of a photometric file must be two directions")
                         .with_help("light_source { 2*y ies \"lamp.ies\" aim -y c0 x }"));
}

bool LampReader::take(const Element& element) {
    if (element.kind != Element::Kind::block || block_.spelling(element.word) != "luminaire")
        return false;
    OpenBlock inner(block_.binder, "luminaire", element.word_span);
    inner.item = &LampData::vocabulary;
    LampData made = lamp_ ? *lamp_ : LampData();
    ItemReader fields(inner, *inner.item, &made);
    inner.read(element.body, fields);
    if (!inner.broken) load_web(inner, made);
    if (!inner.broken && !made.has_flux() && !made.temperature)
        inner.report(warning(Fault::no_effect, element.word_span,
                             "this `luminaire` is empty: it has no flux, no temperature and no "
                             "file")
                         .with_help("luminaire { flux lumen(800) temperature 2700 }"));
    block_.broken |= inner.broken;
    lamp_ = make_handle<LampData>(std::move(made));
    given_ = true;
    return true;
}

}  // namespace candelabra
