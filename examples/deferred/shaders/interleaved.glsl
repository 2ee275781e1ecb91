// Every number from 1/32 to 31/32 in steps of a sixteenth once in each 4 x 4 pixels: together they look sixteen
// times as often as each does.
float interleaved(ivec2 pixel) {
    ivec2 p = pixel & 3;
    int fine = ((p.x ^ p.y) & 1) * 2 + (p.y & 1);
    int coarse = (((p.x >> 1) ^ (p.y >> 1)) & 1) * 2 + ((p.y >> 1) & 1);
    return (float(fine * 4 + coarse) + 0.5) / 16.0;
}
