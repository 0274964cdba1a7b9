// SPDX-License-Identifier: GPL-3.0-or-later
// An object while its block is read: its form, appearance and transformations. Called by the
// readers of objects. A declared object that is only transformed shares its contents with the
// original.
#pragma once

#include "appearance/textures.h"
#include "reading/transforms.h"

namespace candelabra {

/// Fields of light_group { } beside its lights and objects.
struct GroupSettings {
    bool global_lights = false;

    static const ItemInfo vocabulary;
};

/// Fields of a union and its relatives beside its objects.
struct UnionSettings {
    std::string light_name;

    static const ItemInfo vocabulary;
};

/// The form and the appearance of an object while its block is read.
struct ObjectDraft {
    explicit ObjectDraft(Binder& binder) : binder(binder), texture(binder.default_texture) {}

    Binder& binder;
    ObjectHandle made = binder.pool.make();  ///< holds the form; finished() adds the rest
    /// The declared object that a name stands for; its form is copied only when necessary.
    ObjectHandle declared;
    Switches switches;
    Switches declared_switches;
    TextureDraft texture;
    bool textured = false;    ///< the object has a texture of its own
    bool retextured = false;  ///< this block has given or changed that texture
    bool furnished = false;   ///< this block has given or changed the interior
    Clipping clipping;        ///< in the current position
    bool clipped = false;     ///< this block has given clips or bounds
    std::vector<Handle<Texture>> part_textures;
    Handle<Texture> interior_texture;  ///< null: as outside
    Handle<Transform> movement;        ///< since the form was read; null: none
    bool constant_movement = true;     ///< the text always gives the same movement
    bool has_form = false;
    bool modified = false;
    bool cutaway = false;  ///< parts without a texture show those of the objects that they cut

    /// Takes everything but the form, which has been read, from the object.
    void take(const Object&);
    /// Transforms everything read so far.
    void move(const Movement&);
    /// Splits a form that the renderer supports only in parts, such as a self-crossing cone.
    void divide_form();
    /// The finished object, which is unshared unless it equals a declared one. Consumes the draft.
    ObjectHandle finished(Span);

private:
    /// Whether the object was only moved: then a union need not be copied, and a million of them
    /// are cheap.
    bool only_moved() const {
        return !retextured && !furnished && !clipped && switches == declared_switches;
    }
};

/// Reads `inverse`, which swaps inside and outside each time it occurs.
class InversionReader : public SimpleReader {
public:
    explicit InversionReader(ObjectDraft& draft) : draft_(draft) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::word || element.word != "inverse"_word) return false;
        draft_.switches.inverse = !draft_.switches.inverse;
        return true;
    }

private:
    ObjectDraft& draft_;
};

/// Appends all lights of the object that light more than a group in it, in the space around the
/// object.
void append_lights(const Object&, std::vector<PlacedLight>&);

/// Does so for a part of another object. A light group keeps only lights that are not in unions.
void take_lights(const Object& part, Union& whole);

/// Marks the spheres of rows as parts of the union that contains the rows.
void nest_rows(Object& whole);

/// Makes a new object of a declared one, and shares its contents.
ObjectHandle another(const ObjectHandle&);

/// Makes a declared object a part of another one; the part may share everything.
ObjectHandle as_part(const ObjectHandle&);

/// A light source as an object.
ObjectHandle as_object(PlacedLight);

/// Whether the object has few enough parts to be cut, which visits all of them. Otherwise reports
/// this, marks the block as broken, and stops.
bool may_be_cut(OpenBlock&, const Object&);

/// Reports that objects are nested too deeply, and stops the evaluation. Returns null.
ObjectHandle too_deep(Binder&, const Element&);

}  // namespace candelabra
