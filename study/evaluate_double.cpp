#include "evaluate.hpp"

namespace study {

template const std::vector<Place<double>>& places<double>();
template std::vector<airlight::Scattered<double>> evaluated<double>(const Setting&, const Place<double>&,
                                                                    const std::vector<Ray<double>>&);

}  // namespace study
