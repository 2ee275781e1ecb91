#include "warnings.hpp"

#include <airlight/airlight.hpp>
#include <algorithm>
#include <cmath>
#include <sstream>

namespace advise {
namespace {

using Texts = std::vector<std::string>;

template <typename... Parts>
std::string text(const Parts&... parts) {
    std::ostringstream out;
    out.precision(3);
    (out << ... << parts);
    return out.str();
}

double largest(const Vector& v) {
    return std::max({v.x, v.y, v.z});
}

/// Straight up through a layer: the first figure to look at for a mistaken unit.
void add_depth(const std::string& layer, double coefficient, double thickness, Texts& out) {
    // The thickest airs that anyone renders let e^-20 through; a layer of less than a millionth adds
    // nothing that a picture of 16 bits shows.
    const double most = 20.0;
    const double least = 1e-6;
    const double depth = coefficient * thickness;
    if (depth > most) {
        out.push_back(
            text(layer, " has a vertical optical depth of ", depth,
                 ": are its coefficients per kilometre? Lengths are metres here; divide them by 1000"));
    }
    if (depth > 0 && depth < least) {
        out.push_back(text(layer, " has a vertical optical depth of ", depth,
                           ", too little to be seen: are its lengths kilometres? Multiply them by 1000"));
    }
}

/// The angle from the sun at which the aerosol's phase function has fallen to half its peak [degrees].
double peak_width(const Atmosphere& air, const Setting& setting) {
    const auto phase = [&](double degrees) {
        const double cosine = std::cos(degrees * airlight::pi<double> / 180.0);
        return setting.mie_phase == airlight::phase_henyey_greenstein
                   ? airlight::henyey_greenstein_phase(cosine, air.mie_g)
                   : airlight::cornette_shanks_phase(cosine, air.mie_g);
    };
    double low = 0;
    double high = 90;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (2.0 * phase(middle) > phase(0.0) ? low : high) = middle;
    }
    return low;
}

/// A stretch of altitudes.
struct Band {
    double low;
    double high;
};

Band altitudes_of(const Atmosphere& air, const airlight::AirRay<double>& ray) {
    const double end = airlight::altitude_along_ray(air.ground_radius, ray.altitude, ray.along, ray.extent);
    const bool passes_perigee = ray.along < 0 && ray.along + ray.extent > 0;
    return {std::max(passes_perigee ? ray.perigee_altitude : std::min(ray.altitude, end), 0.0),
            std::max(ray.altitude, end)};
}

/// Whether the sun stands over the horizon where a ray is lowest: elsewhere nodes may leave out what is dark.
bool lit_below(const Atmosphere& air, const View& view, const airlight::AirRay<double>& ray) {
    const double t = ray.begin + std::clamp(-ray.along, 0.0, ray.extent);
    const Vector from_centre = (air.ground_radius + view.eye.altitude) * view.eye.up + t * view.direction;
    return glm::dot(from_centre, view.to_sun) > 0;
}

/// Whether a view crosses most of a layer and no node lies in it.
bool falls_between(const Atmosphere& air, const View& view, const Band& layer,
                   const std::vector<Vector>& nodes) {
    const airlight::AirRay<double> ray = airlight::air_ray(air, view.eye, view.direction, view.distance);
    const Band seen = altitudes_of(air, ray);
    const double crossed = std::min(seen.high, layer.high) - std::max(seen.low, layer.low);
    if (!ray.in_air || crossed < 0.5 * (layer.high - layer.low) || !lit_below(air, view, ray)) {
        return false;
    }
    return std::none_of(nodes.begin(), nodes.end(), [&](const Vector& place) {
        const double altitude = airlight::viewpoint_from_surface(
                                    air.ground_radius, place + view.eye.altitude * view.eye.up, view.eye.up)
                                    .altitude;
        return altitude >= layer.low && altitude <= layer.high;
    });
}

/// The reference's own nodes: where even they leave a layer out, the measurement does not know of it.
void add_thin_layer(const std::string& name, const Band& layer, const Measured& measured, Texts& out) {
    Setting whole = measured.reference;
    whole.planet_shadow = false;  // the shadow would take nodes away
    std::size_t count = 0;
    for (const View& view : measured.views) {
        std::vector<Vector> nodes;
        evaluated(whole, measured.air, view, &nodes);
        count += falls_between(measured.air, view, layer, nodes) ? 1 : 0;
    }
    if (count > 0) {
        out.push_back(
            text(name, " is thinner than the spacing of ", whole.nodes, " nodes in ", count, " of ",
                 measured.views.size(), " views, none lies between ", layer.low, " and ", layer.high,
                 " m: do not trust the figures; make the layer higher, or march with steps shorter than it"));
    }
}

void add_half_float(const Measured& measured, Texts& out) {
    const double least = 6e-8;  // the smallest half float is 5.96e-8
    const double most = 65504;  // the largest
    std::size_t dim = 0;
    std::size_t bright = 0;
    std::size_t opaque = 0;
    double lost = 1;
    for (const Light& light : measured.light) {
        bool below = false;
        bool above = false;
        bool black = false;
        for (int k = 0; k < 3; ++k) {
            below = below || (light.radiance[k] > 0 && light.radiance[k] < least);
            above = above || light.radiance[k] > most;
            black = black || light.transmittance[k] < least;
            lost = std::min(lost, light.transmittance[k]);
        }
        dim += below ? 1 : 0;
        bright += above ? 1 : 0;
        opaque += black ? 1 : 0;
    }
    const auto of = text(" of ", measured.views.size(), " views");
    if (dim > 0) {
        out.push_back(
            text("radiance per unit of sunlight lies below 6e-8 in ", dim, of,
                 ", where a half float holds 0: multiply by irradiance and exposure before storing"));
    }
    if (bright > 0) {
        out.push_back(text("radiance lies above 65504 in ", bright, of,
                           ", where a half float holds infinity: expose before storing, or store floats"));
    }
    if (opaque > 0) {
        out.push_back(text("transmittance lies below 6e-8 in ", opaque, of,
                           lost > 0 ? text(", optical depths up to ", -std::log(lost)) : std::string(),
                           ": a half float holds 0 there"));
    }
}

}  // namespace

std::vector<std::string> warnings_of(const Atmosphere& air, const Setting& setting) {
    Texts out;
    const double aerosol = largest(air.mie_scattering + air.mie_absorption);
    const bool ozone = setting.ozone != airlight::ozone_none && largest(air.ozone_absorption) > 0;
    if (air.ground_radius < 100e3) {  // the smallest worlds with air, Triton and Pluto, have a thousand
        out.push_back(
            text("the ground's radius is ", air.ground_radius,
                 " m: is it kilometres? Multiply every length by 1000, divide coefficients by 1000"));
    }
    add_depth("the molecules' layer", largest(air.rayleigh_scattering), air.rayleigh_scale_height, out);
    add_depth("the aerosol's layer", aerosol, air.mie_scale_height, out);
    if (ozone) {
        add_depth("the ozone layer", largest(air.ozone_absorption), air.ozone_half_width, out);
    }
    for (const auto& [name, height] :
         {std::pair<const char*, double>{"rayleigh_scale_height", air.rayleigh_scale_height},
          {"mie_scale_height", air.mie_scale_height}}) {
        if (height > air.ground_radius) {
            out.push_back(text(name, " is ", height, " m, larger than the ground's radius of ",
                               air.ground_radius, " m: are the two in one unit?"));
        } else if (2.0 * height > air.top_altitude) {
            out.push_back(text(name, " is ", height, " m and the air ends at ", air.top_altitude,
                               " m: much of the layer is cut off; raise top_altitude to ten scale heights"));
        }
    }
    if (ozone && air.ozone_altitude > air.top_altitude) {
        out.push_back(text("ozone's centre at ", air.ozone_altitude, " m lies above the air's top at ",
                           air.top_altitude, " m: raise top_altitude, or set ozone_absorption = 0 0 0"));
    }
    if (largest(air.ground_albedo) > 1) {
        out.push_back("ground_albedo is larger than 1: the ground would make light");
    }
    // A sun is half a degree wide and airlight's is a point: a peak not much wider shows that.
    if (setting.mie_phase != airlight::phase_fog && aerosol > 0 && peak_width(air, setting) < 2.0) {
        out.push_back(text("mie_g = ", air.mie_g, " is close to 1: the aerosol's light falls to half within ",
                           peak_width(air, setting),
                           " degrees of the sun; expect single pixels of it, and blur or lower mie_g"));
    }
    return out;
}

std::vector<std::string> warnings_of(const Atmosphere& air, const Ranges& ranges) {
    Texts out;
    if (ranges.height.low < 0) {
        out.push_back(text("the lowest camera is ", -ranges.height.low,
                           " m under ground; it counts as standing on it"));
    }
    const double dip = horizon_dip(air, ranges.height.high);
    if (ranges.sun.high < -dip) {
        out.push_back(text("the sun is below every camera's horizon (", -dip,
                           " degrees for the highest): what light there is was scattered more than once"));
    }
    return out;
}

std::vector<std::string> warnings_of(const Measured& measured) {
    Texts out;
    const Atmosphere& air = measured.air;
    std::size_t dark = 0;
    for (const Light& light : measured.light) {
        dark += airlight::luminance(light.radiance) < measured.floor ? 1 : 0;
    }
    if (2 * dark > measured.views.size()) {
        out.push_back(
            text(dark, " of ", measured.views.size(),
                 " views are darker than a ten thousandth of the zenith at noon: changes there count "
                 "for little"));
    }
    add_half_float(measured, out);
    if (largest(air.mie_scattering) > 0) {
        add_thin_layer("the aerosol's layer", {0.0, air.mie_scale_height}, measured, out);
    }
    if (largest(air.rayleigh_scattering) > 0) {
        add_thin_layer("the molecules' layer", {0.0, air.rayleigh_scale_height}, measured, out);
    }
    // Ozone scatters nothing: its column comes in closed form, wherever the nodes lie.
    return out;
}

}  // namespace advise
