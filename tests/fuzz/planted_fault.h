// A fault to be found: with CUTAWAY_PLANTED_FAULT each target has one behind what it judges, and a
// run that does not find it within a minute says that its other silence means little.
#pragma once

#include <cstdio>
#include <vector>

namespace cutaway::fuzz {

/// Writes behind an allocation where `reached`, if faults are planted.
inline void planted_fault([[maybe_unused]] bool reached) {
#ifdef CUTAWAY_PLANTED_FAULT
  if (!reached) return;
  std::fputs("the planted fault\n", stderr);
  std::vector<char> one(1);
  volatile char* behind = one.data() + 1;
  *behind = 1;
#endif
}

}  // namespace cutaway::fuzz
