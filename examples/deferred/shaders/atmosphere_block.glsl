// The air of the picture's world, for shaders that read no table of it.
#include "airlight/atmosphere.glsl"

layout(std140) uniform AtmosphereBlock {
    airlight_Atmosphere atmosphere;
};
