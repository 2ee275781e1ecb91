#include "counted.hpp"

#include "evaluate.hpp"

namespace study {

template const std::vector<Place<Counted>>& places<Counted>();
template std::vector<airlight::Scattered<Counted>> evaluated<Counted>(const Setting&, const Place<Counted>&,
                                                                      const std::vector<Ray<Counted>>&);

}  // namespace study
