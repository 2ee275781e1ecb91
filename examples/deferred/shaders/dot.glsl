// The inner product added from x to z, as GLM adds it, in place of the built-in, which may add in any order
// (Mesa starts with z). Only for the sake of the comparison with C++: the last digit of a ray's direction
// moves its closest approach to the planet by 40 cm seen from an orbit, and near the edge of the planet's
// shadow or the top of the air that shows.
float dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
