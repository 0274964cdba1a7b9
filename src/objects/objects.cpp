// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/objects.h"

#include "appearance/part_looks.h"
#include "appearance/texture_list.h"
#include "appearance/webs.h"
#include "csg/solid.h"
#include "objects/appearance.h"
#include "objects/assets.h"
#include "objects/clipping.h"
#include "objects/cutaway.h"
#include "objects/lights.h"
#include "objects/model_block.h"
#include "objects/model_reader.h"
#include "objects/models.h"
#include "objects/object_draft.h"
#include "objects/photons.h"
#include "reading/transforms.h"
#include "text/message.h"

namespace candelabra {

// A scene may have a million spheres, so an object is made in one of three ways, the most expensive
// first:
//
//   1. It is read. ObjectReader passes the elements of its block to readers, which report all
//      errors. The other ways either yield the same object or fall back to this one.
//   2. It is reused. A block of constants (constants.h) that is visited again yields the same
//      object (memo.h: the same block over the same base). The blocks in it are reused likewise.
//   3. It is made by a plan. The first objects of a block in a loop are read, and a plan records
//      which numbers vary and how they are used (shape_plans.h). In later passes only these numbers
//      are computed and put into a copy of a model (variation.h). A sphere that differs from the
//      preceding one only in its values does not become an object: it joins the row at the end of
//      the list (RowEnd), which is one object for all of them.
//
// read_object_into() tries these ways from the last to the first.

namespace {

constexpr std::string_view ignored_words =
    "sturm hierarchy radiosity split_union dtag color colour";

/// Reads the objects and lights of a union, the one object in `object`, or a declared object in
/// place of a shape's values. Objects nest by the thousand, so rare cases have functions of their
/// own: their stack space would be reserved at every level.
class ContentReader : public SimpleReader {
public:
    enum class Kind { shape, object, together };

    ContentReader(OpenBlock& block, ObjectDraft& draft, Kind kind)
        : block_(block), draft_(draft), kind_(kind) {}

    bool wants() const { return kind_ == Kind::together ? !draft_.modified : block_.taken == 0; }

    bool take(const Element& element) {
        if (element.kind == Element::Kind::value) return take_declared(element);
        if (element.word == "cutaway_textures"_word) return take_cutaway();
        if (element.kind != Element::Kind::block || kind_ == Kind::shape) return false;
        if (!block_.makes_object(element)) return false;
        if (kind_ == Kind::together) block_.binder.evaluator.count_object(element.word_span);
        if (row_goes_on()) {
            std::optional<ObjectHandle> made =
                read_object_into(together().children, {}, block_.binder, element);
            if (made) take_made(std::move(*made), element.span);
        } else {
            take_made(made_of(element), element.span);
        }
        return true;
    }

    void finish() {
        if (kind_ == Kind::object && !draft_.has_form && !block_.broken) report_missing();
    }

    void add_words(WordList& words) const {
        if (kind_ == Kind::shape) return;
        for (const ItemInfo* shape : Kinds<Shape>::infos) words.push_back(shape->name);
        words.insert(words.end(), {"union", "intersection", "difference", "merge", "object",
                                   "light_group", "light_source", "cutaway_textures"});
    }

private:
    Union& together() { return std::get<Union>(draft_.made.edit().form); }
    /// Whether a sphere may be appended to the union's rows directly.
    bool row_goes_on() {
        return kind_ == Kind::together && !draft_.modified && !block_.broken &&
               together().csg == Csg::together;
    }

    bool take_cutaway() {
        if (kind_ != Kind::together || !cuts(together())) return false;
        return draft_.cutaway = draft_.modified = true;
    }

    [[gnu::noinline]] ObjectHandle made_of(const Element& element) {
        Binder& binder = block_.binder;
        return binder.objects.made(binder.constants.number(element), binder.default_texture,
                                   [&] { return read_object(binder, element); });
    }

    void take_made(ObjectHandle made, Span span) {
        if (!made) {
            block_.broken = true;
            draft_.has_form = true;
        } else if (welcome(span)) {
            add(std::move(made));
        }
    }

    [[gnu::noinline]] bool take_declared(const Element& element) {
        const Handle<Object> object = element.value.handle<Object>();
        const Handle<PlacedLight> light = element.value.handle<PlacedLight>();
        if (!object && !(light && kind_ != Kind::shape)) return false;
        if (kind_ == Kind::together) block_.binder.evaluator.count_object(element.span);
        if (!welcome(element.span)) return true;
        if (!object) {
            PlacedLight placed = *light;
            placed.span = element.span;
            add(as_object(std::move(placed)));
        } else if (kind_ == Kind::together) {
            add(as_part(object));
        } else {
            draft_.declared = object;
            draft_.take(*object);
        }
        return true;
    }

    /// Warns of a part without an inside. Only the object that is cut may lack one.
    [[gnu::noinline]] void check_inside(const Object& made) {
        const bool cuts = together().csg == Csg::difference;
        if ((cuts && together().children.empty()) || has_inside(made)) return;
        block_.report(warning(Fault::no_effect, made.span,
                              cuts ? "this has no inside, so it cuts nothing off the others"
                                   : "this has no inside, so it leaves nothing of the others")
                          .with_help("triangles have no inside; a mesh gets one by inside_vector"));
    }

    void add(ObjectHandle made) {
        if (kind_ == Kind::together) {
            if (cuts(together()) && !may_be_cut(block_, *made)) return;
            if (cuts(together())) check_inside(*made);
            take_lights(*made, together());
            nest(draft_.made.edit(), *made);
            together().children.push_back(std::move(made));
            return;
        }
        draft_.made = std::move(made);
        draft_.take(*draft_.made);
    }

    [[gnu::noinline]] void report_missing() {
        block_.report(error(Fault::missing, block_.span, "`object` needs an object")
                          .with_help(block_.help()));
    }

    /// Whether an object may stand here; reports it otherwise.
    bool welcome(Span span) {
        if (block_.broken) return kind_ == Kind::together || !draft_.has_form;
        if (kind_ == Kind::together && !draft_.modified) return true;
        return welcome_alone(span);
    }
    [[gnu::noinline]] bool welcome_alone(Span span) {
        std::string why;
        if (kind_ == Kind::together && draft_.modified)
            why =
                message("the objects of ", block_.quoted(), " come before what changes the whole");
        else if (kind_ == Kind::object && draft_.has_form)
            why = "`object` holds one object, and this is a second";
        else if (kind_ == Kind::object && draft_.modified)
            why = "in `object` the object comes before what changes it";
        else if (kind_ == Kind::shape && block_.taken > 0)
            why = message("a declared object comes first in ", block_.quoted(),
                          ", in the place of its values");
        if (why.empty()) return true;
        Diagnostic wrong = error(Fault::misplaced, span, why);
        if (kind_ == Kind::object) wrong.with_help("union { ... } holds several objects");
        block_.report(std::move(wrong));
        return false;
    }

    OpenBlock& block_;
    ObjectDraft& draft_;
    Kind kind_;
};

class ObjectReader {
public:
    ObjectReader(Binder& binder, const Element& element)
        : element_(element),
          block_(binder, binder.evaluator.spelling(element.word), element.word_span),
          draft_(binder),
          part_looks_(binder, draft_.part_textures) {
        block_.ignored = ignored_words;
        block_.part_looks = &part_looks_;
    }

    ObjectHandle read() {
        const std::size_t kind = Kinds<Shape>::find(element_.word);
        if (kind != Kinds<Shape>::count)
            read_shape(kind);
        else if (element_.word == "model"_word)
            read_model();
        else
            read_content(block_.binder.blocks.combines_objects(element_.word)
                             ? ContentReader::Kind::together
                             : ContentReader::Kind::object);
        if (block_.broken) return nullptr;
        ObjectHandle made = draft_.finished(element_.span);
        const bool deep = made->depth > block_.binder.evaluator.limits().nesting;
        return deep ? too_deep(block_.binder, element_) : made;
    }

private:
    template <class... Fields>
    void read_with(Body body, ContentReader& content, Fields&... fields) {
        const auto apply = [&](const Movement& movement) { draft_.move(movement); };
        TransformReader moves(block_, apply);
        AppearanceReader look(block_, draft_);
        ClippingReader clipping(block_, draft_);
        ItemReader switches(block_, Switches::vocabulary, &draft_.switches);
        switches.repeatable();
        InversionReader inversion(draft_);
        PhotonsReader photons(block_, draft_);
        LampReader lamp(block_, draft_.switches.lamp);
        block_.read(body, fields..., content, look, clipping, moves, inversion, switches, photons,
                    lamp);
        draft_.modified |= lamp.given();
    }

    void read_shape(std::size_t kind) {
        const ItemInfo& info = *Kinds<Shape>::infos[kind];
        block_.item = &info;
        Shape& shape = std::get<Shape>(draft_.made.edit().form);
        ItemReader fields(block_, info, Kinds<Shape>::emplace(shape, kind));
        ContentReader content(block_, draft_, ContentReader::Kind::shape);
        const auto declared = [&] { return draft_.declared != nullptr; };
        ShapeReader reader{fields, declared};
        const auto* triangles = std::get_if<Shared<TriangleMesh>>(&shape);
        ModelReader model(block_, draft_, triangles != nullptr);
        read_with(element_.body, content, reader, model);
        if (block_.broken || draft_.declared) return;
        std::optional<Mesh> made = triangles ? model.made(**triangles) : std::nullopt;
        if (block_.broken) return;
        if (made)
            shape = Shared(std::move(*made));
        else
            complete(block_, shape);
        if (!block_.broken) check(shape);
    }

    /// Reads a model, which is an object in a file as a declared one is an object in the text.
    void read_model() {
        block_.item = &ModelSettings::vocabulary;
        ModelSettings settings;
        ItemReader fields(block_, ModelSettings::vocabulary, &settings);
        ReplacementReader replaced(block_);
        ContentReader content(block_, draft_, ContentReader::Kind::shape);
        read_with(element_.body, content, replaced, fields);
        if (block_.broken || draft_.declared) return;
        draft_.declared = model_object(block_, settings, replaced.made());
        draft_.has_form = true;
    }

    /// Reads the fields of a shape, which a declared object may replace.
    struct ShapeReader {
        ItemReader& fields;
        FunctionRef<bool()> declared;

        bool waiting() const { return fields.waiting(); }
        bool wants() const { return fields.wants(); }
        bool take(const Element& element) { return fields.take(element); }
        void finish() {
            if (declared()) fields.complete();
            fields.finish();
        }
        void add_words(WordList& words) const { fields.add_words(words); }
    };

    void read_content(ContentReader::Kind kind) {
        const bool together = kind == ContentReader::Kind::together;
        block_.form = together ? "{ objects ... [modifiers] }" : "{ object [modifiers] }";
        const bool group = element_.word == "light_group"_word;
        if (together) draft_.made.edit().form = Union{{}, {}, {}, csg(), group};
        ContentReader content(block_, draft_, kind);
        UnionSettings settings;
        ItemReader names(block_, UnionSettings::vocabulary, &settings);
        if (group)
            read_light_group(content, names);
        else if (together)
            read_with(element_.body, content, names);
        else
            read_with(element_.body, content);
        if (!settings.light_name.empty()) name_light(std::move(settings.light_name));
        if (group) return;
        if (draft_.cutaway) may_be_cut(block_, *draft_.made);
        if (draft_.cutaway && !draft_.textured && !block_.broken)
            cut_away(std::get<Union>(draft_.made.edit().form), block_.binder.default_texture);
        const auto* whole = std::get_if<Union>(&draft_.made->form);
        if (together) nest_rows(draft_.made.edit());
        if (together && !block_.broken && whole->children.empty() && whole->lights.empty())
            warn_of_nothing();
    }

    [[gnu::noinline]] void warn_of_nothing() {
        block_.report(warning(Fault::no_effect, element_.word_span,
                              message("there is no object in this ", block_.quoted())));
    }

    /// Names all light in the union that has no name yet.
    [[gnu::noinline]] void name_light(std::string name) {
        Union& together = std::get<Union>(draft_.made.edit().form);
        together.light_name = make_handle<std::string>(std::move(name));
        for (auto* lights : {&together.lights, &together.free_lights})
            for (PlacedLight& light : *lights)
                if (!light.light_name) light.light_name = together.light_name;
    }

    [[gnu::noinline]] void read_light_group(ContentReader& content, ItemReader& names) {
        GroupSettings settings;
        ItemReader fields(block_, GroupSettings::vocabulary, &settings);
        read_with(element_.body, content, fields, names);
        std::get<Union>(draft_.made.edit().form).global_lights = settings.global_lights;
    }

    Csg csg() const {
        return element_.word == "intersection"_word ? Csg::intersection
               : element_.word == "difference"_word ? Csg::difference
               : element_.word == "merge"_word      ? Csg::merge
                                                    : Csg::together;
    }

    void check(const Shape& shape) {
        const std::string wrong = problem(shape);
        if (wrong.empty())
            return check_texture_numbers(block_, shape, draft_.part_textures.size()),
                   leave_out_if_nothing(shape);
        if (is_passed_over(shape)) return leave_out(wrong);
        block_.report(error(Fault::degenerate, element_.word_span, wrong).with_help(block_.help()));
    }

    /// Whether POV-Ray renders a scene without this shape, which has a problem.
    static bool is_passed_over(const Shape& shape) {
        const auto* polygon = std::get_if<Shared<Polygon>>(&shape);
        const auto* disc = std::get_if<Disc>(&shape);
        return (polygon && (*polygon)->points.size() > 2) || (disc && disc->normal == Vec3(0));
    }

    /// Leaves out a shape that has no extent, as in POV-Ray: loops and animations begin with a
    /// radius of 0, and modellers write triangles without area. Warns of it, except for a blank
    /// text.
    void leave_out_if_nothing(const Shape& shape) {
        const std::string why = vanishes(shape);
        if (why.empty()) return draft_.divide_form();
        if (!std::holds_alternative<Shared<Text>>(shape)) return leave_out(why);
        draft_.made.edit().form = Union{};
    }

    void leave_out(const std::string& why) {
        block_.report(warning(Fault::degenerate, element_.word_span,
                              message("this ", block_.quoted(), " is left out: ", why)));
        draft_.made.edit().form = Union{};
    }

    const Element& element_;
    OpenBlock block_;
    ObjectDraft draft_;
    PartTextureReader part_looks_;
};

/// Reads an object that contains objects, unless they are nested too deeply.
ObjectHandle read_nested(Binder& binder, const Element& element) {
    if (binder.nesting > binder.evaluator.limits().nesting) return too_deep(binder, element);
    ++binder.nesting;
    ObjectHandle made = ObjectReader(binder, element).read();
    --binder.nesting;
    return made;
}

/// A block that has a plan.
struct Planned {
    Binder& binder;
    const Element& element;
    const ItemInfo* item;  ///< the vocabulary of its shape; null: it combines objects
    ShapePlan& plan;
};

/// Makes a block's object by its plan. Returns nothing if the object has joined the row, and null
/// if the plan does not apply. Stores the block's values in `variation` if they could be computed.
std::optional<ObjectHandle> by_plan(const Planned& planned, const RowEnd* row,
                                    std::optional<Variation>& variation) {
    const auto& [binder, element, item, plan] = planned;
    binder.evaluator.begin_attempt();
    if (!plan.variable().compute(binder.evaluator, element.body, variation.emplace()))
        variation.reset();
    const Object* model = nullptr;
    if (variation)
        model = plan.model(binder.evaluator, binder.default_texture);
    else
        plan.note_vain();
    const bool joined =
        model && row && plan.variable().plain() && joins(*row, *model, *variation, element.span);
    ObjectHandle made =
        model && !joined ? like(binder, *model, item, plan.variable(), *variation) : nullptr;
    binder.evaluator.end_attempt(joined || made);
    if (joined) return std::nullopt;
    if (made) made.edit().span = element.span;
    return made;
}

/// Reads a shape. Kept out of line, so that nested objects do not reserve its stack space at every
/// level.
[[gnu::noinline]] ObjectHandle read_shape(Binder& binder, const Element& element) {
    return ObjectReader(binder, element).read();
}

/// read_planned() for a block that has a plan.
[[gnu::noinline]] std::optional<ObjectHandle> follow_plan(const Planned& planned,
                                                          const RowEnd* row) {
    const auto& [binder, element, item, plan] = planned;
    std::optional<Variation> variation;
    std::optional<ObjectHandle> made = by_plan(planned, row, variation);
    if (!made || *made) return made;
    const Diagnostics& diagnostics = binder.evaluator.diagnostics();
    const std::size_t said = diagnostics.count();
    made = item ? read_shape(binder, element) : read_nested(binder, element);
    if (*made && variation && diagnostics.count() == said)
        plan.learn(binder.evaluator, binder.default_texture, *variation, *made);
    return made;
}

/// read_object_into() for a shape of that kind or a combination of objects. Without a row, always
/// returns an object or null.
std::optional<ObjectHandle> read_planned(Binder& binder, const Element& element, std::size_t kind,
                                         const RowEnd* row) {
    const ItemInfo* item = kind == Kinds<Shape>::count ? nullptr : Kinds<Shape>::infos[kind];
    if (ShapePlan* plan = binder.plans.find(binder.evaluator, element, item))
        return follow_plan({binder, element, item, *plan}, row);
    if (!item) return read_nested(binder, element);
    return binder.objects.made(binder.constants.number(element), binder.default_texture,
                               [&] { return read_shape(binder, element); });
}

}  // namespace

std::optional<ObjectHandle> read_object_into(std::vector<ObjectHandle>& list,
                                             const Handle<Texture>& texture, Binder& binder,
                                             const Element& element) {
    const std::size_t kind = Kinds<Shape>::find(element.word);
    const bool shape = kind != Kinds<Shape>::count;
    if (!shape && !binder.blocks.combines_objects(element.word))
        return read_object(binder, element);
    const RowEnd row{list, texture};
    return read_planned(binder, element, kind, shape ? &row : nullptr);
}

ObjectHandle read_object(Binder& binder, const Element& element) {
    if (element.word == "light_source"_word && !is_lamp(binder, element)) {
        std::optional<PlacedLight> light = read_light(binder, element);
        return light ? as_object(std::move(*light)) : nullptr;
    }
    const std::size_t kind = Kinds<Shape>::find(element.word);
    const bool planned =
        kind != Kinds<Shape>::count || binder.blocks.combines_objects(element.word);
    return planned ? *read_planned(binder, element, kind, nullptr) : read_nested(binder, element);
}

}  // namespace candelabra
