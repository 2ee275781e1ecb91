// What the passes of tables made order by order have in common: where a texel is, and how a table is read.
// BAKE_THREE_DIMENSIONS or BAKE_FOUR_DIMENSIONS says which table it is.

uniform int altitudes;
uniform int views;
uniform int suns;
uniform int nus;

airlight_ScatteringPoint point_of(vec3 uvw) {
    float lowest = airlight_lowest_sun_cosine(atmosphere);
#ifdef BAKE_FOUR_DIMENSIONS
    airlight_ScatteringPoint p = airlight_scattering_parameters(atmosphere, uvw, lowest, nus, suns, views, altitudes);
    p.nu = airlight_possible_nu(p.mu, p.mu_s, p.nu);
    return p;
#else
    airlight_AltitudeViewSun p = airlight_inscatter_parameters(atmosphere, uvw, lowest, altitudes, views, suns);
    return airlight_ScatteringPoint(p.altitude, p.mu, p.mu_s, p.mu * p.mu_s, p.reaches_ground);
#endif
}

vec3 read_table(sampler3D table_read, float altitude, float mu, float mu_s, float nu, bool reaches_ground) {
    float lowest = airlight_lowest_sun_cosine(atmosphere);
#ifdef BAKE_FOUR_DIMENSIONS
    airlight_ScatteringLookup at = airlight_scattering_lookup(atmosphere, altitude, mu, mu_s, nu, reaches_ground,
                                                              lowest, nus, suns, views, altitudes);
    return textureLod(table_read, at.first, 0.0).rgb * (1.0 - at.weight) +
           textureLod(table_read, at.second, 0.0).rgb * at.weight;
#else
    vec3 at = airlight_inscatter_uvw(atmosphere, altitude, mu, mu_s, reaches_ground, lowest, altitudes, views, suns);
    return textureLod(table_read, at, 0.0).rgb;
#endif
}
