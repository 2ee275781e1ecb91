#pragma once

inline int outside() { return 1; }
