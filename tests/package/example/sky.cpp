#include <airlight/airlight.hpp>
#include <cstdio>

int main() {
    using vec3 = airlight::vec3<float>;
    const auto earth = airlight::earth<float>();                                // metres
    const auto eye = airlight::Viewpoint<float>{2.0f, vec3(0.0f, 0.0f, 1.0f)};  // altitude, local up
    const auto to_sun = glm::normalize(vec3(1.0f, 0.0f, 0.5f));
    const auto north = glm::normalize(vec3(0.0f, 1.0f, 0.1f));
    const auto sky = airlight::single_scattering(earth, eye, north, to_sun, airlight::no_surface<float>());
    std::printf("radiance of the sky per unit of sunlight: %.4f %.4f %.4f 1/sr\n", sky.radiance.x,
                sky.radiance.y, sky.radiance.z);
    return sky.radiance.z > sky.radiance.x ? 0 : 1;  // the sky is blue
}
