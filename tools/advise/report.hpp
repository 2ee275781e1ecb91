#pragma once

// The report as text, and the whole run from ranges to advice.

#include <string>
#include <vector>

#include "advice.hpp"
#include "atmosphere_file.hpp"
#include "sampling.hpp"

namespace advise {

/// What is asked.
struct Question {
    std::string air_name;  ///< the preset's or the file's
    Air air;
    int mie_phase = airlight::phase_cornette_shanks;
    Ranges ranges;
    double tolerance = 0.01;  ///< share
    By by = By::worst;
    int views = 800;
    std::uint64_t seed = 1;
};

/// What is answered.
struct Answer {
    std::size_t views = 0;
    Advice advice;
    std::vector<std::string> warnings;
};

/// Steps of the march that the reference is held against.
constexpr int doubt_steps = 2048;

/// Throws support::Error where the ranges show no air at all.
Answer answered(const Question& question, const std::function<void(double)>& progress);

/// The report, in lines that a terminal holds.
std::string report(const Question& question, const Answer& answer);

/// Two lines for the head of a written file: the question and the change.
std::string summary(const Question& question, const Answer& answer);

/// A share as per cent with two digits that count: 0.000314 is 0.031.
std::string percent(double share);

}  // namespace advise
