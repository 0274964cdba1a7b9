// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/evaluate.h"

#include "appearance/patterns.h"
#include "appearance/textures.h"
#include "bind/blocks.h"
#include "bind/scene_content.h"
#include "bind/version_defaults.h"
#include "formula/function_texts.h"
#include "objects/object_draft.h"
#include "objects/object_functions.h"
#include "objects/solid_queries.h"
#include "reading/item_reader.h"
#include "scene/dump_texture.h"
#include "surface/pigment_map.h"
#include "text/message.h"
#include "text/printable.h"

#include <utility>

namespace candelabra {

namespace {

/// The words of the rows that have this reader.
template <class Reader>
WordList words_with(Reader BlockRow::*reader) {
    WordList words;
    for (const BlockRow& row : block_table().rows())
        if (row.*reader) words.push_back(row.word);
    return words;
}

WordList with_shapes(WordList words) {
    for (const ItemInfo* shape : Kinds<Shape>::infos) words.push_back(shape->name);
    return words;
}

class SceneReader {
public:
    SceneReader(Evaluator& evaluator, Scene& scene)
        : binder_{evaluator, block_table()}, scene_(scene) {
        top_.ignored = "max_intersections";
        scene.background.colour.transmit = 1;  // in case the scene gives none
    }

    void take(const Element& element) {
        if (take_stray_setting(element)) return;
        if (element.kind == Element::Kind::block) return take_block(element);
        if (element.kind == Element::Kind::value) {
            const auto object = element.value.handle<Object>();
            const auto light = element.value.handle<PlacedLight>();
            if (object || light) binder_.evaluator.count_object(element.span);
            if (object) return content_.add(another(object));
            if (light) return content_.add(*light);
        }
        stray(element);
    }

    Value value(std::span<const Element> elements) {
        const Element& first = elements.front();
        if (first.word == "texture"_word) {
            const Handle<Texture> layers = read_layers(binder_, elements);
            return layers ? Value(layers) : Value(Absence::broken);
        }
        if (elements.size() > 1) {
            binder_.evaluator.report(error(Fault::wrong_count, elements[1].span,
                                           "one value is wanted here, and this is a second"));
            return Absence::broken;
        }
        const BlockRow* row = binder_.blocks.row(first.word);
        if (row && row->as_value) return row->as_value(binder_, first);
        OpenBlock block(binder_, {}, first.word_span);
        block.refuse(first, with_shapes(words_with(&BlockRow::as_value)));
        return Absence::broken;
    }

    Value layered(const Value& below, const Value& above, Span span) {
        const Handle<Texture> lower = below.handle<Texture>(), upper = above.handle<Texture>();
        if (!lower || !upper) return Absence::nothing;
        OpenBlock block(binder_, "texture", span);
        Handle<Texture> both = candelabra::layered(block, span, lower, upper);
        return block.broken ? Value(Absence::broken) : Value(std::move(both));
    }

    Handle<Formula> function(const Element& element) {
        return element.word == "pigment"_word ? pigment_function(element)
                                              : pattern_function(element);
    }

    void set_default(const Element& element) {
        defaults_.keep();
        const bool block = element.kind == Element::Kind::block;
        const BlockRow* row = block ? binder_.blocks.row(element.word) : nullptr;
        if (row && row->as_default) return row->as_default(binder_, element);
        OpenBlock whole(binder_, "#default", element.word_span);
        whole.form = "{ texture { ... } }, or pigment, normal, finish, camera";
        whole.refuse(element, words_with(&BlockRow::as_default));
    }

    void set_version(double version, Span span) { defaults_.follow(version, span); }

    /// Completes the scene after the last element.
    void finish(bool version_given) {
        if (!binder_.evaluator.stopped()) stray_settings_.finish();
        scene_.language_version = version_given ? binder_.evaluator.version() : 3.62;
        const SceneNoise& noise = *binder_.evaluator.noise();
        if (!noise.given) scene_.settings.noise_generator = static_cast<int>(noise.generator());
        scene_.gamma_handling = content_.given.gamma || scene_.language_version >= 3.7;
        if (!scene_.camera_given) content_.show(binder_.default_camera);
    }

private:
    /// The scene's settings for pattern functions. As in POV-Ray, these use ten wave sources
    /// regardless of the scene.
    static PatternScene around(const SceneNoise& noise) {
        PatternScene result;
        result.noise_generator = noise.generator();
        return result;
    }

    Handle<Formula> pattern_function(const Element& element) {
        PatternDraft draft;
        if (!read_pattern(binder_, element, draft)) return nullptr;
        const auto code = [use = draft.use(), transform = draft.transform,
                           noise = binder_.evaluator.noise()](const double* in, double* out) {
            const Vec3 point = transform.inverse_point(Vec3(in[0], in[1], in[2]));
            out[0] = use.value(use.place(point), around(*noise));
            return true;
        };
        return with_text(make_handle<Formula>(3, 1, code),
                         [&] { return dump(draft.use(), draft.transform); });
    }

    /// Results: red, green, blue, filter, transmit.
    Handle<Formula> pigment_function(const Element& element) {
        Pigment pigment = binder_.default_texture->pigment;
        if (!read_pigment(binder_, element, pigment)) return nullptr;
        const auto code = [pigment, noise = binder_.evaluator.noise()](const double* in,
                                                                       double* out) {
            const Colour colour = evaluate(pigment, Vec3(in[0], in[1], in[2]), around(*noise));
            for (int i = 0; i < 3; ++i) out[i] = colour.rgb[i];
            out[3] = colour.filter;
            out[4] = colour.transmit;
            return true;
        };
        return with_text(make_handle<Formula>(3, 5, code), [&] { return dump(pigment); });
    }

    /// Takes `max_trace_level` and its number, which old scenes have outside of global_settings.
    bool take_stray_setting(const Element& element) {
        const bool begins =
            element.kind == Element::Kind::word && element.word == "max_trace_level"_word;
        if (begins)
            binder_.evaluator.report(warning(Fault::deprecated, element.word_span,
                                             "`max_trace_level` belongs into `global_settings`")
                                         .with_help("global_settings { max_trace_level 5 }"));
        return (begins || stray_settings_.waiting()) && stray_settings_.take(element);
    }

    void take_block(const Element& element) {
        top_.resume();
        const BlockRow* row = binder_.blocks.row(element.word);
        if (!row) row = binder_.blocks.scene_row(top_.spelling(element.word));
        if (!row || !row->in_scene) return stray(element);
        if (row->makes_object()) binder_.evaluator.count_object(element.word_span);
        row->in_scene(content_, element);
    }

    /// Reports an element that is not a part of a scene.
    void stray(const Element& element) {
        top_.refuse(element, with_shapes(words_with(&BlockRow::in_scene)));
        top_.broken = false;
    }

    Binder binder_;
    VersionDefaults defaults_{binder_};
    Scene& scene_;
    OpenBlock top_{binder_, {}, {}};
    SceneContent content_{binder_, scene_};
    OpenBlock around_settings_{binder_, "global_settings", {}};
    ItemReader stray_settings_{around_settings_, GlobalSettings::vocabulary, &scene_.settings};
};

}  // namespace

Scene evaluate(SourceStore& sources, const Loader& loader, SourceId main,
               const EvaluateOptions& options, Diagnostics& diagnostics) {
    Scene scene;
    Names names;
    Evaluator evaluator(sources, loader, names, diagnostics, options.facts);
    SolidQueries objects;
    evaluator.add_functions(object_functions(), objects);
    evaluator.set_limits(options.limits);
    evaluator.set_ended(options.ended);
    SceneReader reader(evaluator, scene);
    ElementHandlers handlers;
    handlers.top = [&](const Element& element) { reader.take(element); };
    handlers.value = [&](std::span<const Element> elements) { return reader.value(elements); };
    handlers.function = [&](const Element& element) { return reader.function(element); };
    handlers.set_default = [&](const Element& element) { reader.set_default(element); };
    handlers.set_version = [&](double version, Span span) { reader.set_version(version, span); };
    handlers.layered = [&](const Value& below, const Value& above, Span span) {
        return reader.layered(below, above, span);
    };
    handlers.takes_braces = [](NameId word) { return block_table().takes_braces(word); };
    handlers.knows_word = [&](NameId name) {
        return block_table().knows(evaluator.spelling(name));
    };
    handlers.print = [&](std::string_view text) {
        if (options.print) options.print(text);
    };
    evaluator.set_handlers(std::move(handlers));
    for (const auto& declared : options.declares)
        std::visit([&](const auto& content) { evaluator.declare(declared.first, Value(content)); },
                   declared.second);
    evaluator.run(main);
    reader.finish(evaluator.version_given());
    if (options.only.empty()) return scene;
    const Value* only = evaluator.find(names.find(options.only));
    ObjectHandle object = only ? only->handle<Object>() : nullptr;
    if (!object && !diagnostics.failed())
        diagnostics.add(error(Fault::unknown_name, {},
                              message("no object is declared as `", printable(options.only), "`")));
    scene.objects.clear();
    if (object) scene.objects.push_back(std::move(object));
    return scene;
}

}  // namespace candelabra
