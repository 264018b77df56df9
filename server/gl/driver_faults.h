// What has to be kept from drivers that are known to break at it.
#pragma once

namespace cutaway::gl {

/// Before the first display is asked for: the drivers read their environment then. Mesa 22.3 with
/// LLVM 15 overwrites the heap where LP_NATIVE_VECTOR_WIDTH asks its software renderer for vectors
/// under 256 bits on a processor with AVX-512: it takes AVX from what it knows of the processor but
/// still compiles for AVX-512. There AVX-512 is taken away, too; at 0 it breaks on any processor.
/// A processor that has no AVX gets 128 bits by itself, and those work.
void work_around_driver_faults();

}  // namespace cutaway::gl
