#pragma once

#include <string>

namespace support {

/// The processor as the system calls it, or "an unnamed processor".
std::string processor_name();

}  // namespace support
