// Light from all sides while it is added up: GatheredLight in twelve layers, before it is packed.

airlight_GatheredLight fetch_light(sampler2DArray light, ivec2 at) {
    vec3 f[12];
    for (int k = 0; k < 12; ++k) {
        f[k] = texelFetch(light, ivec3(at, k), 0).rgb;
    }
    return airlight_GatheredLight(airlight_DiffuseLight(f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8]),
                                  airlight_SkyIrradiance(f[9], f[10], f[11]));
}

void store_light(airlight_GatheredLight light) {
    vec3 f[12] = vec3[12](light.light.mean, light.light.vertical, light.light.slanted, light.light.across,
                          light.light.aerosol_up, light.light.aerosol_down, light.light.aerosol_sunward,
                          light.light.aerosol_away, light.light.aerosol_aside, light.irradiance.down,
                          light.irradiance.up, light.irradiance.sunward);
    for (int k = 0; k < 12; ++k) {
        imageStore(table, ivec3(texel_at.xy, k), vec4(f[k], 0.0));
    }
}
