#include "evaluate.hpp"

namespace study {

template const std::vector<Place<float>>& places<float>();
template std::vector<airlight::Scattered<float>> evaluated<float>(const Setting&, const Place<float>&,
                                                                  const std::vector<Ray<float>>&);

}  // namespace study
