// Inlining of the kernels' building blocks: always, in debug builds too, so that no function
// compiled for one instruction set is left over as a symbol that the linker could share with code
// for another.
#pragma once

#define GONIO_INLINE __attribute__((always_inline)) inline
