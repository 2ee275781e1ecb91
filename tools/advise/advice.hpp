#pragma once

// Which terms and how many nodes a scene needs.

#include <functional>
#include <string>
#include <vector>

#include "measure.hpp"

namespace advise {

/// Which of a change's figures has to stay within the tolerance.
enum class By { worst, p95 };

double judged(const Change& change, By by);

/// What the terms are called.
inline constexpr const char* mie_name = "aerosol (mie)";
inline constexpr const char* ozone_name = "ozone";
inline constexpr const char* shadow_name = "planet's shadow";
inline constexpr const char* curvature_name = "curvature";
inline constexpr const char* top_name = "the air's top";

/// What a term is worth: the change of the views without it.
struct Contribution {
    std::string name;
    Change change;
    bool has_flag;  ///< a Scene can leave it out
    bool left_out;  ///< by the advice
};

struct NodeCost {
    int nodes;
    Change change;  ///< with every term on
};

struct Advice {
    double tolerance;  ///< share
    By by;
    Change doubt;  ///< of the reference itself
    std::vector<Contribution> terms;
    std::vector<NodeCost> nodes;
    /// All that stays within the tolerance by itself, taken together.
    Setting each;
    Change each_change;
    /// What is recommended, and what it changes.
    Setting setting;
    Change change;
};

/// How much work a setting is: nodes times the layers that each of them integrates.
int work_of(const Setting& setting);

/// Measures every term and every number of nodes, then every combination of them, and recommends of those
/// within the tolerance the one of least work; of two alike the one without the planet's shadow.
/// `progress` gets the share that is done.
Advice advised(const Measured& measured, double tolerance, By by, int doubt_steps,
               const std::function<void(double)>& progress);

}  // namespace advise
