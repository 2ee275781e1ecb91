#pragma once

#include <vector>

namespace image {

/// How different two pictures look to someone who flips between them, for each pixel: 0 the same, 1 as
/// different as can be. Both are linear sRGB in [0, 1], 3 per pixel.
///
/// `pixels_per_degree`: 67 is a screen of 0.7 m and 3840 pixels at arm's length.
/// Source: FLIP for pictures of low dynamic range: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom,
///         Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM CGIT 3(2), 2020.
std::vector<float> flip_difference(const std::vector<float>& reference, const std::vector<float>& test,
                                   int width, int height, double pixels_per_degree = 67);

}  // namespace image
