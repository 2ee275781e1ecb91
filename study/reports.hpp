#pragma once

// The tables of the study, as they are written to study/results.

#include "cost.hpp"
#include "csv.hpp"
#include "errors.hpp"

namespace study {

/// errors.csv: each setting's errors over the suite, over the random rays, and in each world.
Csv error_table(const std::vector<Setting>& settings, const Judged& suite, const Judged& random);

/// views.csv: each view of the suite, its true luminance, and some settings' errors in it.
Csv view_table(const Judged& suite);

/// classes.csv: the node method's errors by place of the eye, kind of air and sun elevation.
Csv class_table(const std::vector<Setting>& settings, const Judged& views);

/// quick.csv: each setting's errors over a tenth of the suite, with all digits that say something.
Csv quick_table(const std::vector<Setting>& settings, const Progress& progress);

/// cost.csv.
Csv cost_table(const std::vector<Setting>& settings, const std::vector<Cost>& costs);

/// Which figures of a fresh quick table are not the recorded ones; empty when all are.
std::vector<std::string> differences(const Csv& fresh, const Csv& recorded);

}  // namespace study
