// SPDX-License-Identifier: GPL-3.0-or-later
// candelabra._core: the tasks over scenes for Python. What users see is made of it in
// candelabra/__init__.py. A run is that of the command, with a Console that keeps what it says. It
// works on threads of its own without the interpreter's lock; the calling thread waits, and calls
// what Python wants to be called.
#include "base/deep_stack.h"
#include "base/work_watch.h"
#include "console/diagnostics_json.h"
#include "film/develop.h"
#include "options/memory_limit.h"
#include "options/option_help.h"
#include "output/layers.h"
#include "output/light_file.h"
#include "output/light_report.h"
#include "output/light_weights.h"
#include "picture/formats.h"
#include "picture/layers.h"
#include "production/version.h"
#include "relight/light_show.h"
#include "relight/record_file.h"
#include "relight/relighting.h"
#include "tasks/library.h"
#include "tasks/measuring.h"
#include "tasks/render_picture.h"
#include "tasks/scene_run.h"
#include "text/excerpt.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace candelabra {

namespace {

using Words = std::vector<std::string>;
using FloatArray = py::array_t<float, py::array::c_style | py::array::forcecast>;
using DoubleArray = py::array_t<double, py::array::c_style | py::array::forcecast>;
using ByteArray = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

/// Returns an array that shows the values and owns them through a capsule.
template <class Value>
py::array array_of(std::vector<Value> values, std::vector<py::ssize_t> shape) {
    auto kept = std::make_unique<std::vector<Value>>(std::move(values));
    std::vector<Value>* const address = kept.get();
    const py::capsule owner(address,
                            [](void* all) { delete static_cast<std::vector<Value>*>(all); });
    kept.release();
    return py::array(py::dtype::of<Value>(), std::move(shape), address->data(), owner);
}

py::array array_of(std::vector<std::uint8_t> bytes, int width, int height) {
    const auto channels =
        bytes.size() / static_cast<std::size_t>(width) / static_cast<std::size_t>(height);
    return array_of(std::move(bytes), {height, width, static_cast<py::ssize_t>(channels)});
}

Words words_of(const py::list& list) {
    Words words;
    for (const py::handle each : list) words.push_back(py::cast<std::string>(each));
    return words;
}

/// What a run has reported, as pairs of JSON and text for people.
class Reports {
public:
    void add(const Diagnostic& each, const SourceStore& sources) {
        all_.emplace_back(to_json(each, sources), format(each, sources, false));
    }
    void add(const Diagnostics& diagnostics) {
        for (const Diagnostic& each : diagnostics.all()) add(each, SourceStore());
    }
    py::list list() const {
        py::list made;
        for (const auto& [json, text] : all_)
            made.append(py::make_tuple(py::str(json), py::bytes(text)));
        return made;
    }

private:
    std::vector<std::pair<std::string, std::string>> all_;
};

/// One layer with its channels interleaved.
struct Layer {
    std::string name;  ///< empty: the picture itself
    std::vector<const ChannelPlane*> planes;

    py::array array(int width, int height) const {
        const std::size_t channels = planes.size();
        std::vector<float> values(planes.front()->bits.size() * channels);
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t i = 0; i < planes[c]->bits.size(); ++i) {
                const std::uint32_t bits = planes[c]->bits[i];
                values[i * channels + c] =
                    planes[c]->whole ? static_cast<float>(bits) : std::bit_cast<float>(bits);
            }
        std::vector<py::ssize_t> shape{height, width};
        if (channels > 1) shape.push_back(static_cast<py::ssize_t>(channels));
        return array_of(std::move(values), std::move(shape));
    }
};

/// The name of a plane's layer: "normal" of "normal.X", "depth" of itself.
std::string layer_of(const std::string& plane) {
    const std::size_t dot = plane.rfind('.');
    const std::string channel = dot == plane.npos ? plane : plane.substr(dot + 1);
    const bool is_channel = channel.size() == 1 &&
                            std::string_view("RGBXYZ").find(channel[0]) != std::string_view::npos;
    if (!is_channel) return plane;
    return dot == plane.npos ? std::string() : plane.substr(0, dot);
}

py::dict arrays_of(const LayeredPicture& picture) {
    std::vector<Layer> layers;
    for (const ChannelPlane& plane : picture.planes) {
        const std::string name = layer_of(plane.name);
        auto found = layers.begin();
        while (found != layers.end() && found->name != name) ++found;
        if (found == layers.end()) found = layers.insert(found, {name, {}});
        found->planes.push_back(&plane);
    }
    py::dict made;
    for (Layer& layer : layers) {
        // Files have their planes in the order of the alphabet: B, G, R.
        std::ranges::stable_sort(layer.planes, {}, [](const ChannelPlane* plane) {
            return std::string_view("RGBXYZ").find(plane->name.back());
        });
        made[py::str(layer.name)] = layer.array(picture.width, picture.height);
    }
    return made;
}

/// The picture of a run, kept until the interpreter's lock is there.
struct MadePicture {
    LayeredPicture layers;
    std::vector<std::uint8_t> shown;
    std::string description, film;
    struct Lamp {
        LightRow row;
        std::string name, file;
        int line = 0;
    };
    std::vector<Lamp> lamps;

    MadePicture(const FinishedPicture& made, bool reports)
        : layers(layered_picture(made.film, made.files)),
          shown(shown_bytes(made.film, made.files)),
          description(made.files.format.description) {
        if (made.files.film.on) film = to_text(made.files.film);
        if (!reports) return;
        const std::vector<std::string> names = light_names(made.world, made.sources);
        for (const LightRow& row : light_shares(made.world, made.rays).rows) {
            const Span& span = made.world.provenance.light_statements[row.statement];
            Lamp lamp{row, names[row.statement], {}};
            if (span.known()) {
                lamp.file = made.sources.name(span.source);
                lamp.line = made.sources.place(span.source, span.first).line;
            }
            lamps.push_back(std::move(lamp));
        }
    }

    py::dict dict() {
        py::dict made;
        made["layers"] = arrays_of(layers);
        made["pixels"] = array_of(std::move(shown), layers.width, layers.height);
        made["description"] = py::str(description);
        made["film"] = py::str(film);
        py::list report;
        for (const Lamp& lamp : lamps) {
            py::dict row;
            row["name"] = lamp.name;
            row["file"] = lamp.file.empty() ? py::object(py::none()) : py::str(lamp.file);
            row["line"] = lamp.line > 0 ? py::object(py::int_(lamp.line)) : py::none();
            row["light"] = lamp.row.light;
            row["rays"] = lamp.row.rays;
            row["lights"] = lamp.row.lights;
            report.append(row);
        }
        made["light_report"] = report;
        return made;
    }
};

/// A run over one scene.
class Run {
public:
    Run(const Words& words, const std::string& task, std::optional<std::string> text,
        const std::string& name, const std::string& library) {
        const std::vector<std::string_view> views(words.begin(), words.end());
        options_ = read_options(views, diagnostics_, disk_reader());
        if (!options_.memory_bytes) options_.memory_bytes = usual_memory_limit();
        options_.leaves_state = false;
        options_.for_caller = true;
        console_.text = std::move(text);
        console_.text_name = name;
        console_.library = library;
        connect();
        set_task(task);
    }

    py::dict operator()(const py::object& tick) {
        if (diagnostics_.failed())
            say_errors(console_, options_, diagnostics_);
        else
            wait_for(std::thread([this] { work(); }), tick);
        if (problem_) std::rethrow_exception(problem_);
        py::dict made;
        made["status"] = status_;
        made["reports"] = reports_.list();
        made["printed"] = py::bytes(printed_);
        made["table"] = py::str(table_);
        made["picture"] = picture_ ? py::object(picture_->dict()) : py::none();
        return made;
    }

private:
    void set_task(const std::string& task) {
        options_.task = task == "measure"         ? Task::measure
                        : task == "light_balance" ? Task::balance
                        : task == "check"         ? Task::check
                                                  : Task::render;
        options_.to_file = task == "render" && !options_.output.empty();
        if (!measures_light(options_)) return;
        options_.readings_file = "-";
        check_measuring(options_, diagnostics_);
    }

    void connect() {
        console_.owns_process = false;
        console_.povray_library = installed_povray_library();
        const auto first = named_libraries(std::getenv("CANDELABRA_LIBRARY"));
        options_.libraries.insert(options_.libraries.end(), first.begin(), first.end());
        if (options_.scene) console_.made_files = std::make_shared<MadeFiles>(*options_.scene);
        console_.out = [this](std::string_view text) { table_ += text; };
        console_.err = [](std::string_view) {};
        console_.heard = [this](Stream stream, std::string_view text) {
            const std::lock_guard lock(mutex_);
            if (stream == Stream::debug) printed_ += text;
        };
        console_.diagnosed = [this](const Diagnostic& each, const SourceStore& sources) {
            reports_.add(each, sources);
        };
        console_.progressed = [this](double done) { done_ = done; };
        console_.interrupts.take = [this] { return stop_ ? Interrupt::stop : Interrupt::none; };
        console_.finished = [this](const FinishedPicture& made) {
            picture_.emplace(made, options_.light_report);
        };
    }

    void work() {
        try {
            const std::function<bool()> ended = [this] { return stop_.load(); };
            on_deep_stack(options_.limits.stack_bytes, [&](std::size_t) {
                const WorkWatch watch(ended, WorkWatch::Asks::everywhere);
                status_ = run_scene(options_, console_, diagnostics_);
            });
        } catch (const WorkEnded&) {
            status_ = exit_status::stopped;
        } catch (...) {
            problem_ = std::current_exception();
        }
        if (stop_ && !picture_) status_ = exit_status::stopped;
        const std::lock_guard lock(mutex_);
        ended_ = true;
        changed_.notify_all();
    }

    /// Waits for the run. Meanwhile signals of the interpreter are handled, and `tick` is called
    /// with the fraction of the work that is done and the text that the scene has printed since.
    void wait_for(std::thread worker, const py::object& tick) {
        std::exception_ptr raised;
        std::size_t told = 0;
        for (bool ended = false; !ended;) {
            std::string news;
            {
                const py::gil_scoped_release others;
                constexpr auto moment = std::chrono::milliseconds(20);
                std::unique_lock lock(mutex_);
                ended = changed_.wait_for(lock, moment, [this] { return ended_; });
                news = printed_.substr(told);
            }
            told += news.size();
            if (raised) continue;
            try {
                if (PyErr_CheckSignals() != 0) throw py::error_already_set();
                if (tick.is_none()) continue;
                const py::object wanted = tick(done_.load(), py::bytes(news));
                if (wanted.is(py::bool_(false))) stop_ = true;
            } catch (const py::error_already_set&) {
                raised = std::current_exception();
                stop_ = true;
            }
        }
        {
            const py::gil_scoped_release others;
            worker.join();
        }
        if (raised) std::rethrow_exception(raised);
    }

    Options options_;
    Console console_;
    Diagnostics diagnostics_;
    Reports reports_;
    std::optional<MadePicture> picture_;
    std::string table_;
    int status_ = exit_status::usage;
    std::exception_ptr problem_;
    std::atomic<double> done_ = 0;
    std::atomic<bool> stop_ = false;
    std::mutex mutex_;  ///< of what follows
    std::condition_variable changed_;
    bool ended_ = false;
    std::string printed_;
};

py::dict run_task(const py::list& words, const std::string& task, const py::object& text,
                  const std::string& name, const std::string& library, const py::object& tick) {
    std::optional<std::string> scene;
    if (!text.is_none()) scene = py::cast<std::string>(text);
    return Run(words_of(words), task, std::move(scene), name, library)(tick);
}

/// Calls the function without the interpreter's lock.
template <class Work>
auto unlocked(const Work& work) {
    const py::gil_scoped_release others;
    return work();
}

Image image_of(const FloatArray& array) {
    if (array.ndim() != 3 || array.shape(2) != 3 || array.size() == 0)
        throw py::value_error("a picture has the shape (height, width, 3)");
    Image image(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)));
    const float* const values = array.data();
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
    return image;
}

/// Develops light with a film, as text, and what the options say of it. Returns None after errors.
py::object develop_light(const FloatArray& light, const py::object& smooth, const py::object& alpha,
                         const std::string& film_text, const std::string& name,
                         const py::list& words) {
    Diagnostics diagnostics;
    const Words kept = words_of(words);
    const std::vector<std::string_view> views(kept.begin(), kept.end());
    const Options options = read_options(views, diagnostics, disk_reader());
    FilmFiles files;
    files.threads = options.render.threads;
    Negative negative;
    negative.light = image_of(light);
    if (!smooth.is_none()) negative.smooth = image_of(py::cast<FloatArray>(smooth));
    if (!alpha.is_none()) {
        const auto values = py::cast<FloatArray>(alpha);
        negative.alpha.assign(values.data(), values.data() + values.size());
    }
    const std::size_t pixels = negative.light.pixels.size();
    for (const std::size_t count : {negative.smooth.pixels.size(), negative.alpha.size()})
        if (count != 0 && count != pixels)
            throw py::value_error("a layer has another size than the picture");
    const int width = negative.light.width, height = negative.light.height;
    std::optional<std::vector<std::uint8_t>> bytes;
    if (!diagnostics.failed())
        if (const auto film = film_of(film_text, name, options, diagnostics)) {
            files.film = *film;
            bytes = unlocked([&] { return shown_bytes(std::move(negative), files); });
        }
    Reports reports;
    reports.add(diagnostics);
    return py::make_tuple(
        bytes ? py::object(array_of(std::move(*bytes), width, height)) : py::none(),
        reports.list());
}

/// Reads an OpenEXR file with its layers. Returns them, the film, the origin, and the reports.
py::tuple read_file(const std::string& path) {
    static constexpr std::string_view texts[] = {film_text_name, "ImageDescription"};
    Diagnostics diagnostics;
    const auto picture = unlocked([&] { return read_layers(path, texts, diagnostics); });
    Reports reports;
    reports.add(diagnostics);
    if (!picture) return py::make_tuple(py::none(), "", "", reports.list());
    return py::make_tuple(arrays_of(*picture), picture->texts[0].second, picture->texts[1].second,
                          reports.list());
}

/// Returns the bytes of a file with these pixels of a display. `ending`: of its name.
py::tuple encode_pixels(const ByteArray& pixels, const std::string& ending,
                        const std::string& description) {
    const auto type = type_of_name("a." + ending);
    if (!type || info(*type).linear)
        throw py::value_error("`" + ending + "` is no ending of a picture for displays");
    if (pixels.ndim() != 3 || pixels.size() == 0 || pixels.shape(2) < 3 || pixels.shape(2) > 4)
        throw py::value_error("the pixels have the shape (height, width, 3 or 4)");
    const PictureTypeInfo& known = info(*type);
    const auto channels = static_cast<std::size_t>(pixels.shape(2));
    const std::size_t kept = known.alpha ? channels : std::min<std::size_t>(channels, 3);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(static_cast<std::size_t>(pixels.size()));
    for (std::size_t i = 0; i < static_cast<std::size_t>(pixels.size()); ++i)
        if (i % channels < kept) bytes.push_back(pixels.data()[i]);
    RawPicture raw{static_cast<int>(pixels.shape(1)),
                   static_cast<int>(pixels.shape(0)),
                   static_cast<int>(kept),
                   std::move(bytes),
                   known.extension,
                   known.compression,
                   description};
    if (*type == PictureType::tga) raw.compression = "none";
    Diagnostics diagnostics;
    const auto made = unlocked([&] { return write_stored(raw, diagnostics); });
    Reports reports;
    reports.add(diagnostics);
    return py::make_tuple(made ? py::object(py::bytes(*made)) : py::none(), reports.list());
}

/// The light of each lamp in a file.
class KeptLamps {
public:
    KeptLamps(const std::string& path, int smooth, int threads) {
        Diagnostics diagnostics;
        records_ = unlocked([&] { return read_records(path, diagnostics); });
        reports_.add(diagnostics);
        if (!records_) return;
        show_.emplace(records_->lamps);
        relighting_.emplace(*records_, smooth, threads);
    }
    KeptLamps(const KeptLamps&) = delete;
    KeptLamps& operator=(const KeptLamps&) = delete;

    py::list reports() const { return reports_.list(); }
    bool holds() const { return records_.has_value(); }
    std::string film() const { return records_->film; }
    std::string origin() const { return records_->origin; }
    py::object alpha() const {
        if (records_->alpha.empty()) return py::none();
        return array_of(records_->alpha, {records_->height, records_->width});
    }

    /// Names and numbers of lamps.
    py::dict groups() const {
        py::dict made;
        for (const LampGroup& group : records_->lamps.groups())
            made[py::str(group.name)] = group.lamps;
        return made;
    }

    /// The places of the lamps of a name in the list of factors, or None; and the reports.
    py::tuple places(const std::string& name) const {
        Diagnostics diagnostics;
        const auto chosen = show_->names().chosen(name, diagnostics);
        Reports reports;
        reports.add(diagnostics);
        if (!chosen) return py::make_tuple(py::none(), reports.list());
        std::vector<std::int64_t> numbers(chosen->begin(), chosen->end());
        const auto count = static_cast<py::ssize_t>(numbers.size());
        return py::make_tuple(array_of(std::move(numbers), {count}), reports.list());
    }

    /// The picture with a factor on each lamp, in the order of places().
    py::array picture(const DoubleArray& factors) const {
        if (factors.ndim() != 2 || factors.shape(1) != 3 ||
            factors.shape(0) != static_cast<py::ssize_t>(records_->lamps.size()))
            throw py::value_error("there is one colour for each lamp");
        std::vector<Rgb> each;
        for (py::ssize_t i = 0; i < factors.shape(0); ++i)
            each.emplace_back(factors.at(i, 0), factors.at(i, 1), factors.at(i, 2));
        std::vector<float> values;
        unlocked([&] {
            const Image image = relighting_->picture(each);
            values.reserve(3 * image.pixels.size());
            for (const Rgb& pixel : image.pixels)
                for (int c = 0; c < 3; ++c) values.push_back(finite_float(pixel[c]));
        });
        return array_of(std::move(values), {records_->height, records_->width, 3});
    }

private:
    Reports reports_;
    std::optional<LightRecords> records_;
    std::optional<LightShow> show_;
    std::optional<Relighting> relighting_;
};

/// The factors in a text such as `0.5,#ff8800`, or None.
py::object factor_of(const std::string& text) {
    const auto factor = lamp_factor(text);
    if (!factor) return py::none();
    return py::make_tuple(factor->r, factor->g, factor->b);
}

}  // namespace

PYBIND11_MODULE(_core, m) {
    m.doc() = "the tasks over scenes; see candelabra";
    m.attr("version") = std::string(version());
    m.def("run", &run_task);
    m.def("develop", &develop_light);
    m.def("read", &read_file);
    m.def("encode", &encode_pixels);
    m.def("factor", &factor_of);
    m.def("options", [] { return options_as_json(true, "term"); });
    py::class_<KeptLamps>(m, "KeptLamps")
        .def(py::init<const std::string&, int, int>())
        .def_property_readonly("reports", &KeptLamps::reports)
        .def_property_readonly("holds", &KeptLamps::holds)
        .def_property_readonly("film", &KeptLamps::film)
        .def_property_readonly("origin", &KeptLamps::origin)
        .def_property_readonly("alpha", &KeptLamps::alpha)
        .def_property_readonly("groups", &KeptLamps::groups)
        .def("places", &KeptLamps::places)
        .def("picture", &KeptLamps::picture);
}

}  // namespace candelabra
