#include "flip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <airlight/constants.hpp>
#include <glm/glm.hpp>

namespace image {
namespace {

using glm::dvec3;
constexpr double pi = airlight::pi<double>;

// Linear sRGB to XYZ and back; white is (1, 1, 1).
const glm::dmat3 to_xyz =
    glm::transpose(glm::dmat3(0.41239080, 0.35758434, 0.18048079, 0.21263901, 0.71516868, 0.07219232,
                              0.01933082, 0.11919478, 0.95053215));
const dvec3 white = to_xyz * dvec3(1);

/// A picture with numbers of any meaning.
struct Plane {
    int width;
    int height;
    std::vector<dvec3> pixels;

    /// What lies outside is as the edge.
    const dvec3& at(int x, int y) const {
        x = std::clamp(x, 0, width - 1);
        y = std::clamp(y, 0, height - 1);
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

template <typename Change>
Plane changed(Plane plane, const Change& change) {
    for (dvec3& pixel : plane.pixels) {
        pixel = change(pixel);
    }
    return plane;
}

/// Weights for each channel by their places, -radius to radius each way.
struct Kernel {
    int radius;
    std::vector<dvec3> weights;
};

template <typename Weight>
Kernel kernel_of(int radius, const Weight& weight) {
    Kernel kernel{radius, {}};
    for (int y = -radius; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            kernel.weights.push_back(weight(double(x), double(y)));
        }
    }
    // Positive weights add up to 1; so do negative ones, without their sign.
    dvec3 positive(0);
    dvec3 negative(0);
    for (const dvec3& w : kernel.weights) {
        positive += glm::max(w, dvec3(0));
        negative -= glm::min(w, dvec3(0));
    }
    for (dvec3& w : kernel.weights) {
        for (int c = 0; c < 3; ++c) {
            w[c] /= w[c] > 0 ? positive[c] : negative[c] > 0 ? negative[c] : 1;
        }
    }
    return kernel;
}

Plane convolved(const Plane& plane, const Kernel& kernel) {
    Plane out{plane.width, plane.height, {}};
    out.pixels.reserve(plane.pixels.size());
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x) {
            dvec3 sum(0);
            std::size_t i = 0;
            for (int dy = -kernel.radius; dy <= kernel.radius; ++dy) {
                for (int dx = -kernel.radius; dx <= kernel.radius; ++dx) {
                    sum += kernel.weights[i++] * plane.at(x + dx, y + dy);
                }
            }
            out.pixels.push_back(sum);
        }
    }
    return out;
}

/// Linear opponent colours: light, red against green, yellow against blue.
dvec3 opponents(const dvec3& rgb) {
    const dvec3 p = to_xyz * rgb / white;
    return dvec3(116 * p.y - 16, 500 * (p.x - p.y), 200 * (p.y - p.z));
}

dvec3 rgb_of_opponents(const dvec3& v) {
    const double y = (v.x + 16) / 116;
    return glm::inverse(to_xyz) * (dvec3(v.y / 500 + y, y, y - v.z / 200) * white);
}

/// CIELAB, its colours fainter in the dark after Hunt.
dvec3 lab_after_hunt(const dvec3& rgb) {
    const dvec3 p = to_xyz * rgb / white;
    const auto f = [](double t) {
        const double d = 6.0 / 29;
        return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
    };
    const double lightness = 116 * f(p.y) - 16;
    return dvec3(lightness, 0.01 * lightness * 500 * (f(p.x) - f(p.y)),
                 0.01 * lightness * 200 * (f(p.y) - f(p.z)));
}

/// Distances of colours as they are seen when large: HyAB, to the power of 0.7.
double color_distance(const dvec3& a, const dvec3& b) {
    return std::pow(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), 0.7);
}

/// To [0, 1]: up to 0.4 of the largest distance takes 0.95 of the range.
double color_difference(const dvec3& a, const dvec3& b) {
    static const double largest =
        color_distance(lab_after_hunt(dvec3(0, 1, 0)), lab_after_hunt(dvec3(0, 0, 1)));
    const double distance = color_distance(a, b);
    const double knee = 0.4 * largest;
    return distance < knee ? distance * 0.95 / knee : 0.95 + 0.05 * (distance - knee) / (largest - knee);
}

/// What the eye resolves: its contrast sensitivity as Gaussians, of light, red-green and blue-yellow.
Kernel eye_kernel(double pixels_per_degree) {
    const auto bell = [](double square, double a, double b) {
        return a * std::sqrt(pi / b) * std::exp(-pi * pi * square / b);
    };
    const double widest = 0.04;
    return kernel_of(int(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree)),
                     [&](double x, double y) {
                         const double s = (x * x + y * y) / (pixels_per_degree * pixels_per_degree);
                         return dvec3(bell(s, 1, 0.0047), bell(s, 1, 0.0053),
                                      bell(s, 34.1, widest) + bell(s, 13.5, 0.025));
                     });
}

/// How strong edges (x) and points (y) are.
Plane features(const Plane& opponent, double pixels_per_degree) {
    const Plane light = changed(opponent, [](const dvec3& v) { return dvec3((v.x + 16) / 116); });
    const double sigma = 0.5 * 0.082 * pixels_per_degree;  // half of an edge's width of 0.082 degrees
    const int radius = int(std::ceil(3 * sigma));
    // x: first derivative of a Gaussian, y: second, z: unused.
    const auto derivatives = [&](double along, double across) {
        const double bell = std::exp(-(along * along + across * across) / (2 * sigma * sigma));
        return dvec3(-along * bell, (along * along / (sigma * sigma) - 1) * bell, 0);
    };
    const Plane across =
        convolved(light, kernel_of(radius, [&](double x, double y) { return derivatives(x, y); }));
    Plane found = convolved(light, kernel_of(radius, [&](double x, double y) { return derivatives(y, x); }));
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
        const dvec3& a = across.pixels[i];
        dvec3& b = found.pixels[i];
        b = dvec3(std::hypot(a.x, b.x), std::hypot(a.y, b.y), 0);
    }
    return found;
}

Plane plane_of(const std::vector<float>& rgb, int width, int height) {
    Plane plane{width, height, {}};
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        plane.pixels.push_back(opponents(dvec3(rgb[i], rgb[i + 1], rgb[i + 2])));
    }
    return plane;
}

Plane seen_colors(const Plane& opponent, const Kernel& eye) {
    return changed(convolved(opponent, eye), [](const dvec3& v) {
        return lab_after_hunt(glm::clamp(rgb_of_opponents(v), dvec3(0), dvec3(1)));
    });
}

}  // namespace

std::vector<float> flip_difference(const std::vector<float>& reference, const std::vector<float>& test,
                                   int width, int height, double pixels_per_degree) {
    const Plane a = plane_of(reference, width, height);
    const Plane b = plane_of(test, width, height);
    const Kernel eye = eye_kernel(pixels_per_degree);
    const Plane color_a = seen_colors(a, eye);
    const Plane color_b = seen_colors(b, eye);
    const Plane feature_a = features(a, pixels_per_degree);
    const Plane feature_b = features(b, pixels_per_degree);
    std::vector<float> difference;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const dvec3 apart = glm::abs(feature_a.pixels[i] - feature_b.pixels[i]);
        const double feature = std::sqrt(std::max(apart.x, apart.y) / std::sqrt(2.0));
        const double color = color_difference(color_a.pixels[i], color_b.pixels[i]);
        difference.push_back(float(std::pow(color, 1 - std::min(feature, 1.0))));
    }
    return difference;
}

}  // namespace image
