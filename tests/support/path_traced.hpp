#pragma once

// The path tracer's 66 views of the library's Earth, order by order: what tables of scattered light are
// judged by.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "angles.hpp"
#include "table.hpp"

namespace airlight_test {

/// One view in one channel; the orders of the table are sums up to the twelfth and the rest.
struct PathTraced {
    double altitude;
    double sun_elevation;  ///< [degrees]
    double elevation;      ///< [degrees] of the view
    double azimuth;        ///< [degrees] of the view, from the sun's
    int channel;
    double total;
    double total_error;             ///< standard error of the total
    std::array<double, 12> orders;  ///< [0] is light scattered once

    template <typename T>
    Viewpoint<T> eye() const {
        return standing(T(altitude));
    }
    template <typename T>
    vec3<T> direction() const {
        return slope<T>(elevation, azimuth);
    }
    template <typename T>
    vec3<T> to_sun() const {
        return slope<T>(sun_elevation);
    }
    /// Orders first to last, counted from 1.
    double sum_of_orders(int first, int last) const {
        double sum = 0;
        for (int order = first; order <= last; ++order) {
            sum += orders[static_cast<std::size_t>(order - 1)];
        }
        return sum;
    }
};

/// The rows of reference/data/earth.csv.
inline std::vector<PathTraced> read_path_traced(const std::string& path) {
    std::vector<PathTraced> views;
    for (const Row& row : read_table(path)) {
        const auto number = [&](const std::string& column) {
            return static_cast<double>(row.expected(column));
        };
        PathTraced view{number("altitude"),
                        number("sun_elevation"),
                        number("elevation"),
                        number("azimuth"),
                        static_cast<int>(number("channel")),
                        number("total"),
                        number("total_error"),
                        {}};
        for (int order = 1; order <= 12; ++order) {
            view.orders[static_cast<std::size_t>(order - 1)] =
                number("order_" + std::to_string(order) + (order == 12 ? "_and_more" : ""));
        }
        views.push_back(view);
    }
    return views;
}

/// The three kinds of sun that errors are stated for.
struct SunClass {
    const char* name;
    double above;  ///< [degrees] elevation, exclusive
    double up_to;  ///< [degrees] inclusive
    bool holds(const PathTraced& view) const {
        return view.sun_elevation > above && view.sun_elevation <= up_to;
    }
};

inline constexpr SunClass sun_classes[3] = {
    {"sun above the horizon", 0, 90}, {"0 to -6 degrees", -6.5, 0}, {"below -6 degrees", -90, -6.5}};

}  // namespace airlight_test
