#pragma once

// The methods and settings that are compared, in any scalar type.

#include <airlight/airlight.hpp>
#include <string>
#include <vector>

#include "texture.hpp"
#include "views.hpp"
#include "worlds.hpp"

namespace study {

enum class Method { nodes, marched, leenman, cs562, double_loop, hillaire, schueler, hdrp };

/// A method and its numbers.
struct Setting {
    Method method;
    int steps;
    int sun_steps;  ///< 0 where the method has none to choose

    bool operator==(const Setting& other) const {
        return method == other.method && steps == other.steps && sun_steps == other.sun_steps;
    }
};

std::string name_of(Method method);     ///< in the CSVs
std::string title_of(Method method);    ///< in a sentence
std::string text_of(const Setting& s);  ///< its numbers, such as 16x6

/// All settings, each method's from cheap to dear.
const std::vector<Setting>& settings();

/// What CPU time is compared with: Leenman's 16 by 6.
Setting yardstick();

/// A world as the methods take it, in one scalar type.
template <typename T>
struct Place {
    airlight::Atmosphere<T> air;
    int ozone;
    Texture<T> cs562;     ///< 256 by 256
    Texture<T> hillaire;  ///< 256 by 64
};

/// All worlds. The tables are filled once, in double.
template <typename T>
const std::vector<Place<T>>& places();

/// Every ray's radiance and transmittance by one setting. For float, double and Counted.
template <typename T>
std::vector<airlight::Scattered<T>> evaluated(const Setting& setting, const Place<T>& place,
                                              const std::vector<Ray<T>>& rays);

}  // namespace study
