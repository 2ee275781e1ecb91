#include "kinds.hpp"

#include "by_scene.hpp"
#include "families.hpp"
#include "support/error.hpp"

namespace bake_tables {

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all = [] {
        std::vector<Kind> together;
        for (const auto& family : {transmittance_kinds(), hillaire_kinds(), diffuse_kinds(),
                                   scattering_kinds(), frame_kinds(), habitat_kinds()}) {
            together.insert(together.end(), family.begin(), family.end());
        }
        return together;
    }();
    return all;
}

const Kind& kind_named(const std::string& name) {
    std::string names;
    for (const Kind& kind : kinds()) {
        if (kind.name == name) {
            return kind;
        }
        names += (names.empty() ? "" : ", ") + kind.name;
    }
    throw support::Error("there is no table '" + name + "': take one of " + names);
}

support::TableDescription describe(const Kind& kind, const Request& request) {
    support::TableWorld world =
        kind.world ? kind.world(request) : by_scene<double>(request.preset, [](auto scene, const auto& air) {
            return support::table_world<decltype(scene)>(air);
        });
    if (kind.has_orders) {
        world["orders"] = std::to_string(request.orders);
    }
    if (kind.of_frame) {
        world["eye_altitude"] = support::number_text(request.eye_altitude);
        world["sun_elevation"] = support::number_text(request.sun_elevation);
    }
    return support::TableDescription{kind.name,
                                     kind.mapping,
                                     kind.payload,
                                     kind.units,
                                     request.size.width,
                                     request.size.height,
                                     request.size.depth,
                                     kind.channels,
                                     kind.may_be_negative,
                                     "plain",
                                     world};
}

}  // namespace bake_tables
