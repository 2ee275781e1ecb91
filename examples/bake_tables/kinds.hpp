#pragma once

// The tables that can be baked: what each holds, and how CPU and GPU fill it.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gpu_baker.hpp"
#include "support/gl_table.hpp"
#include "support/presets.hpp"
#include "support/rows.hpp"
#include "support/table_file.hpp"

namespace bake_tables {

/// What a user chooses.
struct Request {
    support::Preset preset;
    support::TableSize size;
    int orders;                 ///< of scattering, for the tables that are made order by order
    double eye_altitude = 200;  ///< [m] for the tables of one frame
    double sun_elevation = 20;  ///< [degrees] likewise
};

/// The numbers of a table, channels side by side, x fastest.
using Numbers = std::vector<float>;

/// Every channel of a stored table at texture coordinates.
using LookUp = std::function<std::vector<double>(const airlight::vec3<double>&)>;

/// How many places, and under which sun; without one, under all.
struct PlaceChoice {
    int count;
    std::optional<double> sun_elevation = {};  ///< [degrees]
};

/// What was read from a table, and what it should have been.
struct Compared {
    std::vector<double> read;
    std::vector<double> exact;
};

struct Kind {
    std::string name;  ///< on the command line, and of the file
    std::string what;  ///< one line
    support::TableSize size;
    std::string mapping;
    std::string payload;
    std::string units;
    std::vector<std::string> channels;
    std::string remark = "";  ///< for the page of contracts
    bool has_orders = false;
    bool of_frame = false;  ///< for one eye and sun
    bool may_be_negative = false;
    bool layered = false;  ///< slices are not filtered into each other, each has a payload of its own
    support::TableSize small_size = {17, 10, 6};  ///< for tests; where size has a 1, so has the test
    std::string size_rule = "";                   ///< what a size has to be, in words
    std::function<bool(const support::TableSize&)> takes_size = [](const support::TableSize&) {
        return true;
    };

    /// What texels depend on, where that is not the whole atmosphere and the scene.
    std::function<support::TableWorld(const Request&)> world = {};

    std::function<Numbers(const Request&, const support::Rows&)> on_cpu = {};
    std::function<std::vector<double>(const Request&, const support::Rows&)> in_double = {};
    std::function<Numbers(const Request&, GpuBaker&)> on_gpu = {};

    /// Reads the table as a scene would, see places.hpp.
    std::function<Compared(const Request&, const LookUp&, const PlaceChoice&)> compare = {};
    bool has_sun = false;  ///< whether it is worth comparing sun by sun
};

const std::vector<Kind>& kinds();

/// Throws support::Error with the names that there are.
const Kind& kind_named(const std::string& name);

/// What goes into the file's header, and what a reader asks for.
support::TableDescription describe(const Kind& kind, const Request& request);

}  // namespace bake_tables
