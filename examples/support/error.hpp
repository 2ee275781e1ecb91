#pragma once

#include <stdexcept>

namespace support {

/// What went wrong and what to do about it, in one line. A program prints it and exits with 1.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace support
