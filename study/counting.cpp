// The operations that a ray takes. A file of its own: it includes the counting scalar before airlight.

#include "counted.hpp"

#include "counting.hpp"

namespace study {

Operations operations(const Setting& setting, const std::vector<View>& views) {
    // The tables are filled before, so that their own operations are not counted.
    const std::vector<Place<Counted>>& all = places<Counted>();
    std::vector<std::vector<Ray<Counted>>> rays(all.size());
    for (const View& view : views) {
        rays[view.world].push_back(converted<Counted>(view.ray));
    }
    counts() = Counts{};
    for (std::size_t world = 0; world < all.size(); ++world) {
        evaluated(setting, all[world], rays[world]);
    }
    const double count = views.empty() ? 1.0 : static_cast<double>(views.size());
    return {counts().exponentials / count, counts().roots / count, counts().divisions / count};
}

}  // namespace study
