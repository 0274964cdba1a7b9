// SPDX-License-Identifier: GPL-3.0-or-later
// One option: its names, its help, where its value is kept, and what it changes.
#pragma once

#include "options/option_field.h"
#include "options/option_store.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Arguments of an option.
enum class Takes {
    nothing,
    sign,            ///< `+V` on, `-V` off; `Verbose=on`
    sign_and_value,  ///< `+A`, `+A0.1`, `-A`; `Antialias=on`
    value,           ///< `+W640`, `Width=640`, `--samples 64`
    maybe_value,     ///< `--check`, `--check=syntax`
    maybe_words,     ///< `--help`, `--help sphere`: words that are not options
    value_and_settings,  ///< `--sheet 4x3 Seed=1..12`: a value and `name=value` of no option
};

/// Treatment of a POV-Ray option that is not supported.
enum class Unoffered {
    no,        ///< supported
    accepted,  ///< it would change nothing
    ignored,   ///< with a warning: the picture is the same
    refused,   ///< with an error: the picture would differ
};

/// Effect of an option on files, and on the permissions of a scene.
enum class Touches {
    nothing,
    reads,       ///< its value names a file or folder that is read
    searches,    ///< like reads, but searched for in the folders of the scene and the library
    writes,      ///< its value names a file or folder that is written to
    writes_ini,  ///< like writes, for a file of options
    permits,     ///< permits something to scenes or to others
};

/// What an option changes in the result. `picture` decides which states belong to the same picture;
/// all but `none` are in the command that a picture records.
enum class Changes {
    none,      ///< no byte
    folders,   ///< where files are found; the identity of a picture has their digests
    format,    ///< how the picture is stored
    samples,   ///< how many samples pixels get
    adaptive,  ///< the same, if no option of `samples` is given
    picture,   ///< the light of the picture, or what else is found for each pixel
};

/// Options that help lists together.
enum class OptionGroup {
    picture,
    quality,
    light,
    film,
    scene,
    animation,
    states,
    files,
    limits,
    tasks,
    console,
    commands,
    povray
};

struct OptionGroupInfo {
    OptionGroup group;
    std::string_view name;
    std::string_view help;
};

/// All groups in the order of OptionGroup, which is that of help.
std::span<const OptionGroupInfo> option_groups();

struct OptionRow {
    std::string_view letters;    ///< POV-Ray's switch without its sign; empty: none
    std::string_view keyword;    ///< of `Keyword=value`; empty: none
    std::string_view word;       ///< of `--word`; empty: none
    std::string_view parameter;  ///< name of its value in help
    Takes takes;
    std::string_view help;  ///< empty: that of the field
    Changes changes = Changes::none;
    /// The value is that of a field of RenderSettings or AnimationSettings, that of `own`, or
    /// `store` takes it.
    std::string_view field = {};
    OptionField own = {};
    void (*store)(Options&, const Given&, Diagnostics&) = nullptr;
    /// Returns the values in force; null: that of the field, if there is one.
    std::vector<std::string> (*values)(const Options&) = nullptr;
    Unoffered unoffered = Unoffered::no;
    Touches touches = Touches::nothing;
    OptionGroup group = OptionGroup::picture;
    bool basic = false;  ///< listed by the short help
};

/// The name of the long option, without its hyphens: `word`, or the keyword as `output-alpha`.
/// Empty for switches that have no keyword.
std::string long_name(const OptionRow&);

/// Stores the value of an option, or reports an error.
void apply(const OptionRow&, Options&, const Given&, Diagnostics&);

}  // namespace candelabra
