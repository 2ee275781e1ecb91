#include "row.hpp"

namespace parity {

std::vector<Row>& all_rows() {
    static std::vector<Row> rows;
    return rows;
}

}  // namespace parity
