// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/assets.h"

#include "appearance/pictures.h"
#include "font/outlines.h"
#include "font/system_font.h"
#include "formula/formula.h"
#include "picture/heights.h"
#include "text/message.h"

#include <cmath>

namespace candelabra {

namespace {

std::string font_name(const Text& text) {
    if (!text.font.empty() || text.internal == 0) return text.font;
    switch (text.internal) {
        case 1:
            return "timrom.ttf";
        case 2:
            return "cyrvetic.ttf";
        case 3:
            return "crystal.ttf";
        default:
            return "povlogo.ttf";
    }
}

/// Folder of the library's own fonts, which replace fonts that are not installed.
constexpr std::string_view library_fonts = "fonts/";

/// The contents of a font file, which may also be one of the system's or the library's. Each font
/// is loaded once and kept as long as the binder. Returns null after a diagnostic.
const std::string* load_font(Binder& binder, const std::string& name, Span span) {
    const Evaluator& evaluator = binder.evaluator;
    const std::string directory = directory_of(binder.evaluator.sources().name(span.source));
    const std::pair key(directory, name);
    if (const auto known = binder.fonts.find(key); known != binder.fonts.end())
        return &known->second;
    const auto keep = [&](std::string font) {
        return &binder.fonts.emplace(key, std::move(font)).first->second;
    };
    const auto stands_in = [&](std::string_view other) {
        binder.evaluator.report(
            warning(Fault::unknown_name, span,
                    message("there is no font `", name, "`: `", other, "` stands in for it"))
                .with_help("POV-Ray's fonts are in Debian's package fonts-povray"));
    };
    for (const std::string& spelling : {name, name + ".ttf"})
        if (auto found = evaluator.loader().load(spelling, directory, FileKind::data))
            return keep(std::move(found->text));
    for (const std::string& spelling : {name, name + ".ttf"})
        if (auto found = system_font(spelling)) return keep(std::move(*found));
    for (const char* other : fonts_like(name))
        if (auto found = system_font(other)) {
            stands_in(other);
            return keep(std::move(*found));
        }
    for (const std::string& own :
         {message(library_fonts, name), message(library_fonts, name, ".ttf")})
        if (auto found = evaluator.loader().load(own, directory, FileKind::data)) {
            stands_in(own);
            return keep(std::move(found->text));
        }
    binder.evaluator.report(evaluator.loader().problem(name, span, FileKind::data, directory));
    return nullptr;
}

void complete_text(OpenBlock& block, Shared<Text>& text) {
    const std::string name = font_name(*text);
    if (name.empty() || text->text.empty()) return;
    const std::string* const font = load_font(block.binder, name, block.file_place());
    if (!font) {
        block.broken = true;
        return;
    }
    TextOutlines outlines = text_outlines(*font, text->text, Vec2(text->offset.x, text->offset.y));
    if (outlines.problem.empty()) {
        text.edit().letters = make_handle<Letters>(Letters{std::move(outlines.loops)});
        return;
    }
    block.report(error(Fault::file_access, block.file_place(),
                       message("the font `", name, "` cannot be used: ", outlines.problem)));
}

double grey(const FunctionResults& colour) {
    return 0.297 * colour[0] + 0.589 * colour[1] + 0.114 * colour[2];
}

/// Samples a function of x and y at all pixels. Returns null if that exceeds the work limit.
Handle<HeightGrid> sampled(const Formula& function, Evaluator& evaluator, Span place) {
    HeightGrid grid{function.columns(), function.rows(), {}};
    const auto take = [&](const FunctionResults& results, bool good) {
        // Values outside of 0 to 1 wrap around, as in POV-Ray.
        const double shown = function.results() < 3 ? results[0] : grey(results);
        const double value = good && std::abs(shown) < 1e9 ? shown : 0;
        grid.values.push_back(static_cast<std::uint16_t>(static_cast<std::int64_t>(65535 * value)));
    };
    const bool done = evaluator.sample(function, Evaluator::Rows::from_top, place, take);
    return done ? make_handle<HeightGrid>(std::move(grid)) : nullptr;
}

void complete_heights(OpenBlock& block, Shared<HeightField>& field) {
    constexpr std::size_t usual = 3;
    if (field->function && field->function->columns() > 0 &&
        field->function->parameters() <= usual) {
        field.edit().grid = sampled(*field->function, block.binder.evaluator, block.span);
        block.broken |= !field->grid;
        return;
    }
    if (field->function) {
        block.report(error(Fault::wrong_type, block.span,
                           "the function of a `height_field` needs the number of heights")
                         .with_help("function 256, 256 { ... }"));
        return;
    }
    if (field->file.empty()) return;
    field.edit().kind = std::string(block.file_kind);
    const auto file = block.binder.evaluator.find_data(field->file, block.file_place(),
                                                       picture_endings(block.file_kind));
    std::optional<Heights> heights;
    if (file)
        heights = read_heights(*file, field->gamma, block.binder.evaluator.diagnostics(),
                               block.file_place());
    if (heights && block.file_kind == "pot") heights = of_two_halves(*heights);
    block.broken |= !heights;
    if (heights)
        field.edit().grid = make_handle<HeightGrid>(
            HeightGrid{heights->width, heights->height, std::move(heights->values)});
}

/// Replaces accuracies and gradients that are not positive by the defaults.
void complete_isosurface(OpenBlock& block, Shared<Isosurface>& surface) {
    const Isosurface usual;
    const auto correct = [&](std::string_view word, double Isosurface::*value) {
        if ((*surface).*value > 0) return;
        block.report(
            warning(Fault::no_effect, block.span,
                    message("`", word, "` of ", block.quoted(), " is ", (*surface).*value,
                            ", which is not above 0: the usual ", usual.*value, " counts")));
        surface.edit().*value = usual.*value;
    };
    correct("accuracy", &Isosurface::accuracy);
    correct("max_gradient", &Isosurface::max_gradient);
}

/// Reports a lathe that begins or ends beyond the axis, which POV-Ray 3.8 refuses and older
/// versions render.
void check_ends(OpenBlock& block, const Lathe& lathe) {
    const auto beyond = [](const Vec2& point) { return point.x < 0; };
    if (lathe.points.empty() || static_cast<CurveKind>(lathe.spline) == cubic_curve ||
        !(beyond(lathe.points.front()) || beyond(lathe.points.back())))
        return;
    const bool modern = block.binder.evaluator.version() >= modern_version;
    const std::string text = "the first and the last radius of a `lathe` should not be below 0";
    block.report((modern ? error(Fault::out_of_range, block.span, text)
                         : warning(Fault::no_effect, block.span, text))
                     .with_help(block.help()));
}

}  // namespace

void complete(OpenBlock& block, Shape& shape) {
    if (auto* text = std::get_if<Shared<Text>>(&shape))
        complete_text(block, *text);
    else if (auto* field = std::get_if<Shared<HeightField>>(&shape))
        complete_heights(block, *field);
    else if (auto* surface = std::get_if<Shared<Isosurface>>(&shape))
        complete_isosurface(block, *surface);
    else if (const auto* lathe = std::get_if<Shared<Lathe>>(&shape))
        check_ends(block, **lathe);
    else if (const auto* mesh = std::get_if<Shared<TriangleMesh>>(&shape))
        if (problem(**mesh).empty()) shape = Shared<Mesh>(as_mesh(**mesh));
}

}  // namespace candelabra
