// Numbers for people.
#pragma once

#include <string>

namespace cutaway::load {

/// Three digits where they say something: 1234, 12.3, 1.23, 0.012; whole numbers as such.
std::string figure(double value);
/// "12.3 ms"; the number alone where the unit is empty.
std::string figure(double value, const char* unit);

}  // namespace cutaway::load
