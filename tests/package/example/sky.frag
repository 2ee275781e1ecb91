#version 430 core
#extension GL_GOOGLE_include_directive : require
#include "airlight.glsl"

in vec3 view;            // from the eye through this pixel
uniform vec3 up;         // away from the planet's centre, at the eye
uniform float altitude;  // [m]
uniform vec3 to_sun;
out vec4 pixel;

void main() {
    airlight_Viewpoint eye = airlight_Viewpoint(altitude, up);
    airlight_Scattered sky = airlight_single_scattering(airlight_earth(), eye, normalize(view), to_sun,
                                                        airlight_no_surface());
    vec3 radiance = airlight_compose(vec3(0.0), sky, vec3(20.0));  // nothing behind the air; the sun's irradiance
    pixel = vec4(airlight_srgb_from_linear(airlight_exposed(radiance, 1.0)), 1.0);
}
