// SPDX-License-Identifier: GPL-3.0-or-later
// Develops the preview's snapshots to pictures for the screen on its own thread, so that exposure,
// glare and lamps follow a slider while the picture is being rendered.
#pragma once

#include "preview/snapshot.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace candelabra {

/// A picture for the screen.
struct ScreenPicture {
    int width = 0, height = 0;                      ///< of the whole picture
    int columns = 0, rows = 0;                      ///< of these pixels: fewer if it is coarse
    int generation = 0;                             ///< see SnapshotContext
    std::string view = "picture";                   ///< or a layer
    std::shared_ptr<const std::string> bytes = {};  ///< see screen_bytes()
};

class SnapshotDeveloper {
public:
    /// `shows`: receives each picture, called by the developer's thread.
    explicit SnapshotDeveloper(std::function<void(ScreenPicture)> shows);
    SnapshotDeveloper(const SnapshotDeveloper&) = delete;
    SnapshotDeveloper& operator=(const SnapshotDeveloper&) = delete;
    ~SnapshotDeveloper();

    /// Sets the newest snapshot. This and the following functions may be called by any thread.
    void take(std::shared_ptr<const LightSnapshot>, std::shared_ptr<const SnapshotContext>);
    void set(const Look&);

    /// Returns the newest picture as a file; empty if there is none.
    std::string png() const;
    std::string exr() const;

private:
    /// The inputs of a picture.
    struct Order {
        std::shared_ptr<const LightSnapshot> snapshot;
        std::shared_ptr<const SnapshotContext> context;
        Look look;
        int number = 0;  ///< counts the pictures that were begun
    };

    void work();
    /// Whether developing is slow because of glare, so that a smaller picture comes first.
    static bool is_slow(const Order&);
    /// Develops the whole picture on another thread, once the sliders rest.
    void enlarge(const Order&);
    void develop(const Order&, const LightSnapshot&);
    Order order() const;

    /// Pixels of the snapshot per pixel of a small picture, in each direction.
    static constexpr int quick_step = 4;

    std::function<void(ScreenPicture)> shows_;
    mutable std::mutex mutex_;
    std::mutex showing_;
    std::condition_variable changed_;
    Order order_;
    bool fresh_ = false, ending_ = false;
    bool small_ = false;  ///< the last picture was smaller than its snapshot
    std::atomic<bool> enlarging_ = false;
    std::thread enlarger_;
    std::thread thread_;
};

}  // namespace candelabra
