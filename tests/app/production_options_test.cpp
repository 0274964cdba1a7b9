// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/production_options.h"

#include "app/read_words.h"

namespace candelabra {

TEST_CASE("times and sizes have units") {
    CHECK(read({"--time", "90"}).time == 90.0);
    CHECK(read({"--time", "1.5m"}).time == 90.0);
    CHECK(read({"--checkpoint=2H"}).checkpoint_interval == 7200);
    CHECK(read({"--checkpoint=0"}).checkpoint_interval == 0);
    CHECK(read({"--memory", "8G"}).memory_bytes == std::uint64_t{8} << 30);
    CHECK(read({"--memory", "500m"}).memory_bytes == std::uint64_t{500} << 20);
    for (const char* bad : {"--time=x", "--time=-1", "--time=s", "--time=0", "--memory=1", "--memory=8Q",
                            "--checkpoint=1d", "--shard-by=rows", "+SR-1", "+EC"})
        read({bad}, false);
}

TEST_CASE("parts of a picture are numbers or fractions; states and shards are switched on") {
    const Options options = read({"+SR3", "End_Row=0.5", "+SC1", "+EC20", "+C", "--keep-state",
                                  "--shard", "2/4", "--shard-by", "tiles", "--noise", "0.02"});
    CHECK(options.start_row == 3.0);
    CHECK(options.end_row == 0.5);
    CHECK(options.end_column == 20.0);
    CHECK(options.go_on);
    CHECK(options.keep_state);
    CHECK(options.shard == "2/4");
    CHECK(options.shard_by == ShardBy::tiles);
    CHECK(options.render.noise == 0.02);
}

}  // namespace candelabra
